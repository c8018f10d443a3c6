within HRG;
package UsersGuide "What the library is for, and how to read it"
  annotation (DocumentationClass = true, Documentation(info="<html>
<p>Overview, Conventions, Fidelities, Mechanisms and References: five pages, in this order. Then open <code>HRG.Examples</code>.</p>
</html>"));
end UsersGuide;
