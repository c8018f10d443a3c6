within HRG;
package UsersGuide "What the library is for, and how to read it"
  annotation (DocumentationClass = true, Documentation(info="<html>
<p>Overview, Conventions, Fidelities and References: four pages, in this order. Then open <code>HRG.Examples</code>.</p>
</html>"));
end UsersGuide;
