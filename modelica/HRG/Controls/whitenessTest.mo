within HRG.Controls;
function whitenessTest "Sums over normalised innovations, by which one tells whether they are white"
  input Real before[7] "{sum, sum of squares and number in the present window; sum over windows of quotients squared, number of windows; number of innovations, of limited ones}";
  input Real innovation "Over its standard deviation, limited to three";
  input Real used "1; 0 if there is no innovation";
  output Real result[7] "The same with the innovation";
protected
  Real windowEnds "1 with the last innovation of a window";
algorithm
  result[1] := before[1] + used*innovation;
  result[2] := before[2] + used*innovation*innovation;
  result[3] := before[3] + used;
  windowEnds := if result[3] > 11.5 and result[2] > 0 then 1 else 0;
  result[4] := before[4] + (if windowEnds > 0.5 then result[1]*result[1]/result[2] else 0);
  result[5] := before[5] + windowEnds;
  result[1] := (1 - windowEnds)*result[1];
  result[2] := (1 - windowEnds)*result[2];
  result[3] := (1 - windowEnds)*result[3];
  result[6] := before[6] + used;
  result[7] := before[7] + (if innovation*innovation > 8.999 then used else 0);
  annotation (Documentation(info="<html>
<p>The sum of twelve innovations, a minute of rows, over the root of their sum of squares. If they are white its square has the mean 1, and a burst counts no more than a quiet window
(docs/methods/witness.md).</p>
</html>"));
end whitenessTest;
