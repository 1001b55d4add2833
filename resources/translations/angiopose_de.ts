<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>angiopose::app::AuxiliaryController</name>
    <message>
        <source>Nothing is chosen: AngioPose takes all branches alike. Chosen ones decide what they can tell, the others hold the rest.</source>
        <translation>Nichts gewählt: AngioPose nimmt alle Äste gleich. Gewählte entscheiden, was sie sagen können, die anderen halten den Rest.</translation>
    </message>
    <message>
        <source>%1 AngioPose lets them decide what they can tell, the other branches hold the rest; the result says what the fit of all was. While the fit is in doubt, poses found from these alone are tried, too.</source>
        <translation>%1 Bei AngioPose entscheiden sie, was sie sagen können, die anderen Äste halten den Rest; das Ergebnis sagt, wie die Anpassung aller war. Solange die Anpassung fraglich ist, werden auch Lagen aus diesen allein versucht.</translation>
    </message>
    <message>
        <source>Change method to %1</source>
        <translation>Methode %1 wählen</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>Kippung</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>sideways</source>
        <translation>seitlich</translation>
    </message>
    <message>
        <source>up–down</source>
        <translation>auf–ab</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>No branch lies mostly inside the lasso.</source>
        <translation>Kein Ast liegt großteils im Lasso.</translation>
    </message>
    <message>
        <source>This tree knows no generations.</source>
        <translation>Dieser Gefäßbaum kennt keine Generationen.</translation>
    </message>
    <message>
        <source>No branch is that wide.</source>
        <translation>Kein Ast ist so weit.</translation>
    </message>
    <message>
        <source>Nothing is chosen: the alternation takes the %1 nodes of the tree.</source>
        <translation>Nichts gewählt: der Wechsel nimmt die %1 Knoten des Gefäßbaums.</translation>
    </message>
    <message>
        <source>Chosen: %1 (%2 mm, %3 % of the tree).</source>
        <translation>Gewählt: %1 (%2 mm, %3 % des Gefäßbaums).</translation>
    </message>
    <message>
        <source>%1 The method chosen now does not alternate and takes all branches.</source>
        <translation>%1 Die gewählte Methode wechselt nicht und nimmt alle Äste.</translation>
    </message>
    <message>
        <source>%1 The option “Auxiliary points” of the method overrules this.</source>
        <translation>%1 Die Option „Hilfspunkte“ der Methode geht vor.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::BlindTrialController</name>
    <message>
        <source>A trial needs vessels, an angiogram and a start pose, and no registration running.</source>
        <translation>Ein Versuch braucht Gefäße, Angiogramm und Startlage, und keine laufende Registrierung.</translation>
    </message>
    <message>
        <source>Blind trial</source>
        <translation>Blindversuch</translation>
    </message>
    <message>
        <source>%1, blind</source>
        <translation>%1, blind</translation>
    </message>
    <message>
        <source>Blind trial, seed %1, %2 s, %3 edits</source>
        <translation>Blindversuch, Startwert %1, %2 s, %3 Änderungen</translation>
    </message>
    <message>
        <source>Keep a blind trial</source>
        <translation>Blindversuch behalten</translation>
    </message>
</context>
<context>
    <name>angiopose::app::BranchController</name>
    <message>
        <source>Select a branch first: click it in the list or in a view.</source>
        <translation>Zuerst einen Ast wählen: in der Liste oder in einer Ansicht anklicken.</translation>
    </message>
    <message>
        <source>Excluded branches cannot be auxiliary. Include them first (X).</source>
        <translation>Ausgeschlossene Äste können keine Hilfsäste sein. Zuerst einschließen (X).</translation>
    </message>
    <message>
        <source>Choose auxiliary branches</source>
        <translation>Hilfsäste wählen</translation>
    </message>
    <message>
        <source>At least one branch has to stay.</source>
        <translation>Mindestens ein Ast muss bleiben.</translation>
    </message>
    <message>
        <source>Exclude %1</source>
        <translation>%1 ausschließen</translation>
    </message>
    <message>
        <source>Include %1</source>
        <translation>%1 einschließen</translation>
    </message>
    <message>
        <source>No branch lies wholly in view. Zoom out or move the image.</source>
        <translation>Kein Ast liegt ganz im Blickfeld. Verkleinern oder Bild verschieben.</translation>
    </message>
    <message>
        <source>This tree knows no radii.</source>
        <translation>Dieser Gefäßbaum kennt keine Radien.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::BranchWords</name>
    <message>
        <source>%1 branches</source>
        <translation>%1 Äste</translation>
    </message>
</context>
<context>
    <name>angiopose::app::CaseController</name>
    <message>
        <source>A registration is running. Stop it to edit.</source>
        <translation>Eine Registrierung läuft. Zum Bearbeiten anhalten.</translation>
    </message>
    <message>
        <source>Vessels cannot be traced</source>
        <translation>Gefäße lassen sich nicht erfassen</translation>
    </message>
    <message>
        <source>Support bundle written: %1</source>
        <translation>Supportpaket geschrieben: %1</translation>
    </message>
    <message>
        <source>Could not save the support bundle</source>
        <translation>Supportpaket konnte nicht gespeichert werden</translation>
    </message>
</context>
<context>
    <name>angiopose::app::CaseReport</name>
    <message>
        <source>Found</source>
        <translation>Gefunden</translation>
    </message>
    <message>
        <source>Median distance</source>
        <translation>Median des Abstands</translation>
    </message>
    <message>
        <source>%1 mm (%2 px)</source>
        <translation>%1 mm (%2 px)</translation>
    </message>
    <message>
        <source>Traced vessels covered</source>
        <translation>Erkannte Gefäße abgedeckt</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>none: this is the start pose</source>
        <translation>keine: dies ist die Startlage</translation>
    </message>
    <message>
        <source>Found in</source>
        <translation>Gefunden in</translation>
    </message>
    <message>
        <source>frame %1; picture and figures are of frame %2</source>
        <translation>Bild %1; Ansicht und Zahlen sind von Bild %2</translation>
    </message>
    <message>
        <source>pose set by hand</source>
        <translation>Lage von Hand gesetzt</translation>
    </message>
    <message>
        <source>edited by hand</source>
        <translation>von Hand bearbeitet</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>%1 mm median · %2 mm long</source>
        <translation>Median %1 mm · %2 mm lang</translation>
    </message>
    <message>
        <source>The %1 worst of %2 branches</source>
        <translation>Die %1 schlechtesten von %2 Ästen</translation>
    </message>
    <message>
        <source>Branches, the worst first</source>
        <translation>Äste, der schlechteste zuerst</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometrie</translation>
    </message>
    <message>
        <source>Pose: camera from patient, mm</source>
        <translation>Lage: Kamera aus Patient, mm</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>Gefäße</translation>
    </message>
    <message>
        <source>Angiogram</source>
        <translation>Angiogramm</translation>
    </message>
    <message>
        <source>Traced vessels</source>
        <translation>Erkannte Gefäße</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Erstellt</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Eingaben</translation>
    </message>
    <message>
        <source>Signature</source>
        <translation>Unterschrift</translation>
    </message>
    <message>
        <source>Measured in the image</source>
        <translation>Im Bild gemessen</translation>
    </message>
    <message>
        <source>, narrowest %1 mm (−%2 %)</source>
        <translation>, engste Stelle %1 mm (−%2 %)</translation>
    </message>
    <message>
        <source>Check points and rings</source>
        <translation>Prüfpunkte und Ringe</translation>
    </message>
    <message>
        <source>traced from a lumen mask edited by hand</source>
        <translation>aus einer von Hand bearbeiteten Gefäßmaske erfasst</translation>
    </message>
    <message>
        <source>Lumen mask</source>
        <translation>Gefäßmaske</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Scan</translation>
    </message>
    <message>
        <source>Before: start pose</source>
        <translation>Vorher: Startlage</translation>
    </message>
    <message>
        <source>After: registered</source>
        <translation>Nachher: registriert</translation>
    </message>
    <message>
        <source>After: pose set by hand</source>
        <translation>Nachher: Lage von Hand gesetzt</translation>
    </message>
    <message>
        <source>Colours: distance of the vessels from those traced in the image</source>
        <translation>Farben: Abstand der Gefäße von den im Bild erkannten</translation>
    </message>
    <message>
        <source>farther</source>
        <translation>weiter</translation>
    </message>
    <message>
        <source>Trustworthy</source>
        <translation>Vertrauenswürdig</translation>
    </message>
    <message>
        <source>Not trustworthy</source>
        <translation>Nicht vertrauenswürdig</translation>
    </message>
    <message>
        <source>This pose may be wrong. Do not use it as it is.</source>
        <translation>Diese Lage kann falsch sein. So nicht verwenden.</translation>
    </message>
    <message>
        <source>No check speaks against this pose. That is no proof: look at the picture.</source>
        <translation>Keine Prüfung spricht gegen diese Lage. Das ist kein Beweis: das Bild ansehen.</translation>
    </message>
    <message>
        <source>95th percentile</source>
        <translation>95. Perzentil</translation>
    </message>
</context>
<context>
    <name>angiopose::app::CloseController</name>
    <message>
        <source>A registration is running</source>
        <translation>Eine Registrierung läuft</translation>
    </message>
    <message>
        <source>Stop it and close? Changes of this case are lost unless they are saved.</source>
        <translation>Anhalten und schließen? Änderungen an diesem Fall gehen ohne Speichern verloren.</translation>
    </message>
    <message>
        <source>Save before closing?</source>
        <translation>Vor dem Schließen speichern?</translation>
    </message>
    <message>
        <source>“%1” has changes that are not saved.</source>
        <translation>„%1“ hat ungespeicherte Änderungen.</translation>
    </message>
    <message>
        <source>Stop, save and close</source>
        <translation>Anhalten, speichern, schließen</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>Anhalten und schließen</translation>
    </message>
    <message>
        <source>Keep running</source>
        <translation>Weiterlaufen lassen</translation>
    </message>
    <message>
        <source>Save and close</source>
        <translation>Speichern und schließen</translation>
    </message>
    <message>
        <source>Close without saving</source>
        <translation>Ohne Speichern schließen</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Bleiben</translation>
    </message>
    <message>
        <source>“%1” has no angiogram yet. Its vessels can be saved alone, as centrelines.</source>
        <translation>„%1“ hat noch kein Angiogramm. Die Gefäße lassen sich allein speichern, als Mittellinien.</translation>
    </message>
    <message>
        <source>Save the vessels and close</source>
        <translation>Gefäße speichern und schließen</translation>
    </message>
    <message>
        <source>Close without saving?</source>
        <translation>Ohne Speichern schließen?</translation>
    </message>
    <message>
        <source>“%1” has no vessels yet, so there is no case to save. What was done here is lost.</source>
        <translation>„%1“ hat noch keine Gefäße, also gibt es keinen Fall zu speichern. Was hier getan wurde, geht verloren.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::CurveController</name>
    <message>
        <source>At least one curve must stay: there would be nothing to register to.</source>
        <translation>Mindestens eine Kurve muss bleiben: sonst gäbe es nichts zum Registrieren.</translation>
    </message>
    <message>
        <source>Keep a suspect curve</source>
        <translation>Verdächtige Kurve behalten</translation>
    </message>
    <message>
        <source>The edited curves of frame %1 gave way to these. Undo brings them back.</source>
        <translation>Die bearbeiteten Kurven von Bild %1 sind ersetzt. Rückgängig bringt sie zurück.</translation>
    </message>
    <message>
        <source>Trace this frame again?</source>
        <translation>Dieses Bild neu erfassen?</translation>
    </message>
    <message>
        <source>Its edited or given curves are set aside. Undo brings them back.</source>
        <translation>Bearbeitete oder gegebene Kurven werden beiseitegelegt. Rückgängig bringt sie zurück.</translation>
    </message>
    <message>
        <source>Trace again</source>
        <translation>Neu erfassen</translation>
    </message>
    <message>
        <source>Keep the curves</source>
        <translation>Kurven behalten</translation>
    </message>
    <message>
        <source>Where nothing but a wire is seen, the method “Wire or catheter” takes every curve.</source>
        <translation>Wo nichts als ein Draht zu sehen ist, nimmt das Verfahren „Draht oder Katheter“ jede Kurve.</translation>
    </message>
    <message>
        <source>Keep a catheter or wire apart</source>
        <translation>Katheter oder Draht absondern</translation>
    </message>
    <message>
        <source>Take a curve for a vessel again</source>
        <translation>Kurve wieder als Gefäß nehmen</translation>
    </message>
    <message>
        <source>Follow the catheter or wire</source>
        <translation>Katheter oder Draht verfolgen</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ExportController</name>
    <message>
        <source>Points for 3D Slicer (*.fcsv *.mrk.json)</source>
        <translation>Punkte für 3D Slicer (*.fcsv *.mrk.json)</translation>
    </message>
    <message>
        <source>Poses with their camera (*.txt *.yml *.xml)</source>
        <translation>Lagen mit ihrer Kamera (*.txt *.yml *.xml)</translation>
    </message>
    <message>
        <source>Drawings (*.svg)</source>
        <translation>Zeichnungen (*.svg)</translation>
    </message>
    <message>
        <source>PDF pages (*.pdf)</source>
        <translation>PDF-Seiten (*.pdf)</translation>
    </message>
    <message>
        <source>There is nothing to export yet. Open a vessel tree and an angiogram first.</source>
        <translation>Noch nichts zu exportieren. Zuerst Gefäßbaum und Angiogramm öffnen.</translation>
    </message>
    <message>
        <source>Export overlay</source>
        <translation>Überlagerung exportieren</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG-Bilder (*.png)</translation>
    </message>
    <message>
        <source>There is no result for this pose. Register first (R).</source>
        <translation>Für diese Lage gibt es kein Ergebnis. Zuerst registrieren (R).</translation>
    </message>
    <message>
        <source>Export result</source>
        <translation>Ergebnis exportieren</translation>
    </message>
    <message>
        <source>Results (*.json)</source>
        <translation>Ergebnisse (*.json)</translation>
    </message>
    <message>
        <source>Export pose</source>
        <translation>Lage exportieren</translation>
    </message>
    <message>
        <source>Poses (*.json *.tfm *.h5)</source>
        <translation>Lagen (*.json *.tfm *.h5)</translation>
    </message>
    <message>
        <source>No vessels have been traced in this frame yet.</source>
        <translation>In diesem Bild sind noch keine Gefäße erkannt.</translation>
    </message>
    <message>
        <source>How each point moved (*.csv)</source>
        <translation>Bewegung jedes Punkts (*.csv)</translation>
    </message>
    <message>
        <source>Bent centrelines (*.vtp)</source>
        <translation>Gebogene Mittellinien (*.vtp)</translation>
    </message>
    <message>
        <source>Export bent vessels</source>
        <translation>Gebogene Gefäße exportieren</translation>
    </message>
    <message>
        <source>No bent vessels are known of this pose. Register first (R).</source>
        <translation>Zu dieser Lage sind keine gebogenen Gefäße bekannt. Zuerst registrieren (R).</translation>
    </message>
    <message>
        <source>Export traced vessels</source>
        <translation>Erkannte Gefäße exportieren</translation>
    </message>
    <message>
        <source>2-D centrelines (*.csv)</source>
        <translation>2-D-Mittellinien (*.csv)</translation>
    </message>
    <message>
        <source>There are no vessels yet. Open a centreline, or trace a scan.</source>
        <translation>Noch keine Gefäße. Eine Mittellinie öffnen oder einen Scan nachzeichnen.</translation>
    </message>
    <message>
        <source>Export vessel tree</source>
        <translation>Gefäßbaum exportieren</translation>
    </message>
    <message>
        <source>Centrelines (*.vtp *.csv *.swc *.mrk.json)</source>
        <translation>Mittellinien (*.vtp *.csv *.swc *.mrk.json)</translation>
    </message>
    <message>
        <source>Export measurements</source>
        <translation>Messungen exportieren</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>No check points or rings have been set yet.</source>
        <translation>Es sind noch keine Prüfpunkte oder Ringe gesetzt.</translation>
    </message>
    <message>
        <source>Export check points</source>
        <translation>Prüfpunkte exportieren</translation>
    </message>
    <message>
        <source>Nothing has been measured yet.</source>
        <translation>Es wurde noch nichts gemessen.</translation>
    </message>
    <message>
        <source>Export lumen mask</source>
        <translation>Gefäßmaske exportieren</translation>
    </message>
    <message>
        <source>Label images (*.nrrd *.nii.gz *.nii *.mha)</source>
        <translation>Labelbilder (*.nrrd *.nii.gz *.nii *.mha)</translation>
    </message>
</context>
<context>
    <name>angiopose::app::FollowController</name>
    <message>
        <source>Following the vessels through the run: %1 %</source>
        <translation>Gefäße werden durch die Serie verfolgt: %1 %</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>The vessels cannot be followed</source>
        <translation>Die Gefäße können nicht verfolgt werden</translation>
    </message>
    <message>
        <source>Something else is under way. Let it end first.</source>
        <translation>Etwas anderes läuft gerade. Warten Sie, bis es endet.</translation>
    </message>
    <message>
        <source>Open vessels and an angiogram first.</source>
        <translation>Öffnen Sie zuerst Gefäße und ein Angiogramm.</translation>
    </message>
    <message>
        <source>Following the vessels through the run …</source>
        <translation>Gefäße werden durch die Serie verfolgt …</translation>
    </message>
    <message>
        <source>Follow the vessels through the run</source>
        <translation>Gefäße durch die Serie verfolgen</translation>
    </message>
    <message>
        <source>The vessels were moved meanwhile: follow them again.</source>
        <translation>Die Gefäße wurden inzwischen bewegt: verfolgen Sie sie erneut.</translation>
    </message>
    <message>
        <source>breath every %1 s, %2 mm to and fro</source>
        <translation>Atmung alle %1 s, %2 mm hin und her</translation>
    </message>
    <message>
        <source>heartbeat every %1 s, %2 mm to and fro</source>
        <translation>Herzschlag alle %1 s, %2 mm hin und her</translation>
    </message>
    <message>
        <source>Followed through %1 frames: scroll or play them</source>
        <translation>Durch %1 Bilder verfolgt: blättern oder abspielen</translation>
    </message>
    <message>
        <source>Followed through %1 frames; %2 of them do not show the vessels well enough</source>
        <translation>Durch %1 Bilder verfolgt; %2 davon zeigen die Gefäße nicht gut genug</translation>
    </message>
    <message>
        <source>Export followed poses</source>
        <translation>Verfolgte Lagen exportieren</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
</context>
<context>
    <name>angiopose::app::GeometryController</name>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>Use distances and spacing</source>
        <translation>Abstände und Pixelgröße verwenden</translation>
    </message>
</context>
<context>
    <name>angiopose::app::HelpController</name>
    <message>
        <source>Open the sample case</source>
        <translation>Beispielfall öffnen</translation>
    </message>
    <message>
        <source>AngioPose %1</source>
        <translation>AngioPose %1</translation>
    </message>
    <message>
        <source>Finds where a 3-D vessel tree lies in a 2-D angiogram, without correspondences.

Not for clinical use: AngioPose is a research program, not a medical device.

Apache License 2.0. Built on Qt, VTK, ITK, OpenCV, NLopt, Eigen and nanoflann.</source>
        <translation>Findet, wo ein 3-D-Gefäßbaum in einem 2-D-Angiogramm liegt, ohne Korrespondenzen.

Nicht für den klinischen Einsatz: AngioPose ist ein Forschungsprogramm, kein Medizinprodukt.

Apache-Lizenz 2.0. Gebaut mit Qt, VTK, ITK, OpenCV, NLopt, Eigen und nanoflann.</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Start here</source>
        <translation>Hier beginnen</translation>
    </message>
    <message>
        <source>Drop a case, or vessels and an angiogram, anywhere. “Open the sample case” works without own data.</source>
        <translation>Einen Fall, oder Gefäße und ein Angiogramm, irgendwo ablegen. „Beispielfall öffnen“ geht ohne eigene Daten.</translation>
    </message>
    <message>
        <source>The way to a result</source>
        <translation>Der Weg zum Ergebnis</translation>
    </message>
    <message>
        <source>Each step has a tick, or says in its tool tip what is missing. Click any of them, in any order.</source>
        <translation>Jeder Schritt hat einen Haken oder sagt im Tooltip, was fehlt. In beliebiger Reihenfolge anklicken.</translation>
    </message>
    <message>
        <source>The vessel tree</source>
        <translation>Der Gefäßbaum</translation>
    </message>
    <message>
        <source>Its branches with length and distance to the image. A takes a branch into the auxiliary set, X leaves it out.</source>
        <translation>Seine Äste mit Länge und Abstand zum Bild. A nimmt einen Ast in die Hilfsmenge, X lässt ihn weg.</translation>
    </message>
    <message>
        <source>The angiogram</source>
        <translation>Das Angiogramm</translation>
    </message>
    <message>
        <source>The projected tree lies over it, coloured by distance. Wheel: frames. N: move the tree with arrows or mouse. H: hide it.</source>
        <translation>Der projizierte Gefäßbaum liegt darüber, nach Abstand gefärbt. Rad: Bilder. N: mit Pfeilen oder Maus schieben. H: verbergen.</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Registrieren</translation>
    </message>
    <message>
        <source>R finds the pose. Stop keeps the best one so far, Ctrl+Z brings the old one back.</source>
        <translation>R findet die Lage. Stopp behält die bisher beste, Strg+Z bringt die alte zurück.</translation>
    </message>
    <message>
        <source>Can it be trusted?</source>
        <translation>Ist darauf Verlass?</translation>
    </message>
    <message>
        <source>Numbers in mm, and sentences on what the image cannot tell. Shift+F1 shows good and bad fits.</source>
        <translation>Zahlen in mm und Sätze darüber, was das Bild nicht verrät. Umschalt+F1 zeigt gute und schlechte Einpassungen.</translation>
    </message>
    <message>
        <source>Help is never far</source>
        <translation>Hilfe ist nah</translation>
    </message>
    <message>
        <source>F1 explains what the mouse points at, ? lists and changes all keys. This tour is under Help.</source>
        <translation>F1 erklärt, worauf die Maus zeigt, ? zeigt und ändert alle Tasten. Dieser Rundgang steht unter Hilfe.</translation>
    </message>
    <message>
        <source>The angiogram is drawn by VTK (OpenGL).</source>
        <translation>Das Angiogramm zeichnet VTK (OpenGL).</translation>
    </message>
    <message>
        <source>The angiogram is drawn by the processor.</source>
        <translation>Das Angiogramm zeichnet der Prozessor.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::HistoryController</name>
    <message>
        <source>Undo: %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Wiederholen: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PatientBar</name>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PatientController</name>
    <message>
        <source>Not the same patient in all inputs</source>
        <translation>Nicht in allen Eingaben derselbe Patient</translation>
    </message>
    <message>
        <source>The inputs do not belong together</source>
        <translation>Die Eingaben gehören nicht zusammen</translation>
    </message>
    <message>
        <source>Identity hidden (Shift+P shows it)</source>
        <translation>Identität verborgen (Umschalt+P zeigt sie)</translation>
    </message>
    <message>
        <source>scan</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>view %1</source>
        <translation>Ansicht %1</translation>
    </message>
    <message>
        <source>angiogram</source>
        <translation>Angiogramm</translation>
    </message>
    <message>
        <source>ID %1</source>
        <translation>ID %1</translation>
    </message>
    <message>
        <source>born %1</source>
        <translation>geb. %1</translation>
    </message>
</context>
<context>
    <name>angiopose::app::InputKind</name>
    <message>
        <source>Poses and points (*.json *.tfm *.mat *.h5 *.txt *.yml *.yaml *.xml *.fcsv)</source>
        <translation>Lagen und Punkte (*.json *.tfm *.mat *.h5 *.txt *.yml *.yaml *.xml *.fcsv)</translation>
    </message>
    <message>
        <source>Cases, vessels and angiograms (%1)</source>
        <translation>Fälle, Gefäße und Angiogramme (%1)</translation>
    </message>
    <message>
        <source>Cases (*.angiopose)</source>
        <translation>Fälle (*.angiopose)</translation>
    </message>
    <message>
        <source>Centrelines (*.vtp *.vtk *.csv *.swc *.json)</source>
        <translation>Mittellinien (*.vtp *.vtk *.csv *.swc *.json)</translation>
    </message>
    <message>
        <source>Scans and surfaces (%1 *.dcm)</source>
        <translation>CT-Daten und Oberflächen (%1 *.dcm)</translation>
    </message>
    <message>
        <source>Angiograms (*.dcm *.png *.tif *.tiff *.jpg *.jpeg)</source>
        <translation>Angiogramme (*.dcm *.png *.tif *.tiff *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>angiopose::app::JudgementController</name>
    <message>
        <source>nothing to judge yet</source>
        <translation>noch nichts zu beurteilen</translation>
    </message>
</context>
<context>
    <name>angiopose::app::LandmarkController</name>
    <message>
        <source>bifurcation %1</source>
        <translation>Verzweigung %1</translation>
    </message>
    <message>
        <source>end of %1</source>
        <translation>Ende von %1</translation>
    </message>
    <message>
        <source>on %1</source>
        <translation>auf %1</translation>
    </message>
    <message>
        <source>place beside the vessels</source>
        <translation>Stelle neben den Gefäßen</translation>
    </message>
    <message>
        <source>Fewer than four pairs: what they leave open stays as it is.</source>
        <translation>Weniger als vier Paare: was sie offenlassen, bleibt wie es ist.</translation>
    </message>
    <message>
        <source>The pairs leave %1 px; for clicks off by 2 px: rotation ±%2°, depth ±%3 mm.</source>
        <translation>Die Paare lassen %1 px; bei Klicks 2 px daneben: Drehung ±%2°, Tiefe ±%3 mm.</translation>
    </message>
    <message>
        <source>Move landmark %1</source>
        <translation>Landmarke %1 verschieben</translation>
    </message>
    <message>
        <source>Open the vessels first.</source>
        <translation>Zuerst die Gefäße öffnen.</translation>
    </message>
    <message>
        <source>Add landmark</source>
        <translation>Landmarke hinzufügen</translation>
    </message>
    <message>
        <source>Remove landmark</source>
        <translation>Landmarke entfernen</translation>
    </message>
    <message>
        <source>Place vessels by landmarks</source>
        <translation>Gefäße nach Landmarken legen</translation>
    </message>
</context>
<context>
    <name>angiopose::app::LinkedCrosshair</name>
    <message>
        <source>The cross-hair links views that stand side by side (%1).</source>
        <translation>Das Fadenkreuz verbindet Ansichten, die nebeneinander stehen (%1).</translation>
    </message>
</context>
<context>
    <name>angiopose::app::LookController</name>
    <message>
        <source>Near vessels bright, far ones dim</source>
        <translation>Nahe Gefäße hell, ferne dunkel</translation>
    </message>
    <message>
        <source>Depth cue off</source>
        <translation>Tiefenhinweis aus</translation>
    </message>
    <message>
        <source>Vessels as centrelines</source>
        <translation>Gefäße als Mittellinien</translation>
    </message>
    <message>
        <source>Vessels as outlines</source>
        <translation>Gefäße als Umrisse</translation>
    </message>
    <message>
        <source>Vessels as tubes</source>
        <translation>Gefäße als Röhren</translation>
    </message>
    <message>
        <source>Swipe: the overlay ends at the mouse</source>
        <translation>Wischen: die Überlagerung endet an der Maus</translation>
    </message>
    <message>
        <source>Lens: the bare angiogram under the mouse</source>
        <translation>Lupe: unter der Maus das Angiogramm allein</translation>
    </message>
    <message>
        <source>Swipe and lens off</source>
        <translation>Wischen und Lupe aus</translation>
    </message>
    <message>
        <source>Overlay opacity %1 %</source>
        <translation>Deckkraft der Überlagerung %1 %</translation>
    </message>
    <message>
        <source>No residuals yet</source>
        <translation>Noch keine Abweichungen</translation>
    </message>
    <message>
        <source>Worst %1 of %2: %3 mm median · W next · 1 fits</source>
        <translation>Schlechtester %1 von %2: Median %3 mm · W weiter · 1 einpassen</translation>
    </message>
    <message>
        <source>Seen from the source: only the view is mirrored</source>
        <translation>Vom Fokus gesehen: nur die Ansicht ist gespiegelt</translation>
    </message>
    <message>
        <source>Seen from the detector</source>
        <translation>Vom Detektor gesehen</translation>
    </message>
    <message>
        <source>Vessels as a radiograph of the scan (DRR)</source>
        <translation>Gefäße als Röntgenbild des Scans (DRR)</translation>
    </message>
    <message>
        <source>Vessels as a radiograph of tubes (DRR)</source>
        <translation>Gefäße als Röntgenbild aus Röhren (DRR)</translation>
    </message>
</context>
<context>
    <name>angiopose::app::Notices</name>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>AngioPose %1</source>
        <translation>AngioPose %1</translation>
    </message>
</context>
<context>
    <name>angiopose::app::OpacificationController</name>
    <message>
        <source>Opacification over time</source>
        <translation>Kontrastfüllung über die Zeit</translation>
    </message>
</context>
<context>
    <name>angiopose::app::OpenController</name>
    <message>
        <source>The pose is of an image of %1 × %2 px, the angiogram has %3 × %4. Open the pose of this image.</source>
        <translation>Die Lage gehört zu einem Bild von %1 × %2 px, das Angiogramm hat %3 × %4. Die Lage dieses Bildes öffnen.</translation>
    </message>
    <message>
        <source>The camera of the pose is mirrored against the angiogram: one is seen from the detector, the other from the source. Mirror the image, or say so in the geometry.</source>
        <translation>Die Kamera der Lage ist gegen das Angiogramm gespiegelt: eines ist vom Detektor, das andere von der Quelle aus gesehen. Das Bild spiegeln, oder es in der Geometrie angeben.</translation>
    </message>
    <message>
        <source>The pose was found with other vessels than these.</source>
        <translation>Die Lage wurde mit anderen Gefäßen gefunden als diesen.</translation>
    </message>
    <message>
        <source>The pose was found in another angiogram than this.</source>
        <translation>Die Lage wurde in einem anderen Angiogramm gefunden als diesem.</translation>
    </message>
    <message>
        <source>A pose belongs to a case. Open vessels and an angiogram first, then the pose.</source>
        <translation>Eine Lage gehört zu einem Fall. Erst Gefäße und ein Angiogramm öffnen, dann die Lage.</translation>
    </message>
    <message>
        <source>At this pose the vessels lie behind the X-ray source. It may be of another patient, or lead from camera to patient: then invert it.</source>
        <translation>In dieser Lage liegen die Gefäße hinter der Röntgenquelle. Sie ist vielleicht von einem anderen Patienten oder führt von der Kamera zum Patienten: dann umkehren.</translation>
    </message>
    <message>
        <source>The camera of the pose counts now. The geometry panel takes it back.</source>
        <translation>Die Kamera der Lage gilt jetzt. Das Geometriefeld nimmt sie zurück.</translation>
    </message>
    <message>
        <source>Open pose %1</source>
        <translation>Lage %1 öffnen</translation>
    </message>
    <message>
        <source>Points belong to vessels. Open those first, then the points.</source>
        <translation>Punkte gehören zu Gefäßen. Erst diese öffnen, dann die Punkte.</translation>
    </message>
    <message>
        <source>Check points added: %1.</source>
        <translation>Prüfpunkte hinzugefügt: %1.</translation>
    </message>
    <message>
        <source>None of them lies near the vessels. They may be of another patient, or in other coordinates.</source>
        <translation>Keiner liegt nahe den Gefäßen. Vielleicht sind sie von einem anderen Patienten oder in anderen Koordinaten.</translation>
    </message>
    <message>
        <source>Open points %1</source>
        <translation>Punkte %1 öffnen</translation>
    </message>
    <message>
        <source>Pose of %1 taken.</source>
        <translation>Lage aus %1 übernommen.</translation>
    </message>
    <message>
        <source>A registration is running. Stop it before opening another file.</source>
        <translation>Eine Registrierung läuft. Vor dem Öffnen einer anderen Datei anhalten.</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>%1 wird gelesen …</translation>
    </message>
    <message>
        <source>A registration was started meanwhile. Open the file again when it has ended.</source>
        <translation>Inzwischen wurde eine Registrierung gestartet. Die Datei nach deren Ende erneut öffnen.</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>A blind trial is under way. End it before opening another file.</source>
        <translation>Ein Blindversuch läuft. Vor dem Öffnen einer anderen Datei beenden.</translation>
    </message>
    <message>
        <source>A blind trial was started meanwhile. Open the file again when it has ended.</source>
        <translation>Inzwischen begann ein Blindversuch. Die Datei nach dessen Ende erneut öffnen.</translation>
    </message>
    <message>
        <source>Add view %1</source>
        <translation>Ansicht %1 hinzufügen</translation>
    </message>
    <message>
        <source>View added: a click in the strip above the image shows it.</source>
        <translation>Ansicht hinzugefügt: ein Klick in der Leiste über dem Bild zeigt sie.</translation>
    </message>
    <message>
        <source>Further runs become views once there are vessels. Open them again then.</source>
        <translation>Weitere Läufe werden zu Ansichten, sobald es Gefäße gibt. Dann bitte noch einmal öffnen.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::OpenDialogs</name>
    <message>
        <source>Whose camera counts?</source>
        <translation>Wessen Kamera gilt?</translation>
    </message>
    <message>
        <source>“%1” brings a camera that is not the one of the case. A pose shows the vessels in their place by its own camera only.</source>
        <translation>„%1“ bringt eine andere Kamera als die des Falls mit. Nur mit ihrer eigenen Kamera zeigt eine Lage die Gefäße an ihrem Ort.</translation>
    </message>
    <message>
        <source>Take pose and camera</source>
        <translation>Lage und Kamera übernehmen</translation>
    </message>
    <message>
        <source>Take the pose alone</source>
        <translation>Nur die Lage übernehmen</translation>
    </message>
    <message>
        <source>Not the same patient?</source>
        <translation>Nicht derselbe Patient?</translation>
    </message>
    <message>
        <source>If “%1” is opened all the same, every picture and report of the case will say so, and no registration of its images is trusted. Open it as the same patient where pseudonyms differ.</source>
        <translation>Wird „%1“ dennoch geöffnet, steht es auf jedem Bild und Bericht des Falls, und keine Registrierung seiner Bilder gilt als verlässlich. Unterscheiden sich nur Pseudonyme, öffnen Sie es als denselben Patienten.</translation>
    </message>
    <message>
        <source>Do not open it</source>
        <translation>Nicht öffnen</translation>
    </message>
    <message>
        <source>Open it all the same</source>
        <translation>Dennoch öffnen</translation>
    </message>
    <message>
        <source>It is the same patient</source>
        <translation>Es ist derselbe Patient</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open folder or disc</source>
        <translation>Ordner oder CD öffnen</translation>
    </message>
    <message>
        <source>Add a view</source>
        <translation>Ansicht hinzufügen</translation>
    </message>
    <message>
        <source>Another view of the same vessels?</source>
        <translation>Eine weitere Ansicht derselben Gefäße?</translation>
    </message>
    <message>
        <source>The case has an angiogram. “%1” can stand beside it, to register both together, or take its place.</source>
        <translation>Der Fall hat ein Angiogramm. „%1“ kann daneben stehen, um beide zusammen zu registrieren, oder es ersetzen.</translation>
    </message>
    <message>
        <source>Add as a view</source>
        <translation>Als Ansicht hinzufügen</translation>
    </message>
    <message>
        <source>Replace the angiogram</source>
        <translation>Angiogramm ersetzen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>A scan beside the vessels?</source>
        <translation>Ein Scan neben den Gefäßen?</translation>
    </message>
    <message>
        <source>The case has its vessels from a file. “%1” can be shown in slices with them, or its own vessels are traced and take their place.</source>
        <translation>Der Fall hat seine Gefäße aus einer Datei. „%1“ kann mit ihnen in Schichten gezeigt werden, oder seine eigenen Gefäße werden verfolgt und ersetzen sie.</translation>
    </message>
    <message>
        <source>Show beside the vessels</source>
        <translation>Neben den Gefäßen zeigen</translation>
    </message>
    <message>
        <source>Trace its vessels</source>
        <translation>Seine Gefäße verfolgen</translation>
    </message>
    <message>
        <source>Making the sample case …</source>
        <translation>Beispielfall wird erzeugt …</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Could not make the sample case</source>
        <translation>Der Beispielfall ließ sich nicht erzeugen</translation>
    </message>
    <message>
        <source>Save the open case first?</source>
        <translation>Den offenen Fall zuerst speichern?</translation>
    </message>
    <message>
        <source>“%1” has changes that are not saved.</source>
        <translation>„%1“ hat ungespeicherte Änderungen.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>Änderungen verwerfen</translation>
    </message>
    <message>
        <source>Keep the open case</source>
        <translation>Beim offenen Fall bleiben</translation>
    </message>
    <message>
        <source>%1 mm across</source>
        <translation>%1 mm groß</translation>
    </message>
    <message>
        <source>%1 m across</source>
        <translation>%1 m groß</translation>
    </message>
    <message>
        <source>“%1” does not say in what unit its points are, and in millimetres it is unusually small or large for vessels. The case remembers what you choose.</source>
        <translation>„%1“ sagt nicht, in welcher Einheit die Punkte sind, und in Millimetern wäre sie für Gefäße ungewöhnlich klein oder groß. Der Fall merkt sich die Wahl.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>What is the unit of the file?</source>
        <translation>In welcher Einheit ist die Datei?</translation>
    </message>
    <message>
        <source>Discard what was done?</source>
        <translation>Verwerfen, was getan wurde?</translation>
    </message>
    <message>
        <source>“%1” has no vessels yet, so there is no case to save. What was done here is lost.</source>
        <translation>„%1“ hat noch keine Gefäße, also gibt es keinen Fall zu speichern. Was hier getan wurde, geht verloren.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::OpenNotes</name>
    <message>
        <source>The vessels do not lie in this scan: it may be another one, or have other axes.</source>
        <translation>Die Gefäße liegen nicht in diesem Scan: er kann ein anderer sein oder andere Achsen haben.</translation>
    </message>
    <message>
        <source>The scan is shown without vessels: place a seed or set the threshold in the slices (%1), then trace.</source>
        <translation>Der Scan wird ohne Gefäße gezeigt: Startpunkt setzen oder Schwelle in den Schichten (%1) wählen, dann erfassen.</translation>
    </message>
    <message>
        <source>One unit of the file is %1 mm, as you chose.</source>
        <translation>Eine Einheit der Datei ist %1 mm, wie gewählt.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PictureController</name>
    <message>
        <source>The window is in the clipboard as a picture</source>
        <translation>Das Fenster liegt als Bild in der Zwischenablage</translation>
    </message>
    <message>
        <source>Save picture of the window</source>
        <translation>Bild des Fensters speichern</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG-Bilder (*.png)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>Could not save the picture</source>
        <translation>Das Bild ließ sich nicht speichern</translation>
    </message>
    <message>
        <source>%1 could not be written. Choose another folder.</source>
        <translation>%1 ließ sich nicht schreiben. Anderen Ordner wählen.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PivotController</name>
    <message>
        <source>Pick the pivot</source>
        <translation>Drehpunkt wählen</translation>
    </message>
    <message>
        <source>The vessels turn about the picked place now.</source>
        <translation>Die Gefäße drehen sich jetzt um die gewählte Stelle.</translation>
    </message>
    <message>
        <source>Pivot back to the centroid</source>
        <translation>Drehpunkt zurück zum Schwerpunkt</translation>
    </message>
    <message>
        <source>The vessels turn about their centroid again.</source>
        <translation>Die Gefäße drehen sich wieder um ihren Schwerpunkt.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PlotExport</name>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Export as SVG …</source>
        <translation>Als SVG exportieren …</translation>
    </message>
    <message>
        <source>Export as PNG …</source>
        <translation>Als PNG exportieren …</translation>
    </message>
    <message>
        <source>Export plot</source>
        <translation>Diagramm exportieren</translation>
    </message>
    <message>
        <source>Drawings (*.svg)</source>
        <translation>Zeichnungen (*.svg)</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG-Bilder (*.png)</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PoseController</name>
    <message>
        <source>Move vessels</source>
        <translation>Gefäße verschieben</translation>
    </message>
    <message>
        <source>There is no pose to nudge yet: vessels, angiogram and geometry come first.</source>
        <translation>Noch keine Lage zum Justieren: zuerst Gefäße, Angiogramm und Geometrie.</translation>
    </message>
    <message>
        <source>“%1” is locked.</source>
        <translation>„%1“ ist gesperrt.</translation>
    </message>
    <message>
        <source>Back to start pose</source>
        <translation>Zurück zur Startlage</translation>
    </message>
    <message>
        <source>A registration is running. Stop it first.</source>
        <translation>Eine Registrierung läuft. Zuerst anhalten.</translation>
    </message>
    <message>
        <source>Change locks</source>
        <translation>Sperren ändern</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PoseGestures</name>
    <message>
        <source>Nudge mode: arrows move, drag moves or rolls, N ends</source>
        <translation>Justiermodus: Pfeile schieben, Ziehen schiebt oder dreht, N beendet</translation>
    </message>
    <message>
        <source>Nudge mode off</source>
        <translation>Justiermodus aus</translation>
    </message>
    <message>
        <source>Copied: camera from patient, 4 × 4, mm</source>
        <translation>Kopiert: Kamera aus Patient, 4 × 4, mm</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PoseTableController</name>
    <message>
        <source>There are no poses to compare yet.</source>
        <translation>Noch keine Lagen zu vergleichen.</translation>
    </message>
    <message>
        <source>The pose as it is</source>
        <translation>Die jetzige Lage</translation>
    </message>
    <message>
        <source>The vessels of this frame are still being traced.</source>
        <translation>Die Gefäße dieses Bildes werden noch erkannt.</translation>
    </message>
    <message>
        <source>Starting …</source>
        <translation>Beginnt …</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Run several methods</source>
        <translation>Mehrere Methoden laufen lassen</translation>
    </message>
    <message>
        <source>1 method done</source>
        <translation>1 Methode fertig</translation>
    </message>
    <message>
        <source>%1 methods done</source>
        <translation>%1 Methoden fertig</translation>
    </message>
    <message>
        <source>Stopped. %1.</source>
        <translation>Angehalten. %1.</translation>
    </message>
    <message>
        <source>Export comparison</source>
        <translation>Vergleich exportieren</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PoseTools</name>
    <message>
        <source>Logged: %1</source>
        <translation>Protokolliert: %1</translation>
    </message>
    <message>
        <source>Blind trial</source>
        <translation>Blindversuch</translation>
    </message>
</context>
<context>
    <name>angiopose::app::RegistrationController</name>
    <message>
        <source>Open a vessel centreline first.</source>
        <translation>Zuerst eine Gefäß-Mittellinie öffnen.</translation>
    </message>
    <message>
        <source>Open an angiogram first.</source>
        <translation>Zuerst ein Angiogramm öffnen.</translation>
    </message>
    <message>
        <source>Register (%1)</source>
        <translation>Registrieren (%1)</translation>
    </message>
    <message>
        <source>A blind trial is fitted by hand.</source>
        <translation>Ein Blindversuch wird von Hand eingepasst.</translation>
    </message>
    <message>
        <source>Register all views</source>
        <translation>Alle Ansichten registrieren</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ReplayController</name>
    <message>
        <source>Other way %1 of %2, probability %3 % · %4 takes it</source>
        <translation>Anderer Weg %1 von %2, Wahrscheinlichkeit %3 % · %4 übernimmt ihn</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>Kippung</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>sideways</source>
        <translation>seitlich</translation>
    </message>
    <message>
        <source>up–down</source>
        <translation>auf–ab</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>There is no run to replay. Register first (R).</source>
        <translation>Kein Lauf zum Wiederholen. Zuerst registrieren (R).</translation>
    </message>
    <message>
        <source>Replay ended</source>
        <translation>Wiedergabe beendet</translation>
    </message>
    <message>
        <source>Replay: step %1 of %2, %3 px</source>
        <translation>Wiedergabe: Schritt %1 von %2, %3 px</translation>
    </message>
    <message>
        <source>The uncertainty of this pose is not known yet.</source>
        <translation>Die Unsicherheit dieser Lage ist noch nicht bekannt.</translation>
    </message>
    <message>
        <source>The run found no other solution.</source>
        <translation>Der Lauf fand keine andere Lösung.</translation>
    </message>
    <message>
        <source>There is no run yet. Register first (R).</source>
        <translation>Noch kein Lauf. Zuerst registrieren (R).</translation>
    </message>
    <message>
        <source>The solution itself</source>
        <translation>Die Lösung selbst</translation>
    </message>
    <message>
        <source>J shows the other solutions first.</source>
        <translation>J zeigt zuerst die anderen Lösungen.</translation>
    </message>
    <message>
        <source>Take solution %1</source>
        <translation>Lösung %1 übernehmen</translation>
    </message>
    <message>
        <source>Other solution %1 of %2, score %3 · %4 takes it</source>
        <translation>Andere Lösung %1 von %2, Güte %3 · %4 übernimmt</translation>
    </message>
    <message>
        <source>By image noise only, poses within ±%1 mm (2 σ, mostly %2) look alike</source>
        <translation>Allein durch Bildrauschen sehen Lagen innerhalb von ±%1 mm (2 σ, vor allem %2) gleich aus</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ReviewController</name>
    <message>
        <source>Choose another frame</source>
        <translation>Anderes Bild wählen</translation>
    </message>
    <message>
        <source>Before: start pose</source>
        <translation>Vorher: Startlage</translation>
    </message>
    <message>
        <source>No bent vessels are known of this pose</source>
        <translation>Zu dieser Lage sind keine gebogenen Gefäße bekannt</translation>
    </message>
    <message>
        <source>Colours: how far from the traced vessels</source>
        <translation>Farben: wie weit von den erkannten Gefäßen</translation>
    </message>
    <message>
        <source>Colours: how far the bent vessels lie from the rigid ones</source>
        <translation>Farben: wie weit die gebogenen Gefäße von den starren liegen</translation>
    </message>
    <message>
        <source>Vessels as the rigid pose has them</source>
        <translation>Gefäße, wie die starre Lage sie zeigt</translation>
    </message>
    <message>
        <source>Vessels as they are bent</source>
        <translation>Gefäße, wie sie gebogen sind</translation>
    </message>
    <message>
        <source>After: pose as it is</source>
        <translation>Nachher: jetzige Lage</translation>
    </message>
</context>
<context>
    <name>angiopose::app::RunController</name>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Change option “%1”</source>
        <translation>Option „%1“ ändern</translation>
    </message>
    <message>
        <source>Tracing the vessels of this frame …</source>
        <translation>Gefäße dieses Bildes werden erkannt …</translation>
    </message>
    <message>
        <source>Registration cannot run</source>
        <translation>Die Registrierung kann nicht laufen</translation>
    </message>
    <message>
        <source>Registering: %1 · %2 % · %3 px</source>
        <translation>Registrierung: %1 · %2 % · %3 px</translation>
    </message>
    <message>
        <source>Stopped, NOT RELIABLE: the best pose so far is kept, undo takes it back</source>
        <translation>Gestoppt, NICHT VERLÄSSLICH: Die bisher beste Pose bleibt, Rückgängig nimmt sie zurück</translation>
    </message>
    <message>
        <source>Registered: median %1 mm</source>
        <translation>Registriert: Median %1 mm</translation>
    </message>
    <message>
        <source>NOT RELIABLE · median %1 mm over %2 % of the tree</source>
        <translation>NICHT VERLÄSSLICH · Median %1 mm über %2 % des Gefäßbaums</translation>
    </message>
</context>
<context>
    <name>angiopose::app::SaveController</name>
    <message>
        <source>%1 (not saved)</source>
        <translation>%1 (nicht gespeichert)</translation>
    </message>
    <message>
        <source>Save case</source>
        <translation>Fall speichern</translation>
    </message>
    <message>
        <source>Cases (*.angiopose)</source>
        <translation>Fälle (*.angiopose)</translation>
    </message>
    <message>
        <source>All changes saved</source>
        <translation>Alle Änderungen gespeichert</translation>
    </message>
    <message>
        <source>Autosaved %1 s ago</source>
        <translation>Automatisch gesichert vor %1 s</translation>
    </message>
    <message>
        <source>Autosaved %1 min ago</source>
        <translation>Automatisch gesichert vor %1 min</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Not saved yet</source>
        <translation>Noch nicht gespeichert</translation>
    </message>
    <message>
        <source>A blind trial is under way. End it before saving.</source>
        <translation>Ein Blindversuch läuft. Vor dem Speichern beenden.</translation>
    </message>
    <message>
        <source>Untitled case</source>
        <translation>Unbenannter Fall</translation>
    </message>
    <message>
        <source>No angiogram yet</source>
        <translation>Noch kein Angiogramm</translation>
    </message>
    <message>
        <source>A case holds vessels and an angiogram. Until it has one, save the vessels alone, as centrelines: opened together with any angiogram they make a case.</source>
        <translation>Ein Fall enthält Gefäße und ein Angiogramm. Bis er eines hat, lassen sich die Gefäße allein speichern, als Mittellinien: zusammen mit einem Angiogramm geöffnet ergeben sie einen Fall.</translation>
    </message>
    <message>
        <source>Save the vessels …</source>
        <translation>Gefäße speichern …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Vessels without an angiogram</source>
        <translation>Gefäße ohne Angiogramm</translation>
    </message>
    <message>
        <source>Vessels saved as centrelines</source>
        <translation>Gefäße als Mittellinien gespeichert</translation>
    </message>
    <message>
        <source>Changed elsewhere</source>
        <translation>Anderswo geändert</translation>
    </message>
    <message>
        <source>“%1” was saved by another window or program since it was opened here. Overwriting discards what was saved there; reloading discards what was changed here.</source>
        <translation>„%1“ wurde von einem anderen Fenster oder Programm gespeichert, seit es hier geöffnet wurde. Überschreiben verwirft, was dort gespeichert wurde; neu laden verwirft, was hier geändert wurde.</translation>
    </message>
    <message>
        <source>Save as …</source>
        <translation>Speichern unter …</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Überschreiben</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Neu laden</translation>
    </message>
    <message>
        <source>Not autosaved</source>
        <translation>Nicht automatisch gesichert</translation>
    </message>
</context>
<context>
    <name>angiopose::app::SeriesRows</name>
    <message>
        <source>Series %1</source>
        <translation>Serie %1</translation>
    </message>
</context>
<context>
    <name>angiopose::app::SessionController</name>
    <message>
        <source>Case packed: %1</source>
        <translation>Fall gepackt: %1</translation>
    </message>
    <message>
        <source>Could not pack the case</source>
        <translation>Der Fall ließ sich nicht packen</translation>
    </message>
    <message>
        <source>DICOM objects written: %1</source>
        <translation>DICOM-Objekte geschrieben: %1</translation>
    </message>
    <message>
        <source>The program could not be started again. Start it from the menu of the system.</source>
        <translation>Das Programm ließ sich nicht noch einmal starten. Aus dem Menü des Systems starten.</translation>
    </message>
    <message>
        <source>Could not open another window</source>
        <translation>Kein weiteres Fenster möglich</translation>
    </message>
    <message>
        <source>Not for clinical use</source>
        <translation>Nicht für den klinischen Einsatz</translation>
    </message>
    <message>
        <source>AngioPose is a research program. It is not a medical device: do not use it for diagnosis, treatment or navigation. Results can be wrong; one projection cannot tell everything about depth.</source>
        <translation>AngioPose ist ein Forschungsprogramm und kein Medizinprodukt: nicht für Diagnose, Behandlung oder Navigation verwenden. Ergebnisse können falsch sein; eine einzelne Projektion verrät nicht alles über die Tiefe.</translation>
    </message>
    <message>
        <source>I understand</source>
        <translation>Verstanden</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Opened</source>
        <translation>Geöffnet</translation>
    </message>
    <message>
        <source>Could not open the file</source>
        <translation>Die Datei ließ sich nicht öffnen</translation>
    </message>
    <message>
        <source>Could not open the files</source>
        <translation>Die Dateien ließen sich nicht öffnen</translation>
    </message>
    <message>
        <source>Could not save</source>
        <translation>Speichern nicht möglich</translation>
    </message>
    <message>
        <source>Saving …</source>
        <translation>Wird gespeichert …</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Gespeichert</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>Wird geschrieben …</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>Could not export</source>
        <translation>Export nicht möglich</translation>
    </message>
    <message>
        <source>The automatic copy cannot be written; it is tried again every minute. %1</source>
        <translation>Die automatische Sicherung lässt sich nicht schreiben; es wird jede Minute wieder versucht. %1</translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>Gestoppt; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Some files were refused</source>
        <translation>Einige Dateien wurden abgelehnt</translation>
    </message>
    <message>
        <source>Could not de-identify the files</source>
        <translation>Dateien konnten nicht von Identität befreit werden</translation>
    </message>
    <message>
        <source>The audit file is not complete</source>
        <translation>Die Audit-Datei ist unvollständig</translation>
    </message>
</context>
<context>
    <name>angiopose::app::SideBySideController</name>
    <message>
        <source>No other views during a blind trial: they would tell the answer.</source>
        <translation>Während eines Blindversuchs keine anderen Ansichten: sie würden die Lösung verraten.</translation>
    </message>
    <message>
        <source>There is no angiogram yet that another could stand beside.</source>
        <translation>Es gibt noch kein Angiogramm, neben dem ein anderes stehen könnte.</translation>
    </message>
    <message>
        <source>This case has one view. Another angiogram of the same vessels (%1) will stand beside it.</source>
        <translation>Dieser Fall hat eine Ansicht. Ein weiteres Angiogramm derselben Gefäße (%1) steht dann daneben.</translation>
    </message>
    <message>
        <source>no geometry</source>
        <translation>keine Geometrie</translation>
    </message>
    <message>
        <source>moves along</source>
        <translation>bewegt sich mit</translation>
    </message>
    <message>
        <source>pose of its own</source>
        <translation>eigene Lage</translation>
    </message>
    <message>
        <source>The vessels move here as they do in the shown view.</source>
        <translation>Die Gefäße bewegen sich hier wie in der gezeigten Ansicht.</translation>
    </message>
    <message>
        <source>The views are not registered together: the vessels stay here while they are moved in the shown view.</source>
        <translation>Die Ansichten werden nicht gemeinsam registriert: hier bleiben die Gefäße, während sie in der gezeigten Ansicht bewegt werden.</translation>
    </message>
    <message>
        <source>A click here, or a double click in the image, makes it the shown view.</source>
        <translation>Ein Klick hier oder ein Doppelklick ins Bild macht sie zur gezeigten Ansicht.</translation>
    </message>
    <message>
        <source>The image of this view could not be read.</source>
        <translation>Das Bild dieser Ansicht konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Choose another frame</source>
        <translation>Anderes Bild wählen</translation>
    </message>
</context>
<context>
    <name>angiopose::app::SnapshotController</name>
    <message>
        <source>Pose %1</source>
        <translation>Lage %1</translation>
    </message>
    <message>
        <source>There is no pose to keep yet.</source>
        <translation>Noch keine Lage zu behalten.</translation>
    </message>
    <message>
        <source>Keep %1</source>
        <translation>%1 behalten</translation>
    </message>
    <message>
        <source>Kept as “%1” · Y compares</source>
        <translation>Behalten als „%1“ · Y vergleicht</translation>
    </message>
    <message>
        <source>“%1”: median %2 mm · Esc goes back</source>
        <translation>„%1“: Median %2 mm · Esc führt zurück</translation>
    </message>
    <message>
        <source>“%1” · Esc goes back</source>
        <translation>„%1“ · Esc führt zurück</translation>
    </message>
    <message>
        <source>There is nothing to compare with yet: K keeps a pose, R leaves one.</source>
        <translation>Noch nichts zum Vergleichen: K behält eine Lage, R hinterlässt eine.</translation>
    </message>
    <message>
        <source>A: the pose as it is</source>
        <translation>A: die jetzige Lage</translation>
    </message>
    <message>
        <source>Restore %1</source>
        <translation>%1 wiederherstellen</translation>
    </message>
    <message>
        <source>Describe a pose</source>
        <translation>Lage beschreiben</translation>
    </message>
    <message>
        <source>Delete a pose</source>
        <translation>Lage löschen</translation>
    </message>
    <message>
        <source>Delete %1 poses</source>
        <translation>%1 Lagen löschen</translation>
    </message>
</context>
<context>
    <name>angiopose::app::SolutionController</name>
    <message>
        <source>%1 %: %2</source>
        <translation>%1 %: %2</translation>
    </message>
    <message>
        <source>%1 Return takes it.</source>
        <translation>%1 Eingabe übernimmt ihn.</translation>
    </message>
    <message>
        <source>Branches %1: probability %2 %, %3 % of the wire along them, %4 mm off their axes.</source>
        <translation>Äste %1: Wahrscheinlichkeit %2 %, %3 % des Drahts längs davon, %4 mm neben ihren Achsen.</translation>
    </message>
    <message>
        <source>found</source>
        <translation>gefunden</translation>
    </message>
    <message>
        <source>The solution itself</source>
        <translation>Die Lösung selbst</translation>
    </message>
    <message>
        <source>%1 mm, %2°</source>
        <translation>%1 mm, %2°</translation>
    </message>
    <message>
        <source>Other solution %1, score %2: %3 mm aside, %4 mm in depth and %5° turned from the one found. Return takes it.</source>
        <translation>Andere Lösung %1, Güte %2: %3 mm seitlich, %4 mm in der Tiefe und %5° gedreht gegen die gefundene. Eingabe übernimmt sie.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::StartPoseController</name>
    <message>
        <source>Start pose from angles</source>
        <translation>Startlage aus Winkeln</translation>
    </message>
    <message>
        <source>Start pose from the angles, the isocentre in the vessels</source>
        <translation>Startlage aus den Winkeln, Isozentrum in den Gefäßen</translation>
    </message>
    <message>
        <source>Vessels, angiogram and geometry come first.</source>
        <translation>Zuerst Gefäße, Angiogramm und Geometrie.</translation>
    </message>
    <message>
        <source>Start pose by hand</source>
        <translation>Startlage von Hand</translation>
    </message>
    <message>
        <source>The pose as it is has become the start pose</source>
        <translation>Die jetzige Lage ist nun die Startlage</translation>
    </message>
</context>
<context>
    <name>angiopose::app::StepStates</name>
    <message>
        <source>1 branch</source>
        <translation>1 Ast</translation>
    </message>
    <message>
        <source>%1 branches</source>
        <translation>%1 Äste</translation>
    </message>
    <message>
        <source>Open an angiogram: DICOM XA, PNG or TIFF.</source>
        <translation>Ein Angiogramm öffnen: DICOM XA, PNG oder TIFF.</translation>
    </message>
    <message>
        <source>no vessels traced</source>
        <translation>keine Gefäße erkannt</translation>
    </message>
    <message>
        <source>no contrast?</source>
        <translation>kein Kontrast?</translation>
    </message>
    <message>
        <source>tracing …</source>
        <translation>Erkennung …</translation>
    </message>
    <message>
        <source>given centreline</source>
        <translation>gegebene Mittellinie</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation>unvollständig</translation>
    </message>
    <message>
        <source>from the case</source>
        <translation>aus dem Fall</translation>
    </message>
    <message>
        <source>contradictory</source>
        <translation>widersprüchlich</translation>
    </message>
    <message>
        <source>partly assumed</source>
        <translation>teils angenommen</translation>
    </message>
    <message>
        <source>Some values are assumed. Type them if you know them.</source>
        <translation>Einige Werte sind angenommen. Wenn bekannt, bitte eintragen.</translation>
    </message>
    <message>
        <source>pixel spacing typed</source>
        <translation>Pixelgröße eingegeben</translation>
    </message>
    <message>
        <source>pixel spacing derived</source>
        <translation>Pixelgröße abgeleitet</translation>
    </message>
    <message>
        <source>from the header</source>
        <translation>aus dem Header</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>from angles</source>
        <translation>aus Winkeln</translation>
    </message>
    <message>
        <source>running …</source>
        <translation>läuft …</translation>
    </message>
    <message>
        <source>moved by hand</source>
        <translation>von Hand verschoben</translation>
    </message>
    <message>
        <source>followed</source>
        <translation>verfolgt</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>other frame</source>
        <translation>anderes Bild</translation>
    </message>
    <message>
        <source>This pose was found in frame %1. R registers in the one that is shown.</source>
        <translation>Diese Lage wurde in Bild %1 gefunden. R registriert im gezeigten.</translation>
    </message>
    <message>
        <source>%1 mm median</source>
        <translation>Median %1 mm</translation>
    </message>
    <message>
        <source>written</source>
        <translation>geschrieben</translation>
    </message>
    <message>
        <source>Open a CT angiogram, a segmentation, a surface or a centreline.</source>
        <translation>Eine CT-Angiographie, Segmentierung, Oberfläche oder Mittellinie öffnen.</translation>
    </message>
    <message>
        <source>%1 pieces</source>
        <translation>%1 Stücke</translation>
    </message>
    <message>
        <source>The vessels are in pieces. Below the branch list is how to join them.</source>
        <translation>Die Gefäße sind in Stücken. Unter der Astliste steht, wie sie zu verbinden sind.</translation>
    </message>
    <message>
        <source>another patient?</source>
        <translation>anderer Patient?</translation>
    </message>
    <message>
        <source>frame %1, edited</source>
        <translation>Bild %1, bearbeitet</translation>
    </message>
    <message>
        <source>The header gives no pixel spacing: %1. Type it, or press Enter in the field to confirm it.</source>
        <translation>Der Header nennt keine Pixelgröße: %1. Eintragen, oder im Feld mit der Eingabetaste bestätigen.</translation>
    </message>
    <message>
        <source>from landmarks</source>
        <translation>aus Landmarken</translation>
    </message>
    <message>
        <source>not traced</source>
        <translation>nicht erfasst</translation>
    </message>
    <message>
        <source>Nothing was traced in the scan. Place a seed or set the threshold beside its slices.</source>
        <translation>Im Scan wurde nichts erfasst. Neben den Schichten einen Startpunkt setzen oder die Schwelle wählen.</translation>
    </message>
    <message>
        <source>NOT RELIABLE</source>
        <translation>NICHT VERLÄSSLICH</translation>
    </message>
    <message>
        <source>%1 mm median over %2 %</source>
        <translation>%1 mm Median über %2 %</translation>
    </message>
</context>
<context>
    <name>angiopose::app::SubtractionController</name>
    <message>
        <source>Subtract mask</source>
        <translation>Maske abziehen</translation>
    </message>
    <message>
        <source>Show native frames</source>
        <translation>Native Bilder zeigen</translation>
    </message>
    <message>
        <source>Whole run in one picture</source>
        <translation>Ganze Serie in einem Bild</translation>
    </message>
    <message>
        <source>One frame at a time</source>
        <translation>Ein Bild nach dem anderen</translation>
    </message>
    <message>
        <source>Choose mask frames</source>
        <translation>Maskenbilder wählen</translation>
    </message>
    <message>
        <source>A registration is running. Stop it to edit.</source>
        <translation>Eine Registrierung läuft. Zum Bearbeiten anhalten.</translation>
    </message>
    <message>
        <source>Open an angiogram first.</source>
        <translation>Zuerst ein Angiogramm öffnen.</translation>
    </message>
    <message>
        <source>Move the mask</source>
        <translation>Maske verschieben</translation>
    </message>
</context>
<context>
    <name>angiopose::app::TitleController</name>
    <message>
        <source>%1 frames</source>
        <translation>%1 Bilder</translation>
    </message>
    <message>
        <source>1 frame</source>
        <translation>1 Bild</translation>
    </message>
    <message>
        <source>Untitled case</source>
        <translation>Unbenannter Fall</translation>
    </message>
    <message>
        <source>AngioPose · not for clinical use</source>
        <translation>AngioPose · nicht für den klinischen Einsatz</translation>
    </message>
    <message>
        <source>%1 · AngioPose · not for clinical use</source>
        <translation>%1 · AngioPose · nicht für den klinischen Einsatz</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>Fall</translation>
    </message>
</context>
<context>
    <name>angiopose::app::TracingController</name>
    <message>
        <source>Tracing the vessels of the scan … %1 %</source>
        <translation>Gefäße des CT werden erfasst … %1 %</translation>
    </message>
    <message>
        <source>Stopped: the vessels are as they were</source>
        <translation>Angehalten: die Gefäße sind wie zuvor</translation>
    </message>
    <message>
        <source>These vessels were not traced: open a scan, a segmentation or a surface.</source>
        <translation>Diese Gefäße wurden nicht erfasst: ein CT, eine Segmentierung oder Oberfläche öffnen.</translation>
    </message>
    <message>
        <source>A registration is running. Stop it first.</source>
        <translation>Eine Registrierung läuft. Zuerst anhalten.</translation>
    </message>
    <message>
        <source>Tracing the vessels of the scan …</source>
        <translation>Gefäße des CT werden erfasst …</translation>
    </message>
    <message>
        <source>Trace vessels</source>
        <translation>Gefäße erfassen</translation>
    </message>
    <message>
        <source>Traced: 1 branch.</source>
        <translation>Erfasst: 1 Ast.</translation>
    </message>
    <message>
        <source>Traced: %1 branches.</source>
        <translation>Erfasst: %1 Äste.</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>No label is ticked: tick those that are vessels.</source>
        <translation>Kein Label ist angekreuzt: die ankreuzen, die Gefäße sind.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::TreeActions</name>
    <message>
        <source>Select one branch: click it in the list or in a view.</source>
        <translation>Einen Ast wählen: in der Liste oder einer Ansicht anklicken.</translation>
    </message>
    <message>
        <source>%1 pieces, too far apart to belong together</source>
        <translation>%1 Stücke, zu weit auseinander, um zusammenzugehören</translation>
    </message>
    <message>
        <source>Seed here</source>
        <translation>Startpunkt hier</translation>
    </message>
    <message>
        <source>Avoid this place</source>
        <translation>Diese Stelle meiden</translation>
    </message>
    <message>
        <source>%1 pieces · gap %2 mm: %3 – %4</source>
        <translation>%1 Stücke · Lücke %2 mm: %3 – %4</translation>
    </message>
    <message>
        <source>Turn the vessels about this place</source>
        <translation>Gefäße um diese Stelle drehen</translation>
    </message>
</context>
<context>
    <name>angiopose::app::TreeController</name>
    <message>
        <source>Select a branch first: click it in the list or in a view.</source>
        <translation>Zuerst einen Ast wählen: in der Liste oder in einer Ansicht anklicken.</translation>
    </message>
    <message>
        <source>Select one branch: click it in the list or in a view.</source>
        <translation>Einen Ast wählen: in der Liste oder einer Ansicht anklicken.</translation>
    </message>
    <message>
        <source>At least one branch has to stay.</source>
        <translation>Mindestens ein Ast muss bleiben.</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>Delete %1 and what leaves it</source>
        <translation>%1 und seine Abgänge löschen</translation>
    </message>
    <message>
        <source>Click the place of the cut first, in a slice or on the branch in the 3-D view.</source>
        <translation>Zuerst die Trennstelle anklicken, in einer Schicht oder am Ast in der 3-D-Ansicht.</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>%1 trennen</translation>
    </message>
    <message>
        <source>Select the two branches to join: Ctrl adds the second one.</source>
        <translation>Die zwei zu verbindenden Äste wählen: Strg fügt den zweiten hinzu.</translation>
    </message>
    <message>
        <source>Join %1 and %2</source>
        <translation>%1 und %2 verbinden</translation>
    </message>
    <message>
        <source>Smooth %1</source>
        <translation>%1 glätten</translation>
    </message>
    <message>
        <source>Root at %1</source>
        <translation>Wurzel an %1</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>%1 verbergen</translation>
    </message>
    <message>
        <source>Show all branches</source>
        <translation>Alle Äste zeigen</translation>
    </message>
    <message>
        <source>No end branch is shorter or thinner than that.</source>
        <translation>Kein Endast ist kürzer oder dünner.</translation>
    </message>
    <message>
        <source>Prune 1 branch</source>
        <translation>1 Ast ausdünnen</translation>
    </message>
    <message>
        <source>Prune %1 branches</source>
        <translation>%1 Äste ausdünnen</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>Set generation of %1</source>
        <translation>Generation von %1 setzen</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ViewController</name>
    <message>
        <source>Show this view</source>
        <translation>Diese Ansicht zeigen</translation>
    </message>
    <message>
        <source>Name this view…</source>
        <translation>Diese Ansicht benennen …</translation>
    </message>
    <message>
        <source>Name this view</source>
        <translation>Diese Ansicht benennen</translation>
    </message>
    <message>
        <source>Name of the view %1 (empty: its angles)</source>
        <translation>Name der Ansicht %1 (leer: ihre Winkel)</translation>
    </message>
    <message>
        <source>Name a view</source>
        <translation>Eine Ansicht benennen</translation>
    </message>
    <message>
        <source>Take this view out</source>
        <translation>Diese Ansicht herausnehmen</translation>
    </message>
    <message>
        <source>%1 mm · %2 px</source>
        <translation>%1 mm · %2 px</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nicht gefunden</translation>
    </message>
    <message>
        <source>%1. A click shows it, Delete takes the shown view out.</source>
        <translation>%1. Ein Klick zeigt sie, Entf nimmt die gezeigte Ansicht heraus.</translation>
    </message>
    <message>
        <source>The image of this view could not be read.</source>
        <translation>Das Bild dieser Ansicht konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Show view %1</source>
        <translation>Ansicht %1 zeigen</translation>
    </message>
    <message>
        <source>No other view can be shown in its place.</source>
        <translation>Keine andere Ansicht kann an ihrer Stelle gezeigt werden.</translation>
    </message>
    <message>
        <source>Take a view out</source>
        <translation>Ansicht herausnehmen</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ViewSync</name>
    <message>
        <source>Single frame</source>
        <translation>Einzelbild</translation>
    </message>
    <message>
        <source>start pose</source>
        <translation>Ausgangslage</translation>
    </message>
    <message>
        <source>a step of the run</source>
        <translation>ein Schritt des Laufs</translation>
    </message>
    <message>
        <source>a pose that image noise allows</source>
        <translation>eine Lage, die das Bildrauschen zulässt</translation>
    </message>
    <message>
        <source>another solution</source>
        <translation>eine andere Lösung</translation>
    </message>
    <message>
        <source>a kept pose</source>
        <translation>eine behaltene Lage</translation>
    </message>
    <message>
        <source>pose of this frame</source>
        <translation>Lage dieses Bildes</translation>
    </message>
    <message>
        <source>another pose</source>
        <translation>eine andere Lage</translation>
    </message>
    <message>
        <source>Preview: %1</source>
        <translation>Vorschau: %1</translation>
    </message>
    <message>
        <source>%1 · median of the whole tree %2 mm</source>
        <translation>%1 · Median des ganzen Gefäßbaums %2 mm</translation>
    </message>
    <message>
        <source>Opacification by frame · frame %1 of %2 · fullest: %3</source>
        <translation>Kontrastfüllung je Bild · Bild %1 von %2 · vollstes: %3</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>1 is the most likely way, 2 the next one, and so on.</source>
        <translation>1 ist der wahrscheinlichste Weg, 2 der nächste und so weiter.</translation>
    </message>
    <message>
        <source>Adds the prior chosen above to the attraction.</source>
        <translation>Addiert den oben gewählten Prior zur Anziehung.</translation>
    </message>
    <message>
        <source>Alternates between a few auxiliary points and all points by kernel-weighted PnP (Song, Ghaffari).</source>
        <translation>Wechselt zwischen wenigen Hilfspunkten und allen Punkten, kerngewichtetes PnP (Song, Ghaffari).</translation>
    </message>
    <message>
        <source>Alternating search</source>
        <translation>Wechselnde Suche</translation>
    </message>
    <message>
        <source>Alternation</source>
        <translation>Wechsel</translation>
    </message>
    <message>
        <source>Annealed particles around the start, or a walk over the out-of-plane angles.</source>
        <translation>Abkühlende Partikel um den Start, oder ein Gang über die Winkel aus der Bildebene.</translation>
    </message>
    <message>
        <source>Another number draws other lots; the same repeats them.</source>
        <translation>Eine andere Zahl zieht andere Lose, dieselbe wiederholt sie.</translation>
    </message>
    <message>
        <source>Attracted by</source>
        <translation>Angezogen von</translation>
    </message>
    <message>
        <source>Auxiliary points</source>
        <translation>Hilfspunkte</translation>
    </message>
    <message>
        <source>Best-first search over sequences of matched branches, a pose from each (after Zhu; re-implementation, parameters ours).</source>
        <translation>Suche unter Folgen zugeordneter Äste, die besten zuerst, mit einer Lage zu jeder (nach Zhu; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Brightness under the vessels at their own width, evolution strategy (Jomier 2006; re-implementation, parameters ours).</source>
        <translation>Helligkeit unter den Gefäßen in ihrer eigenen Breite, Evolutionsstrategie (Jomier 2006; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Chosen branches (nodes where none is chosen), nodes, the widest branches up to a third of the length, or random points.</source>
        <translation>Gewählte Äste (Knoten, wo keiner gewählt ist), Knoten, die weitesten Äste bis zu einem Drittel der Länge, oder zufällige Punkte.</translation>
    </message>
    <message>
        <source>Coarse search, then robust point-to-line refinement about the tree&apos;s centroid, with uncertainty.</source>
        <translation>Grobe Suche, dann robuste Punkt-Linien-Verfeinerung um den Schwerpunkt, mit Unsicherheit.</translation>
    </message>
    <message>
        <source>Covariance matrix adaptation, or one parent and one child at a time.</source>
        <translation>Anpassung der Kovarianzmatrix, oder je ein Elter und ein Kind.</translation>
    </message>
    <message>
        <source>Damped steps on the Huber loss with fresh matches, or L-BFGS on the squared distances.</source>
        <translation>Gedämpfte Schritte auf dem Huber-Verlust mit neuen Zuordnungen, oder L-BFGS auf den Abstandsquadraten.</translation>
    </message>
    <message>
        <source>Direction kernel</source>
        <translation>Richtungskern</translation>
    </message>
    <message>
        <source>Directions count</source>
        <translation>Richtungen zählen</translation>
    </message>
    <message>
        <source>Distance between the points of the traced vessels.</source>
        <translation>Abstand der Punkte der erkannten Gefäße.</translation>
    </message>
    <message>
        <source>Distance between the tree points that are matched; smaller is slower.</source>
        <translation>Abstand der zugeordneten Punkte des Gefäßbaums; kleiner ist langsamer.</translation>
    </message>
    <message>
        <source>Distance beyond which a point hardly counts in the end; the noise of the image may widen it.</source>
        <translation>Abstand, ab dem ein Punkt am Ende kaum zählt; Bildrauschen kann ihn weiten.</translation>
    </message>
    <message>
        <source>Distance from which a point&apos;s pull stops growing.</source>
        <translation>Abstand, ab dem der Zug eines Punkts nicht mehr wächst.</translation>
    </message>
    <message>
        <source>Edge scale</source>
        <translation>Kantenskala</translation>
    </message>
    <message>
        <source>Edges found along the vessel walls&apos; normals, a pose chosen by RANSAC with gradient matching (Markelj 2008; re-implementation, parameters ours).</source>
        <translation>Kanten längs der Normalen der Gefäßwände, Lage durch RANSAC mit Gradientenvergleich (Markelj 2008; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Evaluations at most</source>
        <translation>Höchstens Auswertungen</translation>
    </message>
    <message>
        <source>Even spacing</source>
        <translation>Gleiche Abstände</translation>
    </message>
    <message>
        <source>Factor by which the kernel narrows with each step after the first thirty.</source>
        <translation>Faktor, um den der Kern nach den ersten dreißig Schritten mit jedem enger wird.</translation>
    </message>
    <message>
        <source>Final scale</source>
        <translation>Endskala</translation>
    </message>
    <message>
        <source>First kernel width</source>
        <translation>Erste Kernbreite</translation>
    </message>
    <message>
        <source>First reach</source>
        <translation>Erste Reichweite</translation>
    </message>
    <message>
        <source>First reach in the image</source>
        <translation>Erste Reichweite im Bild</translation>
    </message>
    <message>
        <source>Flow steps at most</source>
        <translation>Höchstens Flussschritte</translation>
    </message>
    <message>
        <source>Gradient ascent of the mean kernel between tree and traced vessels, or of the image&apos;s brightness (Aylward 2003; re-implementation, parameters ours).</source>
        <translation>Gradientenaufstieg des mittleren Kerns zwischen Gefäßbaum und erkannten Gefäßen, oder der Bildhelligkeit (Aylward 2003; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Gradient flow of the inner product of tree and traced vessels as functions of the image (Ghaffari 2019; re-implementation, parameters ours).</source>
        <translation>Gradientenfluss des inneren Produkts von Gefäßbaum und erkannten Gefäßen als Funktionen des Bildes (Ghaffari 2019; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Gradient steps at each of the three widths at most.</source>
        <translation>Höchstens so viele Gradientenschritte je Breite (drei Breiten).</translation>
    </message>
    <message>
        <source>How alike directions must be; small is strict.</source>
        <translation>Wie ähnlich Richtungen sein müssen; klein ist streng.</translation>
    </message>
    <message>
        <source>How far a bifurcation or end of the tree and one of the image may lie apart to be the same.</source>
        <translation>Wie weit eine Verzweigung oder ein Ende des Baums und eines im Bild auseinanderliegen dürfen, um dasselbe zu sein.</translation>
    </message>
    <message>
        <source>How far across the ray the search reaches.</source>
        <translation>Wie weit die Suche quer zum Strahl reicht.</translation>
    </message>
    <message>
        <source>How far along the vessel walls&apos; normals edges are sought at first.</source>
        <translation>Wie weit anfangs längs der Normalen der Gefäßwände gesucht wird.</translation>
    </message>
    <message>
        <source>How far branches and the traced vessels that show them may lie apart at first.</source>
        <translation>Wie weit Äste und die erkannten Gefäße, die sie zeigen, anfangs auseinanderliegen dürfen.</translation>
    </message>
    <message>
        <source>How far the mask reaches beyond the projected vessels.</source>
        <translation>Wie weit die Maske über die projizierten Gefäße hinausreicht.</translation>
    </message>
    <message>
        <source>How far the search reaches in LAO/RAO and CRA/CAU.</source>
        <translation>Wie weit die Suche in LAO/RAO und CRA/CAU reicht.</translation>
    </message>
    <message>
        <source>How far the search turns the vessels in the image.</source>
        <translation>Wie weit die Suche die Gefäße im Bild dreht.</translation>
    </message>
    <message>
        <source>How many, where the auxiliary points are random.</source>
        <translation>Wie viele, wenn die Hilfspunkte zufällig sind.</translation>
    </message>
    <message>
        <source>How the pull towards the start pose is weighed against the image.</source>
        <translation>Wie der Zug zur Startlage gegen das Bild gewogen wird.</translation>
    </message>
    <message>
        <source>How they are found: the tree and the grid are exact, the map is right to within three pixels.</source>
        <translation>Wie sie gefunden werden: Baum und Gitter sind genau, die Karte auf drei Pixel.</translation>
    </message>
    <message>
        <source>Huber distance</source>
        <translation>Huber-Abstand</translation>
    </message>
    <message>
        <source>Hypotheses</source>
        <translation>Hypothesen</translation>
    </message>
    <message>
        <source>ICP iterations at most</source>
        <translation>Höchstens ICP-Runden</translation>
    </message>
    <message>
        <source>Image point spacing</source>
        <translation>Punktabstand im Bild</translation>
    </message>
    <message>
        <source>Image points that pull each tree point: the nearest, the five nearest, or all within three kernel widths.</source>
        <translation>Bildpunkte, die an jedem Baumpunkt ziehen: der nächste, die fünf nächsten, oder alle innerhalb dreier Kernbreiten.</translation>
    </message>
    <message>
        <source>Iterations at most</source>
        <translation>Höchstens Iterationen</translation>
    </message>
    <message>
        <source>Keeps the projected tree as wide as the traced vessels; lower it where many branches are missing from the image.</source>
        <translation>Hält den projizierten Baum so weit wie die erkannten Gefäße; senken, wo viele Äste im Bild fehlen.</translation>
    </message>
    <message>
        <source>Keeps the projected tree from shrinking; lower it where many branches are missing from the image.</source>
        <translation>Hindert den projizierten Baum am Schrumpfen; senken, wo viele Äste im Bild fehlen.</translation>
    </message>
    <message>
        <source>Kernel decay</source>
        <translation>Kernabnahme</translation>
    </message>
    <message>
        <source>Kernel width at first: the largest distance, or its square as the paper prints it.</source>
        <translation>Anfängliche Kernbreite: der größte Abstand, oder dessen Quadrat wie im Artikel.</translation>
    </message>
    <message>
        <source>Kernel-weighted iterative PnP on all points (Song, Ghaffari).</source>
        <translation>Kerngewichtetes iteratives PnP auf allen Punkten (Song, Ghaffari).</translation>
    </message>
    <message>
        <source>L2 distance of oriented Gaussian mixtures of tree and traced vessels (Baka 2014; re-implementation, parameters ours).</source>
        <translation>L2-Abstand gerichteter Gauß-Mischungen von Gefäßbaum und erkannten Gefäßen (Baka 2014; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Last kernel width</source>
        <translation>Letzte Kernbreite</translation>
    </message>
    <message>
        <source>Last pose ±, depth</source>
        <translation>Letzte Lage ±, Tiefe</translation>
    </message>
    <message>
        <source>Last pose ±, rotation</source>
        <translation>Letzte Lage ±, Drehung</translation>
    </message>
    <message>
        <source>Last pose ±, shift</source>
        <translation>Letzte Lage ±, Verschiebung</translation>
    </message>
    <message>
        <source>Least Huber loss of the distances to the nearest traced vessel (Rivest-Hénault 2012; re-implementation, parameters ours).</source>
        <translation>Kleinster Huber-Verlust der Abstände zum nächsten erkannten Gefäß (Rivest-Hénault 2012; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Least squares on branches matched by their graphs, then vessels that move with their lengths kept (Groher 2009; re-implementation, parameters ours).</source>
        <translation>Kleinste Quadrate auf Ästen, die nach ihren Graphen zugeordnet sind, danach Gefäße, die sich mit erhaltener Länge bewegen (Groher 2009; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Least squares on nearest pairs by OpenCV&apos;s SQPNP, repeated: what library parts make in an afternoon.</source>
        <translation>Kleinste Quadrate auf nächsten Paaren mit OpenCVs SQPNP, wiederholt: was Bibliotheksteile an einem Nachmittag ergeben.</translation>
    </message>
    <message>
        <source>Let vessels move</source>
        <translation>Gefäße bewegen lassen</translation>
    </message>
    <message>
        <source>Lets the auxiliary and the full problem take turns.</source>
        <translation>Lässt Hilfs- und volles Problem abwechseln.</translation>
    </message>
    <message>
        <source>Lets the auxiliary points and all points take turns.</source>
        <translation>Lässt Hilfspunkte und alle Punkte abwechseln.</translation>
    </message>
    <message>
        <source>Line searches along all six directions.</source>
        <translation>Liniensuchen in allen sechs Richtungen.</translation>
    </message>
    <message>
        <source>Looks for the pose around the start before refining it.</source>
        <translation>Sucht die Lage um den Start, bevor sie verfeinert wird.</translation>
    </message>
    <message>
        <source>Many poses at once, drawn anew by likelihood, or a walk over the out-of-plane angles (after Tian 2022; re-implementation, parameters ours).</source>
        <translation>Viele Lagen zugleich, nach Wahrscheinlichkeit neu gezogen, oder ein Gang über die Winkel aus der Bildebene (nach Tian 2022; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Mask margin</source>
        <translation>Maskenrand</translation>
    </message>
    <message>
        <source>Matching and choosing a pose end after so many rounds.</source>
        <translation>Zuordnen und Wählen enden nach so vielen Runden.</translation>
    </message>
    <message>
        <source>Matching and solving end after so many rounds.</source>
        <translation>Zuordnen und Lösen enden nach so vielen Runden.</translation>
    </message>
    <message>
        <source>Matching branches and fitting the pose end after so many.</source>
        <translation>Zuordnen der Äste und Anpassen der Lage enden nach so vielen.</translation>
    </message>
    <message>
        <source>Moves the branches onto their partners after the rigid fit, lengths kept, and tells how far; the pose stays.</source>
        <translation>Bewegt die Äste nach der starren Anpassung auf ihre Partner, Längen bleiben erhalten, und sagt, wie weit; die Lage bleibt.</translation>
    </message>
    <message>
        <source>NICP inside the alternating search (Song, Ghaffari; re-implementation, parameters ours).</source>
        <translation>NICP in der wechselnden Suche (Song, Ghaffari; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Narrows the kernel after five steps, or once no further point comes within its reach.</source>
        <translation>Verengt den Kern nach fünf Schritten, oder sobald kein weiterer Punkt in Reichweite kommt.</translation>
    </message>
    <message>
        <source>Nearest points</source>
        <translation>Nächste Punkte</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Nachbarn</translation>
    </message>
    <message>
        <source>Off the axis ±</source>
        <translation>Neben der Achse ±</translation>
    </message>
    <message>
        <source>Only a wire or catheter is visible: which way of the tree it takes, and the pose near the last full one.</source>
        <translation>Nur ein Draht oder Katheter ist zu sehen: welchen Weg im Baum er nimmt, und die Lage nahe der letzten vollständigen.</translation>
    </message>
    <message>
        <source>Particles</source>
        <translation>Partikel</translation>
    </message>
    <message>
        <source>Pixels compared</source>
        <translation>Verglichene Pixel</translation>
    </message>
    <message>
        <source>Points attract each other the more, the more alike the vessels run there.</source>
        <translation>Punkte ziehen einander umso stärker an, je gleicher die Gefäße dort laufen.</translation>
    </message>
    <message>
        <source>Population</source>
        <translation>Population</translation>
    </message>
    <message>
        <source>Poses from three random correspondences per round.</source>
        <translation>Lagen aus drei zufälligen Zuordnungen je Runde.</translation>
    </message>
    <message>
        <source>Poses kept per round.</source>
        <translation>Je Runde behaltene Lagen.</translation>
    </message>
    <message>
        <source>Poses tried in all.</source>
        <translation>Insgesamt erprobte Lagen.</translation>
    </message>
    <message>
        <source>Poses tried per generation.</source>
        <translation>Je Generation erprobte Lagen.</translation>
    </message>
    <message>
        <source>Prior</source>
        <translation>Prior</translation>
    </message>
    <message>
        <source>Prior weight</source>
        <translation>Gewicht des Priors</translation>
    </message>
    <message>
        <source>Pull to the start</source>
        <translation>Zug zum Start</translation>
    </message>
    <message>
        <source>Radiographs computed at most.</source>
        <translation>Höchstens berechnete Röntgenbilder.</translation>
    </message>
    <message>
        <source>Random points</source>
        <translation>Zufällige Punkte</translation>
    </message>
    <message>
        <source>Random seed</source>
        <translation>Zufallsstartwert</translation>
    </message>
    <message>
        <source>Rank correlation of the image with radiographs of the CTA or of tubes, Nelder–Mead (Steininger 2012; re-implementation, parameters ours).</source>
        <translation>Rangkorrelation des Bildes mit Röntgenbildern der CTA oder von Röhren, Nelder–Mead (Steininger 2012; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Reach of the attraction at first.</source>
        <translation>Anfängliche Reichweite der Anziehung.</translation>
    </message>
    <message>
        <source>Reach of the attraction in the end.</source>
        <translation>Reichweite der Anziehung am Ende.</translation>
    </message>
    <message>
        <source>Reach of the roots</source>
        <translation>Reichweite der Wurzeln</translation>
    </message>
    <message>
        <source>Rigid only, or an affine stage after it, of which the rigid part is kept if it fits better.</source>
        <translation>Nur starr, oder danach eine affine Stufe, deren starrer Teil bleibt, wenn er besser passt.</translation>
    </message>
    <message>
        <source>Rotation first</source>
        <translation>Zuerst Drehung</translation>
    </message>
    <message>
        <source>Rounds</source>
        <translation>Runden</translation>
    </message>
    <message>
        <source>Rounds at most</source>
        <translation>Höchstens Runden</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suche</translation>
    </message>
    <message>
        <source>Search radius</source>
        <translation>Suchradius</translation>
    </message>
    <message>
        <source>Search roll</source>
        <translation>Suche: Rollen</translation>
    </message>
    <message>
        <source>Search tilt</source>
        <translation>Suche: Kippung</translation>
    </message>
    <message>
        <source>Self term</source>
        <translation>Selbstterm</translation>
    </message>
    <message>
        <source>Sequences of matched branches tried at most.</source>
        <translation>So viele Folgen zugeordneter Äste werden höchstens versucht.</translation>
    </message>
    <message>
        <source>Share of the mask that the rank correlation is taken over; at least 2000 pixels.</source>
        <translation>Anteil der Maske für die Rangkorrelation; mindestens 2000 Pixel.</translation>
    </message>
    <message>
        <source>Smoothing under the gradients of the image.</source>
        <translation>Glättung unter den Bildgradienten.</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Löser</translation>
    </message>
    <message>
        <source>Spread term</source>
        <translation>Weitenterm</translation>
    </message>
    <message>
        <source>Spreads the points evenly before matching; off takes them as they are.</source>
        <translation>Verteilt die Punkte vor dem Zuordnen gleichmäßig; aus nimmt sie, wie sie sind.</translation>
    </message>
    <message>
        <source>Standard deviation of the last full pose across the ray.</source>
        <translation>Standardabweichung der letzten vollständigen Lage quer zum Strahl.</translation>
    </message>
    <message>
        <source>Standard deviation of the last full pose along the ray.</source>
        <translation>Standardabweichung der letzten vollständigen Lage längs des Strahls.</translation>
    </message>
    <message>
        <source>Standard deviation of the last full pose&apos;s angles.</source>
        <translation>Standardabweichung der Winkel der letzten vollständigen Lage.</translation>
    </message>
    <message>
        <source>Standard deviation of the start pose across the ray.</source>
        <translation>Standardabweichung der Startlage quer zum Strahl.</translation>
    </message>
    <message>
        <source>Standard deviation of the start pose along the ray.</source>
        <translation>Standardabweichung der Startlage längs des Strahls.</translation>
    </message>
    <message>
        <source>Standard deviation of the start pose&apos;s angles; holds what the image cannot tell.</source>
        <translation>Standardabweichung der Winkel der Startlage; hält, was das Bild nicht verrät.</translation>
    </message>
    <message>
        <source>Standard deviation of the wire from the vessel&apos;s axis, beside what the vessel&apos;s width lets it.</source>
        <translation>Standardabweichung des Drahts von der Gefäßachse, neben dem, was die Weite des Gefäßes zulässt.</translation>
    </message>
    <message>
        <source>Start depth ±</source>
        <translation>Starttiefe ±</translation>
    </message>
    <message>
        <source>Steps along the flow, at all widths together.</source>
        <translation>Schritte längs des Flusses, alle Breiten zusammen.</translation>
    </message>
    <message>
        <source>Way taken</source>
        <translation>Genommener Weg</translation>
    </message>
    <message>
        <source>Weight of chosen branches</source>
        <translation>Gewicht gewählter Äste</translation>
    </message>
    <message>
        <source>How much the branches chosen as auxiliary count against the fit of all; 1: they are not fitted apart.</source>
        <translation>Wie viel die als Hilfsmenge gewählten Äste gegen die Anpassung aller zählen; 1: sie werden nicht eigens angepasst.</translation>
    </message>
    <message>
        <source>Errors of the geometry</source>
        <translation>Fehler der Geometrie</translation>
    </message>
    <message>
        <source>Whether focal length and principal point may be off by what is usual where they come from, by what is given below, or not at all.</source>
        <translation>Ob Brennweite und Hauptpunkt um so viel falsch sein können, wie es bei ihrer Herkunft üblich ist, um das unten Angegebene, oder gar nicht.</translation>
    </message>
    <message>
        <source>Focal length ±</source>
        <translation>Brennweite ±</translation>
    </message>
    <message>
        <source>Standard deviation of the focal length where it is given.</source>
        <translation>Standardabweichung der Brennweite, wo sie angegeben wird.</translation>
    </message>
    <message>
        <source>Principal point ±</source>
        <translation>Hauptpunkt ±</translation>
    </message>
    <message>
        <source>Standard deviation of each coordinate of the principal point where it is given.</source>
        <translation>Standardabweichung jeder Koordinate des Hauptpunkts, wo sie angegeben wird.</translation>
    </message>
    <message>
        <source>Estimate the geometry</source>
        <translation>Geometrie schätzen</translation>
    </message>
    <message>
        <source>Where the images clearly contradict focal length or principal point, takes over those that they show and registers again.</source>
        <translation>Wo die Bilder Brennweite oder Hauptpunkt klar widersprechen, werden die übernommen, die sie zeigen, und es wird noch einmal registriert.</translation>
    </message>
    <message>
        <source>Mirrored and turned images</source>
        <translation>Gespiegelte und gedrehte Bilder</translation>
    </message>
    <message>
        <source>Where a fit is in doubt, tells whether the image looks mirrored or turned.</source>
        <translation>Sagt, wo eine Anpassung zweifelhaft ist, ob das Bild gespiegelt oder gedreht aussieht.</translation>
    </message>
    <message>
        <source>Bent vessels</source>
        <translation>Verbogene Gefäße</translation>
    </message>
    <message>
        <source>Whether the vessels are bent onto the image after the rigid registration: never, where the fit looks as if they were bent (angiopose, nothing locked), or always.</source>
        <translation>Ob die Gefäße nach der starren Registrierung auf das Bild gebogen werden: nie, wo die Anpassung so aussieht, als wären sie verbogen (angiopose, nichts festgehalten), oder immer.</translation>
    </message>
    <message>
        <source>Start rotation ±</source>
        <translation>Startdrehung ±</translation>
    </message>
    <message>
        <source>Start scale</source>
        <translation>Startskala</translation>
    </message>
    <message>
        <source>Start shift ±</source>
        <translation>Startversatz ±</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Steps per width</source>
        <translation>Schritte je Breite</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Strategie</translation>
    </message>
    <message>
        <source>Strength of the pull towards the start pose.</source>
        <translation>Stärke des Zugs zur Startlage.</translation>
    </message>
    <message>
        <source>The refinement ends after so many steps.</source>
        <translation>Die Verfeinerung endet nach so vielen Schritten.</translation>
    </message>
    <message>
        <source>The spread narrows by a quarter in each.</source>
        <translation>Die Streuung nimmt in jeder um ein Viertel ab.</translation>
    </message>
    <message>
        <source>The traced vessels, or the brightness of the image at each vessel&apos;s own width.</source>
        <translation>Die erkannten Gefäße, oder die Bildhelligkeit in der Breite jedes Gefäßes.</translation>
    </message>
    <message>
        <source>Transformation</source>
        <translation>Transformation</translation>
    </message>
    <message>
        <source>Tree point spacing</source>
        <translation>Punktabstand im Baum</translation>
    </message>
    <message>
        <source>Turns about the source before all else.</source>
        <translation>Dreht vor allem anderen um den Fokus.</translation>
    </message>
    <message>
        <source>Turns and shifts in balance, or raw radians beside millimetres, which hardly shifts.</source>
        <translation>Drehung und Verschiebung ausgewogen, oder Bogenmaß neben Millimetern, was kaum verschiebt.</translation>
    </message>
    <message>
        <source>Vessel walls against image gradients, Powell&apos;s method (Mitrović 2013; re-implementation, parameters ours).</source>
        <translation>Gefäßwände gegen Bildgradienten, Powell-Verfahren (Mitrović 2013; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Width of the mixtures&apos; Gaussians at first.</source>
        <translation>Anfängliche Breite der Gauß-Mischungen.</translation>
    </message>
    <message>
        <source>Width of the mixtures&apos; Gaussians in the end.</source>
        <translation>Breite der Gauß-Mischungen am Ende.</translation>
    </message>
    <message>
        <source>affine</source>
        <translation>affin</translation>
    </message>
    <message>
        <source>auxiliary</source>
        <translation>Hilfsäste</translation>
    </message>
    <message>
        <source>converged</source>
        <translation>konvergiert</translation>
    </message>
    <message>
        <source>full</source>
        <translation>alle Punkte</translation>
    </message>
    <message>
        <source>iteration limit</source>
        <translation>Iterationsgrenze</translation>
    </message>
    <message>
        <source>no improvement</source>
        <translation>keine Verbesserung</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>Gemeinsam</translation>
    </message>
    <message>
        <source>refine</source>
        <translation>Verfeinern</translation>
    </message>
    <message>
        <source>rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>search</source>
        <translation>Suche</translation>
    </message>
    <message>
        <source>settle</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>bending</source>
        <translation>Biegen</translation>
    </message>
    <message>
        <source>stopped by the user</source>
        <translation>von Hand angehalten</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>gewählte</translation>
    </message>
    <message>
        <source>closest</source>
        <translation>nächster</translation>
    </message>
    <message>
        <source>cma-es</source>
        <translation>CMA-ES</translation>
    </message>
    <message>
        <source>five</source>
        <translation>fünf</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>halving</source>
        <translation>Halbierung</translation>
    </message>
    <message>
        <source>image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>kd-tree</source>
        <translation>k-d-Baum</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>größter</translation>
    </message>
    <message>
        <source>largest squared</source>
        <translation>größter im Quadrat</translation>
    </message>
    <message>
        <source>lbfgs</source>
        <translation>L-BFGS</translation>
    </message>
    <message>
        <source>literal</source>
        <translation>wörtlich</translation>
    </message>
    <message>
        <source>lm</source>
        <translation>LM</translation>
    </message>
    <message>
        <source>main branches</source>
        <translation>Hauptäste</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>always</source>
        <translation>immer</translation>
    </message>
    <message>
        <source>by origin</source>
        <translation>nach Herkunft</translation>
    </message>
    <message>
        <source>given</source>
        <translation>gegeben</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>metric</source>
        <translation>metrisch</translation>
    </message>
    <message>
        <source>nodes</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>on</source>
        <translation>an</translation>
    </message>
    <message>
        <source>one plus one</source>
        <translation>eins plus eins</translation>
    </message>
    <message>
        <source>out of plane</source>
        <translation>aus der Ebene</translation>
    </message>
    <message>
        <source>particles</source>
        <translation>Partikel</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>random</source>
        <translation>zufällig</translation>
    </message>
    <message>
        <source>rigid</source>
        <translation>starr</translation>
    </message>
    <message>
        <source>seed mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>seed metric</source>
        <translation>metrisch</translation>
    </message>
    <message>
        <source>seed noprior</source>
        <translation>ohne Prior</translation>
    </message>
    <message>
        <source>seed sum</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>stagnation</source>
        <translation>Stillstand</translation>
    </message>
    <message>
        <source>traced vessels</source>
        <translation>erkannte Gefäße</translation>
    </message>
</context>
<context>
    <name>angiopose::app::AngleController</name>
    <message>
        <source>Angles that show %1</source>
        <translation>Winkel, aus denen %1 zu sehen ist</translation>
    </message>
    <message>
        <source>No branch</source>
        <translation>Kein Ast</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::AngleDialog</name>
    <message>
        <source>Only where it takes off, 10 mm around</source>
        <translation>Nur wo er abgeht, 10 mm ringsum</translation>
    </message>
    <message>
        <source>C-arm angles</source>
        <translation>C-Bogen-Winkel</translation>
    </message>
    <message>
        <source>Blue: seen at full length and clear of other vessels. Amber: foreshortened or hidden.</source>
        <translation>Blau: in ganzer Länge und frei von anderen Gefäßen zu sehen. Orange: verkürzt oder verdeckt.</translation>
    </message>
    <message>
        <source>Where the gantry stood for this image.</source>
        <translation>Wo der C-Bogen bei diesem Bild stand.</translation>
    </message>
    <message>
        <source>The gantry reaches</source>
        <translation>Der C-Bogen erreicht</translation>
    </message>
    <message>
        <source>Now: %1</source>
        <translation>Jetzt: %1</translation>
    </message>
    <message>
        <source>%1: foreshortened by %2 %, covered by other vessels %3 %</source>
        <translation>%1: um %2 % verkürzt, zu %3 % von anderen Gefäßen verdeckt</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::AngleMapPlot</name>
    <message>
        <source>Map of the gantry&apos;s angles</source>
        <translation>Karte der C-Bogen-Winkel</translation>
    </message>
    <message>
        <source>no map yet</source>
        <translation>noch keine Karte</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SimulatedView</name>
    <message>
        <source>The vessels from these angles</source>
        <translation>Die Gefäße aus diesen Winkeln</translation>
    </message>
</context>
<context>
    <name>messages</name>
    <message>
        <source>The camera or pose has an entry that is not a finite number. Export it again.</source>
        <comment>projection.not-finite</comment>
        <translation>Kamera oder Lage haben einen Eintrag, der keine endliche Zahl ist. Neu exportieren.</translation>
    </message>
    <message>
        <source>The left 3 x 3 part of the projection matrix has no inverse, so that it is no X-ray camera. Export it again.</source>
        <comment>projection.degenerate</comment>
        <translation>Der linke 3 x 3-Teil der Projektionsmatrix hat keine Inverse, sie ist also keine Röntgenkamera. Neu exportieren.</translation>
    </message>
    <message>
        <source>The pixels of the camera are not at right angles (a skew of %1). Give a camera without skew, or resample the image.</source>
        <comment>projection.skewed</comment>
        <translation>Die Pixel der Kamera stehen nicht im rechten Winkel (Scherung von %1). Eine Kamera ohne Scherung angeben oder das Bild umrechnen.</translation>
    </message>
    <message>
        <source>K must hold focal lengths and principal point only: fx 0 cx, 0 fy cy, 0 0 1. Is it transposed?</source>
        <comment>projection.intrinsics</comment>
        <translation>K darf nur Brennweiten und Hauptpunkt enthalten: fx 0 cx, 0 fy cy, 0 0 1. Ist sie transponiert?</translation>
    </message>
    <message>
        <source>R is not a rotation (scale or shear). Give a rigid pose in mm.</source>
        <comment>projection.no-rotation</comment>
        <translation>R ist keine Drehung (Skalierung oder Scherung). Eine starre Lage in mm angeben.</translation>
    </message>
    <message>
        <source>it holds no camera with its pose. Give P (3 x 4), or K (3 x 3), R (3 x 3, or rvec) and t (3).</source>
        <comment>exchange.no-pose</comment>
        <translation>enthält keine Kamera mit ihrer Lage. P (3 x 4) angeben, oder K (3 x 3), R (3 x 3 oder rvec) und t (3).</translation>
    </message>
    <message>
        <source>it holds %1 numbers. P = K [R t] has 12 (three rows of four), a pose cameraFromPatient 16.</source>
        <comment>exchange.numbers</comment>
        <translation>enthält %1 Zahlen. P = K [R t] hat 12 (drei Zeilen zu vier), eine Lage cameraFromPatient 16.</translation>
    </message>
    <message>
        <source>its camera bends straight lines (distortion coefficients). Undistort the image, then give a camera without them.</source>
        <comment>exchange.distorted</comment>
        <translation>die Kamera krümmt gerade Linien (Verzeichnungskoeffizienten). Das Bild entzerren, dann eine Kamera ohne sie angeben.</translation>
    </message>
    <message>
        <source>a pose in this form needs its camera. Give one: a case, or a pose with a camera.</source>
        <comment>exchange.no-camera</comment>
        <translation>in dieser Form braucht eine Lage ihre Kamera. Eine angeben: einen Fall, oder eine Lage mit Kamera.</translation>
    </message>
    <message>
        <source>a camera with its pose is written as .json, .txt, .yml, .yaml or .xml. Change the extension.</source>
        <comment>exchange.extension</comment>
        <translation>eine Kamera mit ihrer Lage wird als .json, .txt, .yml, .yaml oder .xml geschrieben. Die Endung ändern.</translation>
    </message>
    <message>
        <source>this is a file of PyTorch, which can run programs when it is read. Write its pose as JSON first (FORMATS §3.4).</source>
        <comment>exchange.pickle</comment>
        <translation>das ist eine Datei von PyTorch, die beim Lesen Programme ausführen kann. Ihre Lage erst als JSON schreiben (FORMATS §3.4).</translation>
    </message>
    <message>
        <source>it is no view of DiffDRR: %1 is missing or wrong. FORMATS §3.4 names the keys.</source>
        <comment>exchange.diffdrr-keys</comment>
        <translation>ist keine Ansicht von DiffDRR: %1 fehlt oder ist falsch. FORMATS §3.4 nennt die Schlüssel.</translation>
    </message>
    <message>
        <source>it holds no fiducials. Export the points of a markups node.</source>
        <comment>fiducials.none</comment>
        <translation>enthält keine Punkte. Die Punkte eines Markups-Knotens exportieren.</translation>
    </message>
    <message>
        <source>line %1 holds no point (id,x,y,z,…). Export the points again.</source>
        <comment>fiducials.line</comment>
        <translation>Zeile %1 enthält keinen Punkt (id,x,y,z,…). Die Punkte neu exportieren.</translation>
    </message>
    <message>
        <source>its coordinate system is %1, not LPS or RAS. Export the points in patient coordinates.</source>
        <comment>fiducials.system</comment>
        <translation>das Koordinatensystem ist %1, nicht LPS oder RAS. Die Punkte in Patientenkoordinaten exportieren.</translation>
    </message>
    <message>
        <source>points are written as .fcsv or .mrk.json. Change the extension.</source>
        <comment>fiducials.extension</comment>
        <translation>Punkte werden als .fcsv oder .mrk.json geschrieben. Die Endung ändern.</translation>
    </message>
    <message>
        <source>%1 is a pose or holds points. Open it by itself while the case that it belongs to is open.</source>
        <comment>open.pose-alone</comment>
        <translation>%1 ist eine Lage oder enthält Punkte. Für sich öffnen, während der zugehörige Fall offen ist.</translation>
    </message>
    <message>
        <source>The pose brings a camera that is not the one of the case. The picture is drawn by its own.</source>
        <comment>pose.other-camera</comment>
        <translation>Die Lage bringt eine andere Kamera als die des Falls mit. Das Bild wird mit ihrer eigenen gezeichnet.</translation>
    </message>
    <message>
        <source>The pose is of an image of %1 x %2 px, the angiogram has %3 x %4. Choose the pose of this image.</source>
        <comment>pose.other-image</comment>
        <translation>Die Lage gehört zu einem Bild von %1 x %2 px, das Angiogramm hat %3 x %4. Die Lage dieses Bildes wählen.</translation>
    </message>
    <message>
        <source>the case has no landmarks, check points or rings. Set some in the window first.</source>
        <comment>convert.no-points</comment>
        <translation>der Fall hat keine Landmarken, Prüfpunkte oder Ringe. Erst welche im Fenster setzen.</translation>
    </message>
    <message>
        <source>The pose is taken as of a detector at negative z without an extrinsic matrix, as xReg has X-ray runs. Give --camera if the image is mirrored.</source>
        <comment>convert.xreg-guessed</comment>
        <translation>Die Lage gilt als die eines Detektors bei negativem z ohne extrinsische Matrix, wie xReg Röntgenserien hat. Ist das Bild gespiegelt, --camera angeben.</translation>
    </message>
    <message>
        <source>the system gives no random numbers, so that nothing could be kept secret.</source>
        <comment>deidentify.no-random-key</comment>
        <translation>das System gibt keine Zufallszahlen, sodass nichts geheim bliebe.</translation>
    </message>
    <message>
        <source>Letters are drawn into the picture, at column %1, row %2 and elsewhere: read them, or have them blacked out.</source>
        <comment>deidentify.letters-stay</comment>
        <translation>In das Bild sind Buchstaben gezeichnet, bei Spalte %1, Zeile %2 und anderswo: lesen oder schwärzen lassen.</translation>
    </message>
    <message>
        <source>Letters drawn into the picture were blacked out (%1 % of its area). Look whether all are gone.</source>
        <comment>deidentify.letters-blacked-out</comment>
        <translation>In das Bild gezeichnete Buchstaben wurden geschwärzt (%1 % seiner Fläche). Prüfen, ob alle weg sind.</translation>
    </message>
    <message>
        <source>The header says that identity is drawn into the picture, and no letters were found in it: look at every frame.</source>
        <comment>deidentify.letters-declared</comment>
        <translation>Laut Kopfdaten steht eine Identität im Bild, doch Buchstaben wurden nicht gefunden: jedes Einzelbild ansehen.</translation>
    </message>
    <message>
        <source>The colours became grey, as the program shows them.</source>
        <comment>deidentify.colour-dropped</comment>
        <translation>Die Farben wurden grau, wie das Programm sie zeigt.</translation>
    </message>
    <message>
        <source>Damaged frames were stored as they could be decoded: %1 of %2.</source>
        <comment>deidentify.frames-damaged</comment>
        <translation>Beschädigte Einzelbilder wurden gespeichert, soweit sie zu decodieren waren: %1 von %2.</translation>
    </message>
    <message>
        <source>Files that hold no image were left out: %1 of %2.</source>
        <comment>deidentify.files-left-out</comment>
        <translation>Dateien ohne Bild wurden ausgelassen: %1 von %2.</translation>
    </message>
    <message>
        <source>its segments are stored in a way that cannot be stored again. Convert it to .nii.gz or .nrrd: labels have no names there.</source>
        <comment>deidentify.segmentation</comment>
        <translation>seine Segmente sind so gespeichert, dass sie sich nicht wieder speichern lassen. In .nii.gz oder .nrrd umwandeln: Dort haben Label keine Namen.</translation>
    </message>
    <message>
        <source>its compressed pixels of 32 bits cannot be stored again. Convert it to .nii.gz or .nrrd.</source>
        <comment>deidentify.pixels-too-wide</comment>
        <translation>ihre komprimierten Pixel mit 32 Bit lassen sich nicht neu speichern. In .nii.gz oder .nrrd umwandeln.</translation>
    </message>
    <message>
        <source>only PNG, JPEG, TIFF and DICOM pictures can be freed of what is written beside the pixels. Save it as PNG.</source>
        <comment>deidentify.picture</comment>
        <translation>nur PNG-, JPEG-, TIFF- und DICOM-Bilder lassen sich von dem befreien, was neben den Pixeln steht. Als PNG speichern.</translation>
    </message>
    <message>
        <source>the folder is not empty. Choose a new one, so that nothing else is handed on with it.</source>
        <comment>deidentify.output-not-empty</comment>
        <translation>der Ordner ist nicht leer. Einen neuen wählen, damit nichts anderes mitgegeben wird.</translation>
    </message>
    <message>
        <source>it holds no DICOM image. Choose the folder of one study.</source>
        <comment>deidentify.nothing</comment>
        <translation>es enthält kein DICOM-Bild. Den Ordner einer Studie wählen.</translation>
    </message>
    <message>
        <source>an input of the case could not be read and is not in the archive: %1</source>
        <comment>pack.input-missing</comment>
        <translation>eine Eingabe des Falls war nicht lesbar und fehlt im Archiv: %1</translation>
    </message>
    <message>
        <source>a case is packed as .zip. Give the file that ending.</source>
        <comment>pack.format</comment>
        <translation>ein Fall wird als .zip gepackt. Der Datei diese Endung geben.</translation>
    </message>
    <message>
        <source>the archive cannot be written (%1). Choose another folder or make room.</source>
        <comment>pack.not-written</comment>
        <translation>das Archiv lässt sich nicht schreiben (%1). Einen anderen Ordner wählen oder Platz schaffen.</translation>
    </message>
    <message>
        <source>Names, notes and texts typed by hand were taken out: %1. Numbers stand in their places.</source>
        <comment>pack.texts-cleared</comment>
        <translation>Von Hand geschriebene Namen, Notizen und Texte wurden entfernt: %1. An ihrer Stelle stehen Nummern.</translation>
    </message>
    <message>
        <source>the packed case does not open as the one it came from: %1 Nothing was written.</source>
        <comment>pack.differs</comment>
        <translation>der gepackte Fall öffnet sich nicht wie der ursprüngliche: %1 Nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Branches keep their names: look whether they name anatomy alone.</source>
        <comment>pack.branch-names</comment>
        <translation>Äste behalten ihre Namen: prüfen, ob sie nur Anatomie benennen.</translation>
    </message>
    <message>
        <source>a view is missing.</source>
        <comment>pack.views</comment>
        <translation>eine Ansicht fehlt.</translation>
    </message>
    <message>
        <source>the pixels of an image differ.</source>
        <comment>pack.pixels</comment>
        <translation>die Pixel eines Bildes weichen ab.</translation>
    </message>
    <message>
        <source>a result does not hold.</source>
        <comment>pack.results</comment>
        <translation>ein Ergebnis gilt nicht.</translation>
    </message>
    <message>
        <source>the vessels differ.</source>
        <comment>pack.vessels</comment>
        <translation>die Gefäße weichen ab.</translation>
    </message>
    <message>
        <source>a key needs at least 16 bytes. Make one: head -c 32 /dev/urandom &gt; key</source>
        <comment>deidentify.key-too-short</comment>
        <translation>ein Schlüssel braucht mindestens 16 Byte. Einen erzeugen: head -c 32 /dev/urandom &gt; key</translation>
    </message>
    <message>
        <source>without identity this input becomes a file with the ending %1, or, for a folder, a folder. Name OUT so.</source>
        <comment>deidentify.kind</comment>
        <translation>ohne Identität wird diese Eingabe zu einer Datei mit der Endung %1, ein Ordner zu einem Ordner. OUT so benennen.</translation>
    </message>
    <message>
        <source>it is a TIFF whose pixels cannot be stored again bit by bit (only grey, palette or RGB of 8 or 16 bits or float, in strips). Save it as PNG.</source>
        <comment>deidentify.tiff</comment>
        <translation>es ist ein TIFF, dessen Pixel sich nicht Bit für Bit wieder speichern lassen (nur Grau, Palette oder RGB mit 8 oder 16 Bit oder Gleitkomma, in Streifen). Als PNG speichern.</translation>
    </message>
    <message>
        <source>it is a document (PDF), whose pages may show names anywhere. Make it anew from a case without identity.</source>
        <comment>deidentify.pages</comment>
        <translation>es ist ein Dokument (PDF), dessen Seiten überall Namen zeigen können. Es aus einem Fall ohne Identität neu machen.</translation>
    </message>
    <message>
        <source>objects of this kind (class %1) hold what cannot be cleared for sure. Leave it out.</source>
        <comment>deidentify.object</comment>
        <translation>Objekte dieser Art (Klasse %1) enthalten, was sich nicht sicher tilgen lässt. Es weglassen.</translation>
    </message>
    <message>
        <source>it says that it is no image (class %1) but holds one, which would be lost. Export it again, or leave it out.</source>
        <comment>deidentify.object-with-pixels</comment>
        <translation>es gibt an, kein Bild zu sein (Klasse %1), enthält aber eines, das verloren ginge. Es erneut exportieren oder weglassen.</translation>
    </message>
    <message>
        <source>Words in a report, segmentation or presentation state were taken out, codes and numbers stayed: %1.</source>
        <comment>deidentify.words-cleared</comment>
        <translation>Worte eines Befunds, einer Segmentierung oder eines Darstellungszustands wurden entfernt, Kodes und Zahlen blieben: %1.</translation>
    </message>
    <message>
        <source>It may as well take %1 (%2).</source>
        <comment>wire.may-follow</comment>
        <translation>Ebenso kann er %1 nehmen (%2).</translation>
    </message>
    <message>
        <source>No way through the vessel tree is likely: the best has a probability of %1.</source>
        <comment>wire.unlikely</comment>
        <translation>Kein Weg durch den Gefäßbaum ist wahrscheinlich: der beste hat eine Wahrscheinlichkeit von %1.</translation>
    </message>
    <message>
        <source>Only %1 of the wire lies along the vessel tree.</source>
        <comment>wire.off-tree</comment>
        <translation>Nur %1 des Drahts liegen längs des Gefäßbaums.</translation>
    </message>
    <message>
        <source>The traced curves make no single line: %1 of it are gaps. Take out the curves that are no wire.</source>
        <comment>wire.in-pieces</comment>
        <translation>Die erkannten Kurven ergeben keine einzelne Linie: %1 davon sind Lücken. Nehmen Sie die Kurven heraus, die kein Draht sind.</translation>
    </message>
    <message>
        <source>The wire lies along no way of the vessel tree near the start pose. Start from the last full registration, or let it be off by more.</source>
        <comment>wire.nowhere</comment>
        <translation>Der Draht liegt nahe der Startlage längs keines Wegs im Gefäßbaum. Beginnen Sie mit der letzten vollständigen Registrierung, oder lassen Sie größere Abweichungen zu.</translation>
    </message>
    <message>
        <source>The wire takes the branches %1 with a probability of %2; it lies %3 off their axes.</source>
        <comment>wire.follows</comment>
        <translation>Der Draht nimmt mit einer Wahrscheinlichkeit von %2 die Äste %1; er liegt %3 neben ihren Achsen.</translation>
    </message>
    <message>
        <source>There are %1 likely ways: the most likely one is taken instead of the one asked for.</source>
        <comment>wire.fewer-ways</comment>
        <translation>Es gibt %1 wahrscheinliche Wege: statt des verlangten wird der wahrscheinlichste genommen.</translation>
    </message>
    <message>
        <source>pictures are written as .png or .svg, and by the window as .pdf. Choose one of these.</source>
        <comment>picture.kind</comment>
        <translation>Bilder werden als .png oder .svg geschrieben, vom Fenster auch als .pdf. Eines davon wählen.</translation>
    </message>
    <message>
        <source>Grey values of 16 bit are written as .png alone.</source>
        <comment>picture.grey-kind</comment>
        <translation>Grauwerte mit 16 Bit werden nur als .png geschrieben.</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; cannot be made: %2.</source>
        <comment>folder.not-made</comment>
        <translation>Der Ordner „%1“ lässt sich nicht anlegen: %2.</translation>
    </message>
    <message>
        <source>Unexpected failure: %1</source>
        <comment>run.unexpected-failure</comment>
        <translation>Unerwarteter Fehler: %1</translation>
    </message>
    <message>
        <source>there is no setting &apos;%1&apos;. The nearest are: %2.</source>
        <comment>setting.unknown</comment>
        <translation>es gibt keine Einstellung „%1“. Am nächsten kommen: %2.</translation>
    </message>
    <message>
        <source>the setting %1 cannot be &apos;%2&apos;: %3</source>
        <comment>setting.value</comment>
        <translation>die Einstellung %1 kann nicht „%2“ sein: %3</translation>
    </message>
    <message>
        <source>a batch needs a header row with the column case, or with vessels and angiogram, and a row for each case.</source>
        <comment>batch.header-missing</comment>
        <translation>ein Stapel braucht eine Kopfzeile mit der Spalte case, oder mit vessels und angiogram, und eine Zeile für jeden Fall.</translation>
    </message>
    <message>
        <source>line %1, column %2: %3</source>
        <comment>batch.cell</comment>
        <translation>Zeile %1, Spalte %2: %3</translation>
    </message>
    <message>
        <source>line %1 names a case and inputs beside it. Name either the case, or its vessels and its angiogram.</source>
        <comment>batch.not-both</comment>
        <translation>Zeile %1 nennt einen Fall und daneben Eingaben. Nennen Sie entweder den Fall, oder seine Gefäße und sein Angiogramm.</translation>
    </message>
    <message>
        <source>line %1 names too little. Name a case, or both vessels and an angiogram.</source>
        <comment>batch.inputs-lack</comment>
        <translation>Zeile %1 nennt zu wenig. Nennen Sie einen Fall, oder sowohl Gefäße als auch ein Angiogramm.</translation>
    </message>
    <message>
        <source>line %1: the seeds &apos;%2&apos; are no points. Write x y z in mm (LPS), and &apos;;&apos; between points.</source>
        <comment>batch.seeds-unclear</comment>
        <translation>Zeile %1: Die Startpunkte „%2“ sind keine Punkte. Schreiben Sie x y z in mm (LPS), und „;“ zwischen Punkten.</translation>
    </message>
    <message>
        <source>the program that worked on it ended before its time (%1). What was written of it is not kept.</source>
        <comment>batch.crashed</comment>
        <translation>das Programm, das daran arbeitete, endete vor der Zeit (%1). Was davon geschrieben war, wird nicht behalten.</translation>
    </message>
    <message>
        <source>it took longer than %1 and was ended. Give it more time with --time-limit.</source>
        <comment>batch.out-of-time</comment>
        <translation>er brauchte länger als %1 und wurde beendet. Geben Sie ihm mit --time-limit mehr Zeit.</translation>
    </message>
    <message>
        <source>the program that works on the cases, %1, cannot be started.</source>
        <comment>batch.no-worker</comment>
        <translation>das Programm, das die Fälle bearbeitet, %1, lässt sich nicht starten.</translation>
    </message>
    <message>
        <source>it holds %1 series. Name a file of one of them, or a case that names the series.</source>
        <comment>batch.several-series</comment>
        <translation>es enthält %1 Serien. Nennen Sie eine Datei einer davon, oder einen Fall, der die Serie nennt.</translation>
    </message>
    <message>
        <source>its vessels are %1 units across, which are hardly millimetres. Name a case that tells the unit.</source>
        <comment>batch.unit-unclear</comment>
        <translation>seine Gefäße messen %1 Einheiten, was kaum Millimeter sind. Nennen Sie einen Fall, der die Einheit angibt.</translation>
    </message>
    <message>
        <source>no folder holds an outcome of this row. Run it, with --resume.</source>
        <comment>batch.row-missing</comment>
        <translation>kein Ordner enthält ein Ergebnis dieser Zeile. Führen Sie sie mit --resume aus.</translation>
    </message>
    <message>
        <source>the outcomes of %1 and %2 come from other settings or another version. Merge what was run alike.</source>
        <comment>batch.merge-differs</comment>
        <translation>die Ergebnisse von %1 und %2 stammen aus anderen Einstellungen oder einer anderen Version. Führen Sie zusammen, was gleich ausgeführt wurde.</translation>
    </message>
    <message>
        <source>nothing has been registered in this case: its vessels are where they start. Give --register, or --from with a result; --start-pose where the start itself is wanted.</source>
        <comment>dicom-export.at-start</comment>
        <translation>in diesem Fall wurde nichts registriert: Seine Gefäße sind, wo sie beginnen. Geben Sie --register an, oder --from mit einem Ergebnis; --start-pose, wenn die Startlage selbst gewünscht ist.</translation>
    </message>
    <message>
        <source>Nothing has been registered in this case: its vessels are drawn where they start. Register it with --save, or give --pose or --from.</source>
        <comment>command.drawn-at-start</comment>
        <translation>In diesem Fall wurde nichts registriert: Seine Gefäße sind in der Startlage gezeichnet. Registrieren Sie ihn mit --save, oder geben Sie --pose oder --from an.</translation>
    </message>
    <message>
        <source>at the start pose: nothing registered</source>
        <comment>pose.at-start</comment>
        <translation>in der Startlage: nichts registriert</translation>
    </message>
    <message>
        <source>it is no result of a registration. Give a result.json or joint.json that `register` or `batch` wrote.</source>
        <comment>result.not-one</comment>
        <translation>das ist kein Ergebnis einer Registrierung. Geben Sie eine result.json oder joint.json an, die `register` oder `batch` geschrieben hat.</translation>
    </message>
    <message>
        <source>it does not hold what it was found from: an earlier version found it, or its registration estimated the geometry. Register its case instead.</source>
        <comment>result.without-case</comment>
        <translation>es enthält nicht, woraus es gefunden wurde: Eine frühere Version hat es gefunden, oder seine Registrierung hat die Geometrie geschätzt. Registrieren Sie stattdessen seinen Fall.</translation>
    </message>
    <message>
        <source>its input %1 is nowhere to be found with the content that it was found from (SHA-256 %2). Name the folder that it lies in with --inputs.</source>
        <comment>result.input-missing</comment>
        <translation>seine Eingabe %1 ist nirgends mit dem Inhalt zu finden, aus dem es gefunden wurde (SHA-256 %2). Nennen Sie mit --inputs den Ordner, in dem sie liegt.</translation>
    </message>
    <message>
        <source>its input %1 has other content than it was found from. Name the folder of the right one with --inputs.</source>
        <comment>result.input-changed</comment>
        <translation>seine Eingabe %1 hat anderen Inhalt als der, aus dem es gefunden wurde. Nennen Sie mit --inputs den Ordner der richtigen.</translation>
    </message>
    <message>
        <source>--shard needs a part and a number of parts such as 2/4, not &apos;%1&apos;.</source>
        <comment>command.shard-unclear</comment>
        <translation>--shard braucht einen Teil und die Zahl der Teile wie 2/4, nicht „%1“.</translation>
    </message>
    <message>
        <source>There is no degree of freedom &apos;%1&apos; to lock. Use %2, or none.</source>
        <comment>command.no-such-freedom</comment>
        <translation>Es gibt keinen Freiheitsgrad „%1“ zum Sperren. Möglich: %2 oder none.</translation>
    </message>
    <message>
        <source>no bent vessels are known of its pose. Register it where they look bent, or with the option deformable=always.</source>
        <comment>command.no-bent-vessels</comment>
        <translation>zu seiner Lage sind keine gebogenen Gefäße bekannt. Registrieren Sie ihn, wo sie gebogen aussehen, oder mit der Option deformable=always.</translation>
    </message>
    <message>
        <source>the image of this view could not be read.</source>
        <comment>command.view-image-unread</comment>
        <translation>das Bild dieser Ansicht konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The folders to merge hold runs of &apos;%1&apos;, not of &apos;%2&apos;.</source>
        <comment>command.merge-of-others</comment>
        <translation>Die zu vereinenden Ordner enthalten Läufe von „%1“, nicht von „%2“.</translation>
    </message>
    <message>
        <source>it holds no centrelines yet. Trace them: angiopose-cli trace-vessel %1 --output %2.</source>
        <comment>convert.no-curves</comment>
        <translation>enthält noch keine Mittellinien. Gefäße verfolgen mit: angiopose-cli trace-vessel %1 --output %2.</translation>
    </message>
    <message>
        <source>it is neither a volume nor a surface, so it makes no volume. Choose a scan (DICOM, NIfTI, NRRD, MetaImage) or a surface, or give another output name.</source>
        <comment>convert.no-volume</comment>
        <translation>ist weder Volumen noch Oberfläche und ergibt daher kein Volumen. CT-Daten (DICOM, NIfTI, NRRD, MetaImage) oder eine Oberfläche wählen, oder einen anderen Ausgabenamen angeben.</translation>
    </message>
    <message>
        <source>the extension is none that is written. Centrelines: .vtp, .csv, .swc, .mrk.json; volumes: .nii, .nii.gz, .nrrd, .mha; surfaces: .stl; poses: .json, .tfm, .h5; X-ray runs: .dcm.</source>
        <comment>convert.extension</comment>
        <translation>diese Endung wird nicht geschrieben. Mittellinien: .vtp, .csv, .swc, .mrk.json; Volumen: .nii, .nii.gz, .nrrd, .mha; Oberflächen: .stl; Lagen: .json, .tfm, .h5; Röntgenaufnahmen: .dcm.</translation>
    </message>
    <message>
        <source>this is the input, which is never overwritten. Choose another name.</source>
        <comment>convert.onto-input</comment>
        <translation>das ist die Eingabe, die nie überschrieben wird. Einen anderen Namen wählen.</translation>
    </message>
    <message>
        <source>it is no label image, so it has no labels. Leave --label out, or choose a segmentation.</source>
        <comment>trace.no-labels</comment>
        <translation>ist kein Label-Bild und hat daher keine Labels. --label weglassen oder eine Segmentierung wählen.</translation>
    </message>
    <message>
        <source>it holds centrelines already, which need no tracing. `convert` changes their format.</source>
        <comment>trace.centrelines</comment>
        <translation>enthält schon Mittellinien, die nicht verfolgt werden müssen. `convert` ändert ihr Format.</translation>
    </message>
    <message>
        <source>it cannot be traced. Choose another surface.</source>
        <comment>trace.other-surface</comment>
        <translation>lässt sich nicht verfolgen. Eine andere Oberfläche wählen.</translation>
    </message>
    <message>
        <source>thin vessels are told by the values of a scan, and this has none. Leave --tubes out.</source>
        <comment>trace.tubes-of-mask</comment>
        <translation>dünne Gefäße zeigen sich an den Werten eines Scans, und hier sind keine. Lassen Sie --tubes weg.</translation>
    </message>
    <message>
        <source>it cannot be traced. Choose a scan.</source>
        <comment>trace.no-scan</comment>
        <translation>lässt sich nicht verfolgen. CT-Daten wählen.</translation>
    </message>
    <message>
        <source>this is no file that AngioPose reads. It reads cases (.angiopose), centrelines (VTP, VTK, CSV, SWC, .mrk.json), scans and segmentations (DICOM, NIfTI, NRRD, MetaImage), surfaces (STL, PLY, OBJ), angiograms (DICOM, PNG, TIFF, JPEG) and poses (.json, .tfm).</source>
        <comment>info.unknown</comment>
        <translation>das ist keine Datei, die AngioPose liest. Gelesen werden Fälle (.angiopose), Mittellinien (VTP, VTK, CSV, SWC, .mrk.json), CT-Daten und Segmentierungen (DICOM, NIfTI, NRRD, MetaImage), Oberflächen (STL, PLY, OBJ), Angiogramme (DICOM, PNG, TIFF, JPEG) und Lagen (.json, .tfm).</translation>
    </message>
    <message>
        <source>this is %1, nothing that AngioPose reads. It reads cases (.angiopose), centrelines (VTP, VTK, CSV, SWC, .mrk.json), scans and segmentations (DICOM, NIfTI, NRRD, MetaImage), surfaces (STL, PLY, OBJ), angiograms (DICOM, PNG, TIFF, JPEG) and poses (.json, .tfm).</source>
        <comment>info.other</comment>
        <translation>das ist %1, was AngioPose nicht liest. Gelesen werden Fälle (.angiopose), Mittellinien (VTP, VTK, CSV, SWC, .mrk.json), CT-Daten und Segmentierungen (DICOM, NIfTI, NRRD, MetaImage), Oberflächen (STL, PLY, OBJ), Angiogramme (DICOM, PNG, TIFF, JPEG) und Lagen (.json, .tfm).</translation>
    </message>
    <message>
        <source>There is not enough memory for this. Close other programs or use smaller inputs.</source>
        <comment>run.not-enough-memory</comment>
        <translation>Dafür reicht der Speicher nicht. Andere Programme schließen oder kleinere Daten verwenden.</translation>
    </message>
    <message>
        <source>A library gave up: %1. Check the inputs.</source>
        <comment>run.library-gave-up</comment>
        <translation>Eine Bibliothek gab auf: %1. Die Eingaben prüfen.</translation>
    </message>
    <message>
        <source>Stopped before the run began.</source>
        <comment>run.stopped-before</comment>
        <translation>Angehalten, bevor der Lauf begann.</translation>
    </message>
    <message>
        <source>There is nothing to show yet.</source>
        <comment>run.not-shown</comment>
        <translation>Es gibt noch nichts zu zeigen.</translation>
    </message>
    <message>
        <source>The scan does not reach to the vessels. Show all of it, or open the scan that the vessels lie in.</source>
        <comment>scan.beside-vessels</comment>
        <translation>Der Scan reicht nicht bis zu den Gefäßen. Den ganzen Scan zeigen oder den öffnen, in dem die Gefäße liegen.</translation>
    </message>
    <message>
        <source>An overlay needs a vessel tree and an angiogram. Open both first.</source>
        <comment>picture.overlay-incomplete</comment>
        <translation>Eine Überlagerung braucht Gefäßbaum und Angiogramm. Zuerst beide öffnen.</translation>
    </message>
    <message>
        <source>A picture needs a vessel tree and an angiogram. Open both first.</source>
        <comment>picture.incomplete</comment>
        <translation>Ein Bild braucht Gefäßbaum und Angiogramm. Zuerst beide öffnen.</translation>
    </message>
    <message>
        <source>it was stopped; whole objects that came are kept.</source>
        <comment>archive.stopped</comment>
        <translation>Es wurde angehalten; ganze Objekte, die kamen, bleiben.</translation>
    </message>
    <message>
        <source>the host %1 is not known. Check its name in the list of archives, and the network.</source>
        <comment>archive.unknown-host</comment>
        <translation>Den Rechner %1 kennt niemand. Seinen Namen in der Liste der Archive prüfen, und das Netz.</translation>
    </message>
    <message>
        <source>%1 cannot be reached (%2). Check host and port, the network, and that the archive runs.</source>
        <comment>archive.no-connection</comment>
        <translation>%1 ist nicht zu erreichen (%2). Rechner und Port, das Netz, und ob das Archiv läuft, prüfen.</translation>
    </message>
    <message>
        <source>%1 took the connection and did not answer within %2. Check that the port is that of a DICOM archive.</source>
        <comment>archive.silent</comment>
        <translation>%1 nahm die Verbindung an und antwortete nicht innerhalb von %2. Prüfen, ob der Port der eines DICOM-Archivs ist.</translation>
    </message>
    <message>
        <source>no answer came within %1. Try again later, or allow it more “Time for an answer”; whole objects that came are kept.</source>
        <comment>archive.no-answer</comment>
        <translation>Innerhalb von %1 kam keine Antwort. Später noch einmal versuchen, oder ihm mehr „Zeit für eine Antwort“ geben; ganze Objekte, die kamen, bleiben.</translation>
    </message>
    <message>
        <source>the connection broke off (%1). Try again; whole objects that came are kept.</source>
        <comment>archive.broken</comment>
        <translation>Die Verbindung brach ab (%1). Noch einmal versuchen; ganze Objekte, die kamen, bleiben.</translation>
    </message>
    <message>
        <source>there is no AE title %1 at %2. Correct the AE title of this archive in the list of archives.</source>
        <comment>archive.unknown-title</comment>
        <translation>Einen AE-Titel %1 gibt es bei %2 nicht. Den AE-Titel dieses Archivs in der Liste der Archive berichtigen.</translation>
    </message>
    <message>
        <source>our AE title %1 is not allowed there. Have it entered in the archive, or correct ours in the list of archives.</source>
        <comment>archive.title-not-allowed</comment>
        <translation>Unser AE-Titel %1 ist dort nicht zugelassen. Ihn im Archiv eintragen lassen, oder unseren in der Liste der Archive berichtigen.</translation>
    </message>
    <message>
        <source>the association was refused (%1). Ask who runs the archive whether this computer may connect.</source>
        <comment>archive.refused</comment>
        <translation>Die Verbindung wurde abgelehnt (%1). Den Betreiber des Archivs fragen, ob sich dieser Rechner verbinden darf.</translation>
    </message>
    <message>
        <source>the archive ended the association in the middle. Look into its log, or try again; whole objects that came are kept.</source>
        <comment>archive.aborted</comment>
        <translation>Das Archiv beendete die Verbindung mittendrin. In sein Protokoll sehen oder noch einmal versuchen; ganze Objekte, die kamen, bleiben.</translation>
    </message>
    <message>
        <source>it does not offer %1. Ask who runs it to allow that for our AE title %2.</source>
        <comment>archive.no-service</comment>
        <translation>Es bietet %1 nicht an. Den Betreiber bitten, das unserem AE-Titel %2 zu erlauben.</translation>
    </message>
    <message>
        <source>%1 failed with %2. Look into the archive&apos;s log, or ask who runs it.</source>
        <comment>archive.status</comment>
        <translation>%1 schlug mit %2 fehl. In das Protokoll des Archivs sehen, oder den Betreiber fragen.</translation>
    </message>
    <message>
        <source>its answer makes no sense (%1). Check that host, port and address are those of a DICOM archive.</source>
        <comment>archive.nonsense</comment>
        <translation>Seine Antwort ergibt keinen Sinn (%1). Prüfen, ob Rechner, Port und Adresse die eines DICOM-Archivs sind.</translation>
    </message>
    <message>
        <source>no secure connection came about (%1). Check the CA file of this archive, the certificates, and whether it wants TLS at this port.</source>
        <comment>archive.tls-refused</comment>
        <translation>Es kam keine sichere Verbindung zustande (%1). Die CA-Datei dieses Archivs, die Zertifikate, und ob es an diesem Port TLS will, prüfen.</translation>
    </message>
    <message>
        <source>the file %1 is of no use for TLS (%2). Check its path and content.</source>
        <comment>archive.tls-file</comment>
        <translation>Die Datei %1 taugt nicht für TLS (%2). Pfad und Inhalt prüfen.</translation>
    </message>
    <message>
        <source>its certificate is not one of the host %1. Check the host; where it is right, switch “Its certificate must be one of the host” off for this archive.</source>
        <comment>archive.tls-host</comment>
        <translation>Sein Zertifikat ist keines des Rechners %1. Den Rechner prüfen; stimmt er, für dieses Archiv „Sein Zertifikat muss das des Hosts sein“ ausschalten.</translation>
    </message>
    <message>
        <source>it is no list of archives (%1). Correct it, or remove the file.</source>
        <comment>archive.list-invalid</comment>
        <translation>Es ist keine Liste von Archiven (%1). Sie berichtigen, oder die Datei entfernen.</translation>
    </message>
    <message>
        <source>there is no archive %1 in %2; known: %3. Add it, or correct the name.</source>
        <comment>archive.unknown</comment>
        <translation>Ein Archiv %1 gibt es in %2 nicht; bekannt: %3. Es hinzufügen, oder den Namen berichtigen.</translation>
    </message>
    <message>
        <source>an archive has no name of 1 to 64 characters. Name it.</source>
        <comment>archive.no-name</comment>
        <translation>Ein Archiv hat keinen Namen von 1 bis 64 Zeichen. Es benennen.</translation>
    </message>
    <message>
        <source>it has neither a host nor a DICOMweb address. Give one.</source>
        <comment>archive.no-address</comment>
        <translation>Es hat weder einen Rechner noch eine DICOMweb-Adresse. Eines davon angeben.</translation>
    </message>
    <message>
        <source>%1 is no host. Give a name or an address without port and spaces.</source>
        <comment>archive.bad-host</comment>
        <translation>%1 ist kein Rechner. Einen Namen oder eine Adresse ohne Port und Leerzeichen angeben.</translation>
    </message>
    <message>
        <source>the port %1 is not one of 1 to 65535. Correct it.</source>
        <comment>archive.bad-port</comment>
        <translation>Der Port %1 ist keiner von 1 bis 65535. Ihn berichtigen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no AE title. Give 1 to 16 letters, digits or signs other than the backslash.</source>
        <comment>archive.bad-title</comment>
        <translation>„%1“ ist kein AE-Titel. 1 bis 16 Buchstaben, Ziffern oder Zeichen außer dem umgekehrten Schrägstrich angeben.</translation>
    </message>
    <message>
        <source>%1 is no DICOMweb address. Give one that begins with https:// or http://.</source>
        <comment>archive.bad-url</comment>
        <translation>%1 ist keine DICOMweb-Adresse. Eine angeben, die mit https:// oder http:// beginnt.</translation>
    </message>
    <message>
        <source>the “Time for an answer” must be 1 to 600 s. Correct it.</source>
        <comment>archive.bad-time</comment>
        <translation>Die „Zeit für eine Antwort“ muss 1 bis 600 s sein. Sie berichtigen.</translation>
    </message>
    <message>
        <source>a certificate and its key belong together, and one is missing. Give both files.</source>
        <comment>archive.key-without-certificate</comment>
        <translation>Zertifikat und Schlüssel gehören zusammen, und eines fehlt. Beide Dateien angeben.</translation>
    </message>
    <message>
        <source>it has a DICOMweb address only. Give host and port too, or use DICOMweb.</source>
        <comment>archive.no-dimse</comment>
        <translation>Es hat nur eine DICOMweb-Adresse. Auch Rechner und Port angeben, oder DICOMweb nehmen.</translation>
    </message>
    <message>
        <source>it has no DICOMweb address. Give one, or use DIMSE.</source>
        <comment>archive.no-web</comment>
        <translation>Es hat keine DICOMweb-Adresse. Eine angeben, oder DIMSE nehmen.</translation>
    </message>
    <message>
        <source>names and images go to %1 without encryption. Use https:// or TLS where others share the network.</source>
        <comment>archive.plain-text</comment>
        <translation>Namen und Bilder gehen unverschlüsselt an %1. https:// oder TLS nehmen, wo andere das Netz mitbenutzen.</translation>
    </message>
    <message>
        <source>%1 is no date. Write YYYY-MM-DD, or two of them with .. between: 2024-01-01..2024-02-01.</source>
        <comment>archive.bad-date</comment>
        <translation>%1 ist kein Datum. JJJJ-MM-TT schreiben, oder zwei davon mit .. dazwischen: 2024-01-01..2024-02-01.</translation>
    </message>
    <message>
        <source>there are more than %1 matches; the rest is left out. Ask for less.</source>
        <comment>archive.many-matches</comment>
        <translation>Es gibt mehr als %1 Treffer; der Rest fehlt. Enger suchen.</translation>
    </message>
    <message>
        <source>it holds nothing of %1. Search again.</source>
        <comment>archive.nothing-there</comment>
        <translation>Es hat nichts von %1. Noch einmal suchen.</translation>
    </message>
    <message>
        <source>%1 is no UID. Copy it from what find prints.</source>
        <comment>archive.bad-uid</comment>
        <translation>%1 ist keine UID. Sie aus dem kopieren, was find ausgibt.</translation>
    </message>
    <message>
        <source>%1 of %2 objects came, the archive did not send the others (%3). Retrieve again, or look into its log.</source>
        <comment>archive.not-all-came</comment>
        <translation>%1 von %2 Objekten kamen, die anderen schickte das Archiv nicht (%3). Noch einmal holen, oder in sein Protokoll sehen.</translation>
    </message>
    <message>
        <source>it does not offer C-GET, and C-MOVE needs a port of our own. Set its “Port for C-MOVE”, and have AE title, host and port entered in the archive.</source>
        <comment>archive.no-way-back</comment>
        <translation>Es bietet C-GET nicht an, und C-MOVE braucht einen Port bei uns. Seinen „Port für C-MOVE“ setzen, und AE-Titel, Rechner und Port im Archiv eintragen lassen.</translation>
    </message>
    <message>
        <source>port %1 cannot be listened on (%2). Choose another port, above 1024.</source>
        <comment>archive.port-taken</comment>
        <translation>An Port %1 lässt sich nicht lauschen (%2). Einen anderen Port über 1024 wählen.</translation>
    </message>
    <message>
        <source>an object is larger than the limit of %1 and was not kept. Raise the limit if it is wanted (--max-object).</source>
        <comment>archive.object-too-large</comment>
        <translation>Ein Objekt ist größer als die Grenze von %1 und wurde nicht behalten. Die Grenze heben, wenn es gewollt ist (--max-object).</translation>
    </message>
    <message>
        <source>an object that came is no readable DICOM object, and was not kept. Look into the archive&apos;s log.</source>
        <comment>archive.object-unreadable</comment>
        <translation>Ein Objekt, das kam, ist kein lesbares DICOM-Objekt und wurde nicht behalten. In das Protokoll des Archivs sehen.</translation>
    </message>
    <message>
        <source>an object that came is not the one that was announced (%1), and was not kept. Look into the archive&apos;s log.</source>
        <comment>archive.object-foreign</comment>
        <translation>Ein Objekt, das kam, ist nicht das angekündigte (%1) und wurde nicht behalten. In das Protokoll des Archivs sehen.</translation>
    </message>
    <message>
        <source>an object came whose UID (%1) is that of another one here; the earlier one is kept. Find out which is right.</source>
        <comment>archive.object-differs</comment>
        <translation>Es kam ein Objekt, dessen UID (%1) die eines anderen hier ist; das frühere bleibt. Herausfinden, welches richtig ist.</translation>
    </message>
    <message>
        <source>the series does not fit into the cache of %1. Raise its limit, or empty it.</source>
        <comment>archive.cache-too-small</comment>
        <translation>Die Serie passt nicht in den Zwischenspeicher von %1. Seine Grenze heben, oder ihn leeren.</translation>
    </message>
    <message>
        <source>the folder cannot be made or used (%1). Choose another one, or make room.</source>
        <comment>archive.no-folder</comment>
        <translation>Der Ordner lässt sich nicht anlegen oder benutzen (%1). Einen anderen wählen, oder Platz schaffen.</translation>
    </message>
    <message>
        <source>it is no whole DICOM file with its transfer syntax, and was not sent. Write it anew, or choose another.</source>
        <comment>archive.not-sendable</comment>
        <translation>Es ist keine ganze DICOM-Datei mit ihrer Übertragungssyntax und wurde nicht gesendet. Sie neu schreiben, oder eine andere wählen.</translation>
    </message>
    <message>
        <source>the archive does not take objects of its kind as they are stored (class %1, transfer syntax %2). Convert it, or ask who runs the archive.</source>
        <comment>archive.not-taken</comment>
        <translation>Das Archiv nimmt solche Objekte nicht so, wie sie gespeichert sind (Klasse %1, Übertragungssyntax %2). Es umwandeln, oder den Betreiber des Archivs fragen.</translation>
    </message>
    <message>
        <source>the archive refused it with %1. Look into its log, or ask who runs it.</source>
        <comment>archive.store-refused</comment>
        <translation>Das Archiv lehnte es mit %1 ab. In sein Protokoll sehen, oder den Betreiber fragen.</translation>
    </message>
    <message>
        <source>%1 was answered with HTTP status %2. Check the DICOMweb address, or ask who runs the archive.</source>
        <comment>archive.http-status</comment>
        <translation>%1 wurde mit HTTP-Status %2 beantwortet. Die DICOMweb-Adresse prüfen, oder den Betreiber des Archivs fragen.</translation>
    </message>
    <message>
        <source>access was refused (HTTP status %1). Check the client certificate or the authorization file of this archive.</source>
        <comment>archive.http-forbidden</comment>
        <translation>Der Zugang wurde verweigert (HTTP-Status %1). Das Zertifikat oder die Datei für Authorization dieses Archivs prüfen.</translation>
    </message>
    <message>
        <source>its answer is larger than %1. Ask for less.</source>
        <comment>archive.http-too-large</comment>
        <translation>Seine Antwort ist größer als %1. Enger suchen.</translation>
    </message>
    <message>
        <source>%1 (AE title %2) was turned away: it is not on the list of those that may call.</source>
        <comment>archive.title-turned-away</comment>
        <translation>%1 (AE-Titel %2) wurde abgewiesen: nicht auf der Liste derer, die anrufen dürfen.</translation>
    </message>
    <message>
        <source>%1 (AE title %2) was turned away: it called %3, which is not our AE title. Correct it there.</source>
        <comment>archive.called-otherwise</comment>
        <translation>%1 (AE-Titel %2) wurde abgewiesen: gerufen wurde %3, was nicht unser AE-Titel ist. Ihn dort berichtigen.</translation>
    </message>
    <message>
        <source>a call to the port came to nothing (%1). Look at the caller: address, port, whether it uses TLS.</source>
        <comment>archive.call-failed</comment>
        <translation>Ein Anruf am Port führte zu nichts (%1). Beim Anrufer nachsehen: Adresse, Port, ob er TLS benutzt.</translation>
    </message>
    <message>
        <source>a caller was turned away: no secure connection came about (%1). Check its certificate, those trusted here, and whether it uses TLS.</source>
        <comment>archive.call-not-secured</comment>
        <translation>Ein Anrufer wurde abgewiesen: Es kam keine sichere Verbindung zustande (%1). Sein Zertifikat, die hier vertrauten, und ob er TLS benutzt, prüfen.</translation>
    </message>
    <message>
        <source>TLS at a port needs a certificate of ours and its key. Give both files.</source>
        <comment>archive.port-unsecured</comment>
        <translation>TLS an einem Port braucht ein Zertifikat von uns und seinen Schlüssel. Beide Dateien angeben.</translation>
    </message>
    <message>
        <source>%1 does not exist. Check the name, or whether its drive is mounted.</source>
        <comment>open.missing</comment>
        <translation>%1 gibt es nicht. Namen prüfen, oder ob das Laufwerk eingehängt ist.</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2. Check its permissions.</source>
        <comment>open.unreadable</comment>
        <translation>%1 lässt sich nicht lesen: %2. Die Rechte prüfen.</translation>
    </message>
    <message>
        <source>%1 is empty. Copy the file again from where it came from.</source>
        <comment>open.empty</comment>
        <translation>%1 ist leer. Die Datei vom Ursprungsort neu kopieren.</translation>
    </message>
    <message>
        <source>%1 is not a file that AngioPose opens. Open a case (.angiopose), a centreline (VTP, VTK, CSV, SWC), a CT scan (DICOM folder, NIfTI, NRRD, MetaImage), a surface (STL, PLY, OBJ) or an angiogram (DICOM, PNG, TIFF).</source>
        <comment>open.unknown</comment>
        <translation>%1 kann AngioPose nicht öffnen. Einen Fall (.angiopose), eine Mittellinie (VTP, VTK, CSV, SWC), ein CT (DICOM-Ordner, NIfTI, NRRD, MetaImage), eine Oberfläche (STL, PLY, OBJ) oder ein Angiogramm (DICOM, PNG, TIFF) öffnen.</translation>
    </message>
    <message>
        <source>%1 is a case. Open it alone, without other files.</source>
        <comment>open.case-alone</comment>
        <translation>%1 ist ein Fall. Allein öffnen, ohne andere Dateien.</translation>
    </message>
    <message>
        <source>%1 is a second vessel tree. Open one vessel tree at a time.</source>
        <comment>open.second-tree</comment>
        <translation>%1 ist ein zweiter Gefäßbaum. Nur einen auf einmal öffnen.</translation>
    </message>
    <message>
        <source>%1 is a second 2-D centreline. Open one 2-D centreline at a time.</source>
        <comment>open.second-centreline</comment>
        <translation>%1 ist eine zweite 2-D-Mittellinie. Nur eine auf einmal öffnen.</translation>
    </message>
    <message>
        <source>%1 is a second angiogram. Open one at a time; others join it as views.</source>
        <comment>open.second-angiogram</comment>
        <translation>%1 ist ein zweites Angiogramm. Nur eines auf einmal öffnen; weitere kommen als Ansichten dazu.</translation>
    </message>
    <message>
        <source>%1 has moved and was found as %2. Save the case to remember.</source>
        <comment>open.moved</comment>
        <translation>%1 wurde verschoben und als %2 gefunden. Zum Merken den Fall speichern.</translation>
    </message>
    <message>
        <source>this is no angiogram. Choose an XA image, or a case with one.</source>
        <comment>open.no-angiogram</comment>
        <translation>das ist kein Angiogramm. Eine XA-Aufnahme oder einen Fall mit einer wählen.</translation>
    </message>
    <message>
        <source>none of its %1 series can be opened. %2</source>
        <comment>open.no-series</comment>
        <translation>keine der %1 Serien darin lässt sich öffnen. %2</translation>
    </message>
    <message>
        <source>Not for clinical use</source>
        <comment>picture.not-for-clinical-use</comment>
        <translation>Nicht für den klinischen Einsatz</translation>
    </message>
    <message>
        <source>identity hidden</source>
        <comment>picture.identity-hidden</comment>
        <translation>Patientendaten verborgen</translation>
    </message>
    <message>
        <source>before: at the start pose</source>
        <comment>picture.before</comment>
        <translation>vorher: in der Startlage</translation>
    </message>
    <message>
        <source>after: at this pose</source>
        <comment>picture.after</comment>
        <translation>nachher: in dieser Lage</translation>
    </message>
    <message>
        <source>%1 · median %2</source>
        <comment>picture.pose</comment>
        <translation>%1 · Median %2</translation>
    </message>
    <message>
        <source>%1 · median %2 · not trustworthy</source>
        <comment>picture.pose-not-trustworthy</comment>
        <translation>%1 · Median %2 · nicht vertrauenswürdig</translation>
    </message>
    <message>
        <source>moved, mm</source>
        <comment>picture.motion-scale</comment>
        <translation>bewegt, mm</translation>
    </message>
    <message>
        <source>bent on frame %1, another one</source>
        <comment>picture.bent-on-frame</comment>
        <translation>auf Bild %1 gebogen, einem anderen</translation>
    </message>
    <message>
        <source>bend along the ray: not told</source>
        <comment>picture.bent-depth-untold</comment>
        <translation>Biegung längs des Strahls: unbekannt</translation>
    </message>
    <message>
        <source>rigid: %1</source>
        <comment>picture.of-rigid-vessels</comment>
        <translation>starr: %1</translation>
    </message>
    <message>
        <source>vessels rigid; bent ones are known</source>
        <comment>picture.vessels-rigid</comment>
        <translation>Gefäße starr; gebogene sind bekannt</translation>
    </message>
    <message>
        <source>vessels bent by up to %1, not sure</source>
        <comment>picture.vessels-bent-unsure</comment>
        <translation>Gefäße um bis zu %1 gebogen, nicht sicher</translation>
    </message>
    <message>
        <source>vessels bent by up to %1</source>
        <comment>picture.vessels-bent</comment>
        <translation>Gefäße um bis zu %1 gebogen</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <comment>picture.two-parts</comment>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>LAO %1</source>
        <comment>picture.lao</comment>
        <translation>LAO %1</translation>
    </message>
    <message>
        <source>RAO %1</source>
        <comment>picture.rao</comment>
        <translation>RAO %1</translation>
    </message>
    <message>
        <source>CRA %1</source>
        <comment>picture.cra</comment>
        <translation>CRA %1</translation>
    </message>
    <message>
        <source>CAU %1</source>
        <comment>picture.cau</comment>
        <translation>CAU %1</translation>
    </message>
    <message>
        <source>SID %1 · SOD %2 (%3)</source>
        <comment>picture.sid-and-sod</comment>
        <translation>SID %1 · SOD %2 (%3)</translation>
    </message>
    <message>
        <source>SID %1 (%2)</source>
        <comment>picture.sid</comment>
        <translation>SID %1 (%2)</translation>
    </message>
    <message>
        <source>SOD %1 (%2)</source>
        <comment>picture.sod</comment>
        <translation>SOD %1 (%2)</translation>
    </message>
    <message>
        <source>%1 detector (%2)</source>
        <comment>picture.scale-at-detector</comment>
        <translation>%1 Detektor (%2)</translation>
    </message>
    <message>
        <source>%1 at the vessels</source>
        <comment>picture.scale-at-vessels</comment>
        <translation>%1 an den Gefäßen</translation>
    </message>
    <message>
        <source>header</source>
        <comment>origin.header</comment>
        <translation>Header</translation>
    </message>
    <message>
        <source>derived</source>
        <comment>origin.derived</comment>
        <translation>abgeleitet</translation>
    </message>
    <message>
        <source>user</source>
        <comment>origin.user</comment>
        <translation>eingegeben</translation>
    </message>
    <message>
        <source>assumed</source>
        <comment>origin.assumed</comment>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>missing</source>
        <comment>origin.missing</comment>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>The simulation&apos;s %1 must lie between %2 and %3, not %4.</source>
        <comment>simulation.out-of-range</comment>
        <translation>%1 der Simulation muss zwischen %2 und %3 liegen, nicht %4.</translation>
    </message>
    <message>
        <source>Method &apos;%1&apos; has no option with the choice &apos;%2&apos;. Write it as option=value.</source>
        <comment>contest.no-such-choice</comment>
        <translation>Das Verfahren „%1“ hat keine Option mit der Wahl „%2“. Als option=wert schreiben.</translation>
    </message>
    <message>
        <source>Method &apos;%1&apos; has more than one option with the choice &apos;%2&apos;. Write it as option=value.</source>
        <comment>contest.choice-of-several</comment>
        <translation>Das Verfahren „%1“ hat mehr als eine Option mit der Wahl „%2“. Als option=wert schreiben.</translation>
    </message>
    <message>
        <source>No method is named. See the methods in: angiopose-cli evaluate --help</source>
        <comment>contest.no-method-named</comment>
        <translation>Kein Verfahren ist genannt. Die Verfahren stehen in: angiopose-cli evaluate --help</translation>
    </message>
    <message>
        <source>The experiment &apos;%1&apos; has no condition &apos;%2&apos;. See the conditions in: angiopose-cli evaluate --help</source>
        <comment>experiment.no-such-condition</comment>
        <translation>Das Experiment „%1“ hat keine Bedingung „%2“. Die Bedingungen stehen in: angiopose-cli evaluate --help</translation>
    </message>
    <message>
        <source>The condition &apos;%1&apos; is not one of &apos;%2&apos;. Merge runs of this program&apos;s version.</source>
        <comment>merge.foreign-condition</comment>
        <translation>Die Bedingung „%1“ ist keine von „%2“. Läufe dieser Programmversion vereinen.</translation>
    </message>
    <message>
        <source>Two parts disagree about %1 in trial %2 of %3. Merge runs of the same program and settings.</source>
        <comment>merge.parts-disagree</comment>
        <translation>Zwei Teile widersprechen sich zu %1 im Versuch %2 von %3. Läufe desselben Programms und derselben Einstellungen vereinen.</translation>
    </message>
    <message>
        <source>There are no runs to merge.</source>
        <comment>merge.nothing</comment>
        <translation>Es gibt keine Läufe zu vereinen.</translation>
    </message>
    <message>
        <source>Runs of &apos;%1&apos;, seed %2, and of &apos;%3&apos;, seed %4, do not belong together. Merge parts of one experiment.</source>
        <comment>merge.runs-of-others</comment>
        <translation>Läufe von „%1“, Startwert %2, und von „%3“, Startwert %4, gehören nicht zusammen. Teile eines Experiments vereinen.</translation>
    </message>
    <message>
        <source>The focal lengths fx and fy must be finite and not zero.</source>
        <comment>camera.focal-lengths</comment>
        <translation>Die Brennweiten fx und fy müssen endlich und ungleich null sein.</translation>
    </message>
    <message>
        <source>The principal point cx, cy must be finite.</source>
        <comment>camera.principal-point</comment>
        <translation>Der Hauptpunkt cx, cy muss endlich sein.</translation>
    </message>
    <message>
        <source>The camera needs the image size: width and height must be positive.</source>
        <comment>camera.image-size</comment>
        <translation>Die Kamera braucht die Bildgröße: Breite und Höhe müssen positiv sein.</translation>
    </message>
    <message>
        <source>The camera is for images of %1 x %2 pixels, the angiogram has %3 x %4. Use the camera that belongs to the angiogram.</source>
        <comment>camera.other-image</comment>
        <translation>Die Kamera gilt für Bilder mit %1 x %2 Pixeln, das Angiogramm hat %3 x %4. Die zum Angiogramm gehörende Kamera verwenden.</translation>
    </message>
    <message>
        <source>The picture must be 1 to %1 px wide and high; choose another size.</source>
        <comment>picture.size</comment>
        <translation>Das Bild muss 1 bis %1 px breit und hoch sein; eine andere Größe wählen.</translation>
    </message>
    <message>
        <source>%1 is missing or not positive. Add it to the geometry of the C-arm (the image header does not tell).</source>
        <comment>geometry.value-missing</comment>
        <translation>%1 fehlt oder ist nicht positiv. In der Geometrie des C-Bogens ergänzen (der Bildheader nennt ihn nicht).</translation>
    </message>
    <message>
        <source>The distance source to detector (SID)</source>
        <comment>geometry.the-sid</comment>
        <translation>Der Abstand Fokus–Detektor (SID)</translation>
    </message>
    <message>
        <source>The distance source to patient (SOD)</source>
        <comment>geometry.the-sod</comment>
        <translation>Der Abstand Fokus–Patient (SOD)</translation>
    </message>
    <message>
        <source>The detector pixel spacing</source>
        <comment>geometry.the-spacing</comment>
        <translation>Die Pixelgröße des Detektors</translation>
    </message>
    <message>
        <source>The positioner angles (LAO/RAO, CRA/CAU) are missing or not finite. Add them to the geometry of the C-arm.</source>
        <comment>geometry.angles-missing</comment>
        <translation>Die Durchleuchtungswinkel (LAO/RAO, CRA/CAU) fehlen oder sind nicht endlich. In der Geometrie des C-Bogens ergänzen.</translation>
    </message>
    <message>
        <source>The isocentre has a coordinate that is not a number (NaN or infinite). Give its place in the patient in mm.</source>
        <comment>geometry.isocentre-not-finite</comment>
        <translation>Das Isozentrum hat eine Koordinate, die keine Zahl ist (NaN oder unendlich). Seinen Ort im Patienten in mm angeben.</translation>
    </message>
    <message>
        <source>Source to detector distance (SID): type it, usually 900 to 1200 mm.</source>
        <comment>geometry.ask-sid</comment>
        <translation>Abstand Fokus–Detektor (SID): eintragen, meist 900 bis 1200 mm.</translation>
    </message>
    <message>
        <source>Source to isocentre distance (SOD): type it, usually 700 to 800 mm.</source>
        <comment>geometry.ask-sod</comment>
        <translation>Abstand Fokus–Isozentrum (SOD): eintragen, meist 700 bis 800 mm.</translation>
    </message>
    <message>
        <source>Detector pixel spacing: type it, or the width of the field of view on the detector divided by the columns.</source>
        <comment>geometry.ask-spacing</comment>
        <translation>Pixelgröße des Detektors: eintragen, oder die Breite des Bildfelds auf dem Detektor geteilt durch die Spalten.</translation>
    </message>
    <message>
        <source>LAO/RAO angle: type it, or place the vessels by landmarks.</source>
        <comment>geometry.ask-primary-angle</comment>
        <translation>Winkel LAO/RAO: eintragen, oder die Gefäße nach Landmarken legen.</translation>
    </message>
    <message>
        <source>CRA/CAU angle: type it, or place the vessels by landmarks.</source>
        <comment>geometry.ask-secondary-angle</comment>
        <translation>Winkel CRA/CAU: eintragen, oder die Gefäße nach Landmarken legen.</translation>
    </message>
    <message>
        <source>A source to detector distance (SID) of %1 is unlike a C-arm (500 to 2000 mm): check its unit.</source>
        <comment>geometry.sid-unusual</comment>
        <translation>Ein Abstand Fokus–Detektor (SID) von %1 passt zu keinem C-Bogen (500 bis 2000 mm): die Einheit prüfen.</translation>
    </message>
    <message>
        <source>SOD (%1) is not smaller than SID (%2): the patient would lie behind the detector. Correct one of them.</source>
        <comment>geometry.sod-beyond-sid</comment>
        <translation>SOD (%1) ist nicht kleiner als SID (%2): der Patient läge hinter dem Detektor. Eines berichtigen.</translation>
    </message>
    <message>
        <source>SID is %1 times SOD; angiograms are magnified 1.0 to 2.5 times. Check both distances.</source>
        <comment>geometry.magnification-unusual</comment>
        <translation>SID ist das %1-fache von SOD; Angiogramme sind 1,0- bis 2,5-fach vergrößert. Beide Abstände prüfen.</translation>
    </message>
    <message>
        <source>The header&apos;s magnification of %1 (0018,1114) is not SID/SOD = %2: one of the three is stale. Check SID and SOD.</source>
        <comment>geometry.magnification-stale</comment>
        <translation>Die Vergrößerung des Headers von %1 (0018,1114) ist nicht SID/SOD = %2: eine der drei Angaben ist veraltet. SID und SOD prüfen.</translation>
    </message>
    <message>
        <source>A detector pixel spacing of %1 lies outside 0.05 to 2 mm: check its unit.</source>
        <comment>geometry.spacing-unusual</comment>
        <translation>Eine Pixelgröße von %1 liegt außerhalb 0,05 bis 2 mm: die Einheit prüfen.</translation>
    </message>
    <message>
        <source>Pixels are %1 times as high as wide by their spacing, %2 times by the pixel aspect: check the pixel spacing.</source>
        <comment>geometry.aspect-differs</comment>
        <translation>Nach ihrem Abstand sind Pixel %1-mal so hoch wie breit, nach dem Seitenverhältnis %2-mal: die Pixelgröße prüfen.</translation>
    </message>
    <message>
        <source>The image covers %1 x %2 of the detector by its pixel spacing</source>
        <comment>geometry.image-covers</comment>
        <translation>Nach der Pixelgröße bedeckt das Bild %1 x %2 des Detektors</translation>
    </message>
    <message>
        <source>%1: no detector of a C-arm is like that. Check the pixel spacing.</source>
        <comment>geometry.extent-unlike-detector</comment>
        <translation>%1: so ist kein Detektor eines C-Bogens. Die Pixelgröße prüfen.</translation>
    </message>
    <message>
        <source>%1, the field of view is %2 x %3: the image may be zoomed, cropped or resampled. Check the pixel spacing.</source>
        <comment>geometry.extent-unlike-field</comment>
        <translation>%1, das Bildfeld ist %2 x %3: das Bild ist vielleicht gezoomt, beschnitten oder umgerechnet. Die Pixelgröße prüfen.</translation>
    </message>
    <message>
        <source>%1, more than the intensifier of %2. Check the pixel spacing.</source>
        <comment>geometry.extent-beyond-intensifier</comment>
        <translation>%1, mehr als der Bildverstärker von %2. Die Pixelgröße prüfen.</translation>
    </message>
    <message>
        <source>%1, more than its active %2 x %3. Check the pixel spacing.</source>
        <comment>geometry.extent-beyond-detector</comment>
        <translation>%1, mehr als seine aktiven %2 x %3. Die Pixelgröße prüfen.</translation>
    </message>
    <message>
        <source>The calibrated pixel spacing of %1 times SID/SOD is %2, not the detector&apos;s %3: the calibration or a distance is off.</source>
        <comment>geometry.calibration-off</comment>
        <translation>Die kalibrierte Pixelgröße von %1 mal SID/SOD ergibt %2, nicht die %3 des Detektors: Kalibrierung oder Abstand stimmt nicht.</translation>
    </message>
    <message>
        <source>Pixel Spacing (0028,0030) says %1 without a calibration, the detector&apos;s pixels are %2: check which is meant.</source>
        <comment>geometry.spacings-differ</comment>
        <translation>Pixel Spacing (0028,0030) nennt ohne Kalibrierung %1, die Detektorpixel messen %2: prüfen, was gemeint ist.</translation>
    </message>
    <message>
        <source>The primary angle (LAO/RAO) lies outside ±180°. Correct it.</source>
        <comment>geometry.primary-angle-outside</comment>
        <translation>Der Primärwinkel (LAO/RAO) liegt außerhalb ±180°. Berichtigen.</translation>
    </message>
    <message>
        <source>The secondary angle (CRA/CAU) lies outside ±90°. Correct it.</source>
        <comment>geometry.secondary-angle-outside</comment>
        <translation>Der Sekundärwinkel (CRA/CAU) liegt außerhalb ±90°. Berichtigen.</translation>
    </message>
    <message>
        <source>The roll lies outside ±180°. Correct it.</source>
        <comment>geometry.roll-outside</comment>
        <translation>Das Rollen liegt außerhalb ±180°. Berichtigen.</translation>
    </message>
    <message>
        <source>The principal point (%1, %2) lies outside the image: right for a cropped image only.</source>
        <comment>geometry.principal-point-outside</comment>
        <translation>Der Hauptpunkt (%1, %2) liegt außerhalb des Bildes: nur bei beschnittenem Bild richtig.</translation>
    </message>
    <message>
        <source>Two of the angiograms seem to be of different patients (%1 differs). Check that they are the right ones.</source>
        <comment>patient.of-runs-differs</comment>
        <translation>Zwei der Angiogramme scheinen von verschiedenen Patienten zu sein (%1 verschieden). Prüfen, ob es die richtigen sind.</translation>
    </message>
    <message>
        <source>Two of the angiograms seem to be of different patients (%1 differ). Check that they are the right ones.</source>
        <comment>patient.of-runs-differs-in-several</comment>
        <translation>Zwei der Angiogramme scheinen von verschiedenen Patienten zu sein (%1 verschieden). Prüfen, ob es die richtigen sind.</translation>
    </message>
    <message>
        <source>Two of the angiograms are of opposite sides of the patient. Check that they are the right ones.</source>
        <comment>patient.side-of-runs-differs</comment>
        <translation>Zwei der Angiogramme zeigen entgegengesetzte Seiten des Patienten. Prüfen, ob es die richtigen sind.</translation>
    </message>
    <message>
        <source>The run that found this pose did not trust it.</source>
        <comment>pose.run-distrusted</comment>
        <translation>Der Lauf, der diese Lage fand, traute ihr nicht.</translation>
    </message>
    <message>
        <source>Not the same patient in all images?</source>
        <comment>picture.not-same-patient</comment>
        <translation>Nicht in allen Bildern derselbe Patient?</translation>
    </message>
    <message>
        <source>Two of the angiograms are of different examinations (accession number differs): the vessels may have moved between them.</source>
        <comment>patient.examination-of-runs-differs</comment>
        <translation>Zwei der Angiogramme stammen aus verschiedenen Untersuchungen (Anforderungsnummer weicht ab): Die Gefäße können sich dazwischen bewegt haben.</translation>
    </message>
    <message>
        <source>Do these images belong together?</source>
        <comment>picture.not-together</comment>
        <translation>Gehören diese Bilder zusammen?</translation>
    </message>
    <message>
        <source>Scan and angiogram seem to be of different patients (%1 differs). Check that both are the right ones.</source>
        <comment>patient.differs</comment>
        <translation>CT und Angiogramm scheinen von verschiedenen Patienten zu sein (%1 verschieden). Prüfen, ob beide stimmen.</translation>
    </message>
    <message>
        <source>Scan and angiogram seem to be of different patients (%1 differ). Check that both are the right ones.</source>
        <comment>patient.differs-in-several</comment>
        <translation>CT und Angiogramm scheinen von verschiedenen Patienten zu sein (%1 verschieden). Prüfen, ob beide stimmen.</translation>
    </message>
    <message>
        <source>number</source>
        <comment>patient.number</comment>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>name</source>
        <comment>patient.name</comment>
        <translation>Name</translation>
    </message>
    <message>
        <source>birth date</source>
        <comment>patient.birth-date</comment>
        <translation>Geburtsdatum</translation>
    </message>
    <message>
        <source>sex</source>
        <comment>patient.sex</comment>
        <translation>Geschlecht</translation>
    </message>
    <message>
        <source>The scan is of the patient&apos;s %1 side, the angiogram of the other. Check that both are the right ones.</source>
        <comment>patient.side-differs</comment>
        <translation>Das CT zeigt die Seite %1 des Patienten, das Angiogramm die andere. Prüfen, ob beide stimmen.</translation>
    </message>
    <message>
        <source>left</source>
        <comment>patient.side-left</comment>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <comment>patient.side-right</comment>
        <translation>rechts</translation>
    </message>
    <message>
        <source>There is no angiogram yet. Give an image first.</source>
        <comment>case.no-angiogram</comment>
        <translation>Noch kein Angiogramm. Zuerst ein Bild angeben.</translation>
    </message>
    <message>
        <source>There is no vessel tree yet. Give a centreline first.</source>
        <comment>case.no-vessel-tree</comment>
        <translation>Noch kein Gefäßbaum. Zuerst eine Mittellinie angeben.</translation>
    </message>
    <message>
        <source>All six degrees of freedom are locked: nothing is left to find. Unlock at least one.</source>
        <comment>options.all-locked</comment>
        <translation>Alle sechs Freiheitsgrade sind gesperrt: nichts bleibt zu finden. Mindestens einen entsperren.</translation>
    </message>
    <message>
        <source>%1 solves for all six degrees of freedom at once and cannot keep one. Unlock them, or choose another method.</source>
        <comment>options.method-cannot-lock</comment>
        <translation>%1 löst alle sechs Freiheitsgrade zugleich und kann keinen festhalten. Entsperren oder andere Methode wählen.</translation>
    </message>
    <message>
        <source>There is no method &apos;%1&apos;. Choose one of: %2.</source>
        <comment>options.no-such-method</comment>
        <translation>Es gibt keine Methode „%1“. Wählbar: %2.</translation>
    </message>
    <message>
        <source>The option %1 is out of range. Give a number from %2 to %3.</source>
        <comment>options.out-of-range</comment>
        <translation>Die Option %1 liegt außerhalb des Bereichs. Eine Zahl von %2 bis %3 angeben.</translation>
    </message>
    <message>
        <source>Option &apos;%1&apos; needs a value, not &apos;%2&apos;.</source>
        <comment>options.needs-value</comment>
        <translation>Die Option „%1“ braucht einen Wert, nicht „%2“.</translation>
    </message>
    <message>
        <source>Option &apos;%1&apos; must be one of %2, not &apos;%3&apos;.</source>
        <comment>options.needs-choice</comment>
        <translation>Die Option „%1“ muss eines von %2 sein, nicht „%3“.</translation>
    </message>
    <message>
        <source>Option &apos;%1&apos; must be a whole number, not %2.</source>
        <comment>options.needs-whole-number</comment>
        <translation>Die Option „%1“ muss eine ganze Zahl sein, nicht %2.</translation>
    </message>
    <message>
        <source>Option &apos;%1&apos; must lie between %2 and %3, not %4.</source>
        <comment>options.value-out-of-range</comment>
        <translation>Die Option „%1“ muss zwischen %2 und %3 liegen, nicht %4.</translation>
    </message>
    <message>
        <source>Option &apos;%1&apos; is unknown. See the options in: angiopose-cli register --help</source>
        <comment>options.no-such-option</comment>
        <translation>Die Option „%1“ ist unbekannt. Die Optionen stehen in: angiopose-cli register --help</translation>
    </message>
    <message>
        <source>Branch %1 is chosen as %2 but the vessel tree has no such branch. Choose among its branches.</source>
        <comment>input.chosen-branch-missing</comment>
        <translation>Ast %1 ist als %2 gewählt, aber der Gefäßbaum hat ihn nicht. Unter seinen Ästen wählen.</translation>
    </message>
    <message>
        <source>auxiliary</source>
        <comment>input.role-auxiliary</comment>
        <translation>Hilfsäste</translation>
    </message>
    <message>
        <source>excluded</source>
        <comment>input.role-excluded</comment>
        <translation>ausgeschlossen</translation>
    </message>
    <message>
        <source>All branches of the vessel tree are excluded. Include at least one branch.</source>
        <comment>input.all-branches-excluded</comment>
        <translation>Alle Äste des Gefäßbaums sind ausgeschlossen. Mindestens einen einschließen.</translation>
    </message>
    <message>
        <source>The image is not of the size that the camera takes. Use the camera that belongs to the image.</source>
        <comment>input.image-not-of-camera</comment>
        <translation>Das Bild hat nicht die Größe der Kamera. Die zum Bild gehörende Kamera verwenden.</translation>
    </message>
    <message>
        <source>%1 points of the traced vessels came in no order: each was joined to its neighbours.</source>
        <comment>input.target-reordered</comment>
        <translation>%1 Punkte der verfolgten Gefäße kamen ohne Reihenfolge: jeder wurde mit seinen Nachbarn verbunden.</translation>
    </message>
    <message>
        <source>The chosen branches lie %1 from the traced vessels at the median; in the fit of all branches it was %2. Choosing them turned the pose by %3 and shifted it by %4.</source>
        <comment>result.chosen-branches-fitted</comment>
        <translation>Die gewählten Äste liegen im Median %1 neben den verfolgten Gefäßen; in der Anpassung aller Äste waren es %2. Die Wahl hat die Lage um %3 gedreht und um %4 verschoben.</translation>
    </message>
    <message>
        <source>Where they may leave the rigid pose, the vessels move by %1 (rms; %2 at most) towards the matched branches: the median distance becomes %3, with the rigid pose it is %4. The pose is the rigid one.</source>
        <comment>result.matched-branches-moved</comment>
        <translation>Wo sie die starre Lage verlassen dürfen, bewegen sich die Gefäße um %1 (rms; höchstens %2) auf die zugeordneten Äste zu: der mittlere Abstand (Median) wird %3, mit der starren Lage ist er %4. Die Lage ist die starre.</translation>
    </message>
    <message>
        <source>The start pose is not a rigid motion: its rotation must be orthonormal with determinant +1 and all numbers finite. Correct cameraFromPatient or derive the start pose from the angles.</source>
        <comment>input.start-pose-not-rigid</comment>
        <translation>Die Startlage ist keine starre Bewegung: die Drehung muss orthonormal mit Determinante +1 sein, alle Zahlen endlich. cameraFromPatient berichtigen oder die Startlage aus den Winkeln ableiten.</translation>
    </message>
    <message>
        <source>The start pose puts vessels at or behind the X-ray source, where nothing projects. Check the source-to-patient distance and the direction of the start pose.</source>
        <comment>input.start-pose-behind-source</comment>
        <translation>Die Startlage setzt Gefäße an oder hinter den Röntgenfokus, wo nichts projiziert. Abstand Fokus–Patient und Richtung der Startlage prüfen.</translation>
    </message>
    <message>
        <source>The pose to judge is not a rigid motion: its rotation must be orthonormal with determinant +1 and all numbers finite.</source>
        <comment>input.judged-pose-not-rigid</comment>
        <translation>Die zu beurteilende Lage ist keine starre Bewegung: die Drehung muss orthonormal mit Determinante +1 sein, alle Zahlen endlich.</translation>
    </message>
    <message>
        <source>There are no landmarks yet. Click a place on the vessels and the same place in the image.</source>
        <comment>landmarks.missing</comment>
        <translation>Noch keine Landmarken. Eine Stelle an den Gefäßen und dieselbe im Bild anklicken.</translation>
    </message>
    <message>
        <source>Without angles a pose needs four landmarks; there are %1. Add landmarks, or type the angles: then one is enough.</source>
        <comment>landmarks.too-few</comment>
        <translation>Ohne Winkel braucht eine Lage vier Landmarken; es sind %1. Hinzufügen, oder die Winkel eintragen: dann genügt eine.</translation>
    </message>
    <message>
        <source>A landmark is not a finite number. Remove it.</source>
        <comment>landmarks.not-finite</comment>
        <translation>Eine Landmarke ist keine endliche Zahl. Entfernen.</translation>
    </message>
    <message>
        <source>The landmarks all lie in one place. Choose some farther apart.</source>
        <comment>landmarks.in-one-place</comment>
        <translation>Die Landmarken liegen alle an einer Stelle. Weiter auseinander liegende wählen.</translation>
    </message>
    <message>
        <source>The landmarks lie on one line, so the turn about it stays open. Add one off that line.</source>
        <comment>landmarks.on-one-line</comment>
        <translation>Die Landmarken liegen auf einer Linie, die Drehung um sie bleibt offen. Eine daneben hinzufügen.</translation>
    </message>
    <message>
        <source>No pose lays these landmarks onto their pixels. Check that each pair shows the same place.</source>
        <comment>landmarks.no-pose</comment>
        <translation>Keine Lage legt diese Landmarken auf ihre Pixel. Prüfen, ob jedes Paar dieselbe Stelle zeigt.</translation>
    </message>
    <message>
        <source>View %1: %2</source>
        <comment>views.in-view</comment>
        <translation>Ansicht %1: %2</translation>
    </message>
    <message>
        <source>A joint registration needs at least two views.</source>
        <comment>views.too-few</comment>
        <translation>Eine gemeinsame Registrierung braucht mindestens zwei Ansichten.</translation>
    </message>
    <message>
        <source>A joint registration cannot keep single degrees of freedom. Unlock them first.</source>
        <comment>views.cannot-lock</comment>
        <translation>Eine gemeinsame Registrierung kann einzelne Freiheitsgrade nicht festhalten. Zuerst entsperren.</translation>
    </message>
    <message>
        <source>View %1 uses another vessel tree or other branches than view %2. Give all views the same.</source>
        <comment>views.other-tree</comment>
        <translation>Ansicht %1 verwendet einen anderen Gefäßbaum oder andere Äste als Ansicht %2. Allen dasselbe geben.</translation>
    </message>
    <message>
        <source>View %1 does not agree with the joint pose.</source>
        <comment>views.disagrees</comment>
        <translation>Ansicht %1 passt nicht zur gemeinsamen Lage.</translation>
    </message>
    <message>
        <source>The geometry of view %1 is far from its header: check angles and distances.</source>
        <comment>views.far-from-header</comment>
        <translation>Die Geometrie der Ansicht %1 weicht weit von ihrem Header ab: Winkel und Abstände prüfen.</translation>
    </message>
    <message>
        <source>There is only one frame: nothing to follow. Open a run of several frames.</source>
        <comment>follow.one-frame</comment>
        <translation>Nur ein Bild: nichts zu verfolgen. Eine Serie mit mehreren Bildern öffnen.</translation>
    </message>
    <message>
        <source>The vessels of this frame are given by a file, those of the others are not. Take the given centreline out of the case to trace every frame.</source>
        <comment>follow.given-target</comment>
        <translation>Die Gefäße dieses Bildes stammen aus einer Datei, die der anderen nicht. Die gegebene Mittellinie aus dem Fall nehmen, um jedes Bild zu erfassen.</translation>
    </message>
    <message>
        <source>The gantry turns during this run: frames show other views, not only motion. Register the frames one by one, or as views together.</source>
        <comment>follow.gantry-turns</comment>
        <translation>Der C-Bogen dreht sich während der Serie: die Bilder zeigen andere Ansichten, nicht nur Bewegung. Bilder einzeln oder gemeinsam als Ansichten registrieren.</translation>
    </message>
    <message>
        <source>Only %1 of the vessel tree lies inside the image.</source>
        <comment>trust.outside-image</comment>
        <translation>Nur %1 des Gefäßbaums liegen im Bild.</translation>
    </message>
    <message>
        <source>Only %1 of the vessel tree lies on a traced vessel, and it explains %2 of the traced vessels.</source>
        <comment>trust.little-agreement</comment>
        <translation>Nur %1 des Gefäßbaums liegen auf einem erkannten Gefäß, und er erklärt %2 der erkannten Gefäße.</translation>
    </message>
    <message>
        <source>The vessel tree explains only %1 of the traced vessels. Check that it belongs to the image and that its lengths are mm.</source>
        <comment>trust.little-explained</comment>
        <translation>Der Gefäßbaum erklärt nur %1 der erkannten Gefäße. Prüfen, ob er zum Bild gehört und seine Längen mm sind.</translation>
    </message>
    <message>
        <source>The vessels fit better %1 aside.</source>
        <comment>trust.better-aside</comment>
        <translation>Die Gefäße passen %1 daneben besser.</translation>
    </message>
    <message>
        <source>The image hardly tells how the vessels are tilted out of the image plane.</source>
        <comment>trust.out-of-plane-uncertain</comment>
        <translation>Das Bild verrät kaum, wie die Gefäße aus der Bildebene gekippt sind.</translation>
    </message>
    <message>
        <source>The image hardly tells how the vessels are turned in the image plane.</source>
        <comment>trust.in-plane-turn-uncertain</comment>
        <translation>Das Bild verrät kaum, wie die Gefäße in der Bildebene gedreht sind.</translation>
    </message>
    <message>
        <source>The image hardly tells where along the vessels the tree lies.</source>
        <comment>trust.shift-uncertain</comment>
        <translation>Das Bild verrät kaum, wo längs der Gefäße der Gefäßbaum liegt.</translation>
    </message>
    <message>
        <source>The image leaves the pose uncertain by about %1.</source>
        <comment>trust.pose-uncertain</comment>
        <translation>Das Bild lässt die Lage um etwa %1 unsicher.</translation>
    </message>
    <message>
        <source>Another pose explains the image nearly as well: compare the alternatives.</source>
        <comment>trust.rival</comment>
        <translation>Eine andere Lage erklärt das Bild fast ebenso gut: die Alternativen vergleichen.</translation>
    </message>
    <message>
        <source>Fits that look like this one lie within 2 mm of the vessels in %1 of cases only.</source>
        <comment>trust.often-fails</comment>
        <translation>Anpassungen, die so aussehen, liegen nur in %1 der Fälle höchstens 2 mm neben den Gefäßen.</translation>
    </message>
    <message>
        <source>The registration was stopped before its end.</source>
        <comment>trust.stopped</comment>
        <translation>Die Registrierung wurde vor ihrem Ende angehalten.</translation>
    </message>
    <message>
        <source>The image shows %1 of the vessel tree. These branches seem not to be filled: %2. The pose rests on the others.</source>
        <comment>trust.part-filled</comment>
        <translation>Das Bild zeigt %1 des Gefäßbaums. Diese Äste scheinen nicht gefüllt zu sein: %2. Die Lage beruht auf den übrigen.</translation>
    </message>
    <message>
        <source>The image shows %1 of the vessel tree: %2 of %3 branches seem not to be filled. The pose rests on the others.</source>
        <comment>trust.few-filled</comment>
        <translation>Das Bild zeigt %1 des Gefäßbaums: %2 von %3 Ästen scheinen nicht gefüllt zu sein. Die Lage beruht auf den übrigen.</translation>
    </message>
    <message>
        <source>The image shows %1 of the vessel tree, and of no branch the greater part. The pose rests on the pieces that it shows.</source>
        <comment>trust.pieces-filled</comment>
        <translation>Das Bild zeigt %1 des Gefäßbaums und von keinem Ast den größeren Teil. Die Lage beruht auf den Stücken, die es zeigt.</translation>
    </message>
    <message>
        <source>Only a part of the vessel tree seems to be filled, and it explains the image too little to be sure of it.</source>
        <comment>trust.filled-doubtful</comment>
        <translation>Nur ein Teil des Gefäßbaums scheint gefüllt zu sein, und er erklärt das Bild zu wenig, um sicher zu sein.</translation>
    </message>
    <message>
        <source>Only one path of the vessels is seen. It fits in many places, and a wire or catheter lies beside its axis: the method for wires ranks its ways.</source>
        <comment>trust.single-path</comment>
        <translation>Nur ein Weg der Gefäße ist zu sehen. Er passt an viele Stellen, und ein Draht oder Katheter liegt neben seiner Achse: Das Verfahren für Drähte ordnet dessen Wege.</translation>
    </message>
    <message>
        <source>One view does not tell the depth here: the distance from the source stays close to the start pose.</source>
        <comment>trust.depth-unknown</comment>
        <translation>Eine Ansicht allein verrät die Tiefe hier nicht: der Abstand vom Fokus bleibt nahe der Startlage.</translation>
    </message>
    <message>
        <source>One view does not tell the depth here: the distance from the source is %1 off the start pose and may be wrong. Lock the depth, or add a view.</source>
        <comment>trust.depth-moved</comment>
        <translation>Eine Ansicht allein verrät die Tiefe hier nicht: der Abstand vom Fokus weicht um %1 von der Startlage ab und kann falsch sein. Sperren Sie die Tiefe, oder nehmen Sie eine Ansicht hinzu.</translation>
    </message>
    <message>
        <source>The vessels fit clearly better with a focal length %1 longer. Check the distance from source to detector (perhaps larger) and the pixel spacing (perhaps smaller). The option “Estimate the geometry” takes over what the images show.</source>
        <comment>camera.focal-longer</comment>
        <translation>Die Gefäße passen deutlich besser mit einer um %1 längeren Brennweite. Prüfen Sie den Abstand Fokus–Detektor (vielleicht größer) und den Pixelabstand (vielleicht kleiner). Die Option „Geometrie schätzen“ übernimmt, was die Bilder zeigen.</translation>
    </message>
    <message>
        <source>The vessels fit clearly better with a focal length %1 shorter. Check the distance from source to detector (perhaps smaller) and the pixel spacing (perhaps larger). The option “Estimate the geometry” takes over what the images show.</source>
        <comment>camera.focal-shorter</comment>
        <translation>Die Gefäße passen deutlich besser mit einer um %1 kürzeren Brennweite. Prüfen Sie den Abstand Fokus–Detektor (vielleicht kleiner) und den Pixelabstand (vielleicht größer). Die Option „Geometrie schätzen“ übernimmt, was die Bilder zeigen.</translation>
    </message>
    <message>
        <source>The images contradicted the geometry and it was estimated from them: the focal length is %1 of the given one, the principal point lies (%2, %3) px beside it.</source>
        <comment>camera.estimated</comment>
        <translation>Die Bilder widersprachen der Geometrie, und sie wurde aus ihnen geschätzt: Die Brennweite ist %1 der gegebenen, der Hauptpunkt liegt (%2, %3) px daneben.</translation>
    </message>
    <message>
        <source>The vessels fit clearly better with the principal point %1 aside, at (%2, %3). Check it, and whether the image was cropped or shifted.</source>
        <comment>camera.principal-point-off</comment>
        <translation>Die Gefäße passen deutlich besser, wenn der Hauptpunkt um %1 daneben liegt, bei (%2, %3). Prüfen Sie ihn, und ob das Bild beschnitten oder verschoben wurde.</translation>
    </message>
    <message>
        <source>The image looks turned clockwise by 90°: turned back, %1 of vessels and image agree, as it is %2. Check how it was exported, or the roll.</source>
        <comment>frame.turned-clockwise</comment>
        <translation>Das Bild scheint um 90° im Uhrzeigersinn gedreht: zurückgedreht stimmen %1 von Gefäßen und Bild überein, so wie es ist %2. Prüfen Sie, wie es exportiert wurde, oder die Bilddrehung.</translation>
    </message>
    <message>
        <source>The image looks turned anticlockwise by 90°: turned back, %1 of vessels and image agree, as it is %2. Check how it was exported, or the roll.</source>
        <comment>frame.turned-anticlockwise</comment>
        <translation>Das Bild scheint um 90° gegen den Uhrzeigersinn gedreht: zurückgedreht stimmen %1 von Gefäßen und Bild überein, so wie es ist %2. Prüfen Sie, wie es exportiert wurde, oder die Bilddrehung.</translation>
    </message>
    <message>
        <source>The image looks turned by 180°: turned back, %1 of vessels and image agree, as it is %2. Check how it was exported, the roll, and the patient&apos;s position.</source>
        <comment>frame.upside-down</comment>
        <translation>Das Bild scheint um 180° gedreht: zurückgedreht stimmen %1 von Gefäßen und Bild überein, so wie es ist %2. Prüfen Sie, wie es exportiert wurde, die Bilddrehung und die Lagerung des Patienten.</translation>
    </message>
    <message>
        <source>The image looks mirrored left to right: mirrored back, %1 of vessels and image agree, as it is %2. Check in the geometry from which side it is shown.</source>
        <comment>frame.mirrored-left-right</comment>
        <translation>Das Bild scheint links und rechts vertauscht: zurückgespiegelt stimmen %1 von Gefäßen und Bild überein, so wie es ist %2. Prüfen Sie in der Geometrie, von welcher Seite es gezeigt wird.</translation>
    </message>
    <message>
        <source>The image looks mirrored up to down: mirrored back, %1 of vessels and image agree, as it is %2. Check how it was exported.</source>
        <comment>frame.mirrored-up-down</comment>
        <translation>Das Bild scheint oben und unten vertauscht: zurückgespiegelt stimmen %1 von Gefäßen und Bild überein, so wie es ist %2. Prüfen Sie, wie es exportiert wurde.</translation>
    </message>
    <message>
        <source>The image looks mirrored and turned by 90°: put right, %1 of vessels and image agree, as it is %2. Check how it was exported.</source>
        <comment>frame.mirrored-and-turned</comment>
        <translation>Das Bild scheint gespiegelt und um 90° gedreht: zurechtgerückt stimmen %1 von Gefäßen und Bild überein, so wie es ist %2. Prüfen Sie, wie es exportiert wurde.</translation>
    </message>
    <message>
        <source>The patient lay %1, and the device seems to count its angles from the table: read so, %2 of vessels and image agree, as it is %3. Type these in the geometry: LAO/RAO %4, CRA/CAU %5, roll %6.</source>
        <comment>frame.counted-from-table</comment>
        <translation>Der Patient lag %1, und das Gerät scheint seine Winkel vom Tisch aus zu zählen: so gelesen stimmen %2 von Gefäßen und Bild überein, so wie es ist %3. Geben Sie in der Geometrie ein: LAO/RAO %4, CRA/CAU %5, Bilddrehung %6.</translation>
    </message>
    <message>
        <source>Mirrored, the image fits the vessels about as well (%1 of both agree, as it is %2): make sure from which side it is shown.</source>
        <comment>frame.mirror-rival</comment>
        <translation>Gespiegelt passt das Bild etwa ebenso gut zu den Gefäßen (%1 von beiden stimmen überein, so wie es ist %2): vergewissern Sie sich, von welcher Seite es gezeigt wird.</translation>
    </message>
    <message>
        <source>The patient lay %1 (0018,5100), not head first and supine. The angles are read as the standard has them: from the patient, head up in the image. If this device counts them from the table, the start pose is turned: a registration that fails tries that, and says which angles to type.</source>
        <comment>dicom.patient-lies</comment>
        <translation>Der Patient lag %1 (0018,5100), nicht Kopf voran auf dem Rücken. Die Winkel gelten wie im Standard: vom Patienten aus, im Bild ist der Kopf oben. Zählt dieses Gerät sie vom Tisch aus, so ist die Startlage gedreht: eine Registrierung, die misslingt, versucht das und sagt, welche Winkel einzugeben sind.</translation>
    </message>
    <message>
        <source>The table moved during this run (%1). That is not used: a pose holds for its own frame only, and frames are not views of one place.</source>
        <comment>dicom.table-moved</comment>
        <translation>Der Tisch bewegte sich während dieser Serie (%1). Das wird nicht verwendet: eine Lage gilt nur für ihr eigenes Bild, und die Bilder sind keine Ansichten desselben Ortes.</translation>
    </message>
    <message>
        <source>the header does not say how far</source>
        <comment>dicom.table-moved-unknown</comment>
        <translation>der Header sagt nicht, wie weit</translation>
    </message>
    <message>
        <source>Bent vessels need at least one registered view.</source>
        <comment>bend.no-view</comment>
        <translation>Verbogene Gefäße brauchen mindestens eine registrierte Ansicht.</translation>
    </message>
    <message>
        <source>The traced vessels are single points. Order them to curves before the tree is bent onto them.</source>
        <comment>bend.needs-curves</comment>
        <translation>Die nachgezeichneten Gefäße sind einzelne Punkte. Vor dem Verbiegen zu Kurven ordnen.</translation>
    </message>
    <message>
        <source>The priors of the pose and the spacing of the knots must be positive numbers.</source>
        <comment>bend.options-unusable</comment>
        <translation>Die Vorannahmen der Lage und der Abstand der Stützstellen müssen positive Zahlen sein.</translation>
    </message>
    <message>
        <source>The vessels are bent against the tree: the rigid overlay lies %1 off in the mean, most at branch %3 (%2).</source>
        <comment>bend.rigid-off</comment>
        <translation>Die Gefäße sind gegen den Baum verbogen: Die starre Überlagerung liegt im Mittel %1 daneben, am meisten an Ast %3 (%2).</translation>
    </message>
    <message>
        <source>The vessels may be bent against the tree, the image does not show it surely: the rigid overlay would lie %1 off in the mean, most at branch %3 (%2).</source>
        <comment>bend.may-be-off</comment>
        <translation>Die Gefäße sind vielleicht gegen den Baum verbogen, sicher zeigt es das Bild nicht: Die starre Überlagerung läge im Mittel %1 daneben, am meisten an Ast %3 (%2).</translation>
    </message>
    <message>
        <source>Bending was stopped before its end: the rigid pose stays.</source>
        <comment>bend.stopped</comment>
        <translation>Das Verbiegen wurde vor dem Ende angehalten: Die starre Lage bleibt.</translation>
    </message>
    <message>
        <source>Runs from different starts differ by %1: some branches may lie on other vessels.</source>
        <comment>bend.runs-differ</comment>
        <translation>Läufe von verschiedenen Anfängen unterscheiden sich um %1: Einige Äste liegen vielleicht auf anderen Gefäßen.</translation>
    </message>
    <message>
        <source>Only %1 of the vessel tree found its vessels in the image.</source>
        <comment>bend.little-seen</comment>
        <translation>Nur %1 des Gefäßbaums fand seine Gefäße im Bild.</translation>
    </message>
    <message>
        <source>The traced vessels still lie about %1 beside the bent tree: they moved in finer ways than it follows.</source>
        <comment>bend.not-followed</comment>
        <translation>Die nachgezeichneten Gefäße liegen noch etwa %1 neben dem verbogenen Baum: Sie bewegten sich feiner, als er folgt.</translation>
    </message>
    <message>
        <source>The part of the vessels towards the %1 (%2 of their length) lies %3 off against the rest, towards the %4.</source>
        <comment>bend.part-moved</comment>
        <translation>Der Teil der Gefäße in Richtung %1 (%2 ihrer Länge) liegt %3 neben dem Rest, in Richtung %4.</translation>
    </message>
    <message>
        <source>One view does not tell how the vessels moved along the ray.</source>
        <comment>bend.depth-unknown</comment>
        <translation>Eine Ansicht sagt nicht, wie sich die Gefäße entlang des Strahls bewegten.</translation>
    </message>
    <message>
        <source>front</source>
        <comment>side.front</comment>
        <translation>vorne</translation>
    </message>
    <message>
        <source>back</source>
        <comment>side.back</comment>
        <translation>hinten</translation>
    </message>
    <message>
        <source>head</source>
        <comment>side.head</comment>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>feet</source>
        <comment>side.feet</comment>
        <translation>Füße</translation>
    </message>
    <message>
        <source>The angiogram frame is empty. Choose another frame or file.</source>
        <comment>frame.empty</comment>
        <translation>Das Angiogrammbild ist leer. Anderes Bild oder andere Datei wählen.</translation>
    </message>
    <message>
        <source>The angiogram frame has pixels that are not a number (NaN or infinite). Choose another frame, or export the image again.</source>
        <comment>frame.not-finite</comment>
        <translation>Das Angiogrammbild hat Pixel, die keine Zahl sind (NaN oder unendlich). Anderes Bild wählen oder neu exportieren.</translation>
    </message>
    <message>
        <source>The angiogram frame is of one colour: there is nothing to trace. Choose another frame or file.</source>
        <comment>frame.one-colour</comment>
        <translation>Das Angiogrammbild ist einfarbig: es gibt nichts zu erkennen. Anderes Bild oder andere Datei wählen.</translation>
    </message>
    <message>
        <source>This is a page of text, as dose reports are, and no angiogram. Choose the run it belongs to, or another frame.</source>
        <comment>frame.report-page</comment>
        <translation>Das ist eine Textseite, wie Dosisberichte es sind, und kein Angiogramm. Wählen Sie die Serie, zu der sie gehört, oder ein anderes Bild.</translation>
    </message>
    <message>
        <source>What was traced here is in the first frame of the run already: no contrast medium comes between them. If the run holds none, these are catheters, wires and edges of bones, and no vessels.</source>
        <comment>frame.nothing-new</comment>
        <translation>Was hier erkannt wurde, zeigt schon das erste Bild der Serie: dazwischen kommt kein Kontrastmittel. Enthält die Serie keines, so sind es Katheter, Drähte und Knochenkanten und keine Gefäße.</translation>
    </message>
    <message>
        <source>Little here looks like vessels filled with contrast medium: what was traced is short or faint, or may be catheters, wires and edges of bones. Choose a fuller frame; if there is none, Edit traced vessels shows what counts.</source>
        <comment>frame.little-contrast</comment>
        <translation>Wenig sieht hier nach kontrastgefüllten Gefäßen aus: was erkannt wurde, ist kurz oder schwach oder gehört vielleicht zu Kathetern, Drähten und Knochenkanten. Ein volleres Bild wählen; gibt es keines, zeigt Erkannte Gefäße bearbeiten, was zählt.</translation>
    </message>
    <message>
        <source>Nothing like a vessel was found in the angiogram frame. Choose a frame with more contrast, raise the sensitivity, or check whether vessels are dark or bright.</source>
        <comment>frame.no-vessels</comment>
        <translation>Im Angiogrammbild wurde nichts Gefäßartiges gefunden. Ein Bild mit mehr Kontrast wählen, die Empfindlichkeit erhöhen, oder prüfen, ob Gefäße dunkel oder hell sind.</translation>
    </message>
    <message>
        <source>The thinnest vessel looked for (radius %1) must be positive and no wider than the widest (radius %2).</source>
        <comment>trace.radii-unusable</comment>
        <translation>Das dünnste gesuchte Gefäß (Radius %1) muss positiv und darf nicht weiter sein als das weiteste (Radius %2).</translation>
    </message>
    <message>
        <source>The sensitivity of tracing must be above 0, not %1.</source>
        <comment>trace.sensitivity-unusable</comment>
        <translation>Die Empfindlichkeit der Erkennung muss über 0 liegen, nicht %1.</translation>
    </message>
    <message>
        <source>The vessel mask has no vessel of at least %1 in it. Draw longer vessels, or lower the shortest length.</source>
        <comment>frame.mask-without-vessels</comment>
        <translation>Die Gefäßmaske enthält kein Gefäß von mindestens %1. Längere Gefäße zeichnen oder die kürzeste Länge senken.</translation>
    </message>
    <message>
        <source>The run has one frame: there is nothing to subtract. Choose a run with frames before the contrast.</source>
        <comment>subtraction.one-frame</comment>
        <translation>Die Serie hat nur ein Bild: nichts zu subtrahieren. Eine Serie mit Bildern vor dem Kontrastmittel wählen.</translation>
    </message>
    <message>
        <source>The frames of the run differ in size and cannot be subtracted.</source>
        <comment>subtraction.sizes-differ</comment>
        <translation>Die Bilder der Serie sind verschieden groß und lassen sich nicht subtrahieren.</translation>
    </message>
    <message>
        <source>The run shows contrast medium from its first frame on, so no frame serves as mask. Name the mask frames, or trace without subtraction.</source>
        <comment>subtraction.no-mask</comment>
        <translation>Die Serie zeigt vom ersten Bild an Kontrastmittel, kein Bild taugt als Maske. Maskenbilder nennen oder ohne Subtraktion erkennen.</translation>
    </message>
    <message>
        <source>The subtraction was stopped.</source>
        <comment>subtraction.stopped</comment>
        <translation>Die Subtraktion wurde angehalten.</translation>
    </message>
    <message>
        <source>The volume is empty. Choose another series or file.</source>
        <comment>volume.empty</comment>
        <translation>Das Volumen ist leer. Andere Serie oder Datei wählen.</translation>
    </message>
    <message>
        <source>The volume has more than 4 billion voxels. Crop or resample it first.</source>
        <comment>volume.too-large</comment>
        <translation>Das Volumen hat mehr als 4 Milliarden Voxel. Zuerst zuschneiden oder umrechnen.</translation>
    </message>
    <message>
        <source>The volume has no valid voxel spacing. Give the spacing in mm, or export the volume again.</source>
        <comment>volume.no-spacing</comment>
        <translation>Das Volumen hat keinen gültigen Voxelabstand. Abstand in mm angeben oder neu exportieren.</translation>
    </message>
    <message>
        <source>The volume is of one value: there is nothing to trace. Choose another series or file.</source>
        <comment>volume.one-value</comment>
        <translation>Das Volumen hat nur einen Wert: nichts zu erkennen. Andere Serie oder Datei wählen.</translation>
    </message>
    <message>
        <source>Tracing was stopped; nothing was kept.</source>
        <comment>tracing.stopped</comment>
        <translation>Die Erkennung wurde angehalten; nichts wurde behalten.</translation>
    </message>
    <message>
        <source>There is no vessel in the volume: nothing is set. Lower the threshold, or load another file.</source>
        <comment>tracing.nothing-set</comment>
        <translation>Im Volumen ist kein Gefäß: nichts ist gesetzt. Schwelle senken oder andere Datei laden.</translation>
    </message>
    <message>
        <source>Nothing in the volume is like a vessel: no branch is long enough. Lower the threshold or the shortest branch length.</source>
        <comment>tracing.no-long-branch</comment>
        <translation>Nichts im Volumen gleicht einem Gefäß: kein Ast ist lang genug. Schwelle oder kürzeste Astlänge senken.</translation>
    </message>
    <message>
        <source>No contrast-filled vessels were found: soft tissue has %1, and nothing even is as much brighter as contrast medium makes blood. Is this the arterial phase? Choose the CT angiogram, or give the threshold at which the vessels begin.</source>
        <comment>tracing.no-contrast</comment>
        <translation>Es wurden keine kontrastierten Gefäße gefunden: Weichgewebe hat %1, und nichts Gleichmäßiges ist so viel heller, wie Kontrastmittel das Blut macht. Ist dies die arterielle Phase? Die CT-Angiographie wählen oder die Schwelle angeben, ab der die Gefäße beginnen.</translation>
    </message>
    <message>
        <source>No contrast-filled vessels were found: besides bone the brightest has %1, soft tissue %2, and it is not like a vessel. Is this the arterial phase? Choose the CT angiogram, or give the threshold at which the vessels begin.</source>
        <comment>tracing.brightest-is-no-vessel</comment>
        <translation>Es wurden keine kontrastierten Gefäße gefunden: Das Hellste außer Knochen hat %1, Weichgewebe %2, und es gleicht keinem Gefäß. Ist dies die arterielle Phase? Die CT-Angiographie wählen oder die Schwelle angeben, ab der die Gefäße beginnen.</translation>
    </message>
    <message>
        <source>There are places to avoid, but no seed. Place at least one seed in the vessels.</source>
        <comment>tracing.avoid-without-seed</comment>
        <translation>Es gibt zu meidende Stellen, aber keinen Startpunkt. Mindestens einen in die Gefäße setzen.</translation>
    </message>
    <message>
        <source>(%1, %2, %3)</source>
        <comment>tracing.place</comment>
        <translation>(%1, %2, %3)</translation>
    </message>
    <message>
        <source>The seed %1 mm (LPS) lies in no vessel. Place it inside one, or lower the threshold.</source>
        <comment>tracing.seed-in-no-vessel</comment>
        <translation>Der Startpunkt %1 mm (LPS) liegt in keinem Gefäß. In eines setzen oder die Schwelle senken.</translation>
    </message>
    <message>
        <source>The seed %1 mm (LPS) lies in nothing filled: the vessel %2 away was taken.</source>
        <comment>tracing.seed-moved</comment>
        <translation>Der Startpunkt %1 mm (LPS) liegt in nichts Gefülltem: Das Gefäß im Abstand von %2 wurde genommen.</translation>
    </message>
    <message>
        <source>No seed was placed: the great vessel at %1 mm (LPS) was found and traced. Place a seed in another vessel if it is the wrong one.</source>
        <comment>tracing.no-seed-found-vessel</comment>
        <translation>Kein Startpunkt gesetzt: Das große Gefäß bei %1 mm (LPS) wurde gefunden und erfasst. Einen Startpunkt in ein anderes Gefäß setzen, wenn es das falsche ist.</translation>
    </message>
    <message>
        <source>No seed was placed, and nothing is like a great vessel: the largest piece was traced. Place a seed in the vessels if it is not them.</source>
        <comment>tracing.no-seed-largest-piece</comment>
        <translation>Kein Startpunkt gesetzt, und nichts gleicht einem großen Gefäß: Das größte Stück wurde erfasst. Einen Startpunkt in die Gefäße setzen, wenn es nicht diese sind.</translation>
    </message>
    <message>
        <source>This is a head, and which of its vessels are arteries is not clear: sinuses and veins may be filled, too. Place a seed in the artery that is to be traced, for example in a carotid artery in the neck or at the base of the skull.</source>
        <comment>tracing.head-needs-seed</comment>
        <translation>Dies ist ein Kopf, und welche seiner Gefäße Arterien sind, ist nicht klar: auch Sinus und Venen können gefüllt sein. Einen Startpunkt in die Arterie setzen, die erfasst werden soll, etwa in eine Halsschlagader am Hals oder an der Schädelbasis.</translation>
    </message>
    <message>
        <source>The values of this scan are no Hounsfield units, and nothing in it is a great vessel for sure. Place a seed in the artery that is to be traced, where it is wide.</source>
        <comment>tracing.scan-needs-seed</comment>
        <translation>Die Werte dieses Scans sind keine Hounsfield-Einheiten, und nichts darin ist mit Sicherheit ein großes Gefäß. Einen Startpunkt in die Arterie setzen, die erfasst werden soll, dort wo sie weit ist.</translation>
    </message>
    <message>
        <source>Arteries and sinuses of this head hang together and are filled alike: what was found without a seed runs along the skull. Place a seed in the artery that is to be traced, and mark the sinuses to be avoided.</source>
        <comment>tracing.veins-with-arteries</comment>
        <translation>Arterien und Sinus dieses Kopfes hängen zusammen und sind gleich gefüllt: was ohne Startpunkt gefunden wurde, läuft am Schädel entlang. Einen Startpunkt in die Arterie setzen, die erfasst werden soll, und die Sinus als zu meiden markieren.</translation>
    </message>
    <message>
        <source>The coil received up to %1 times weaker in parts of the body, which was evened out: the threshold holds where it received best.</source>
        <comment>tracing.coil-evened-out</comment>
        <translation>Die Spule empfing in Teilen des Körpers bis zu %1-mal schwächer; das wurde ausgeglichen: die Schwelle gilt, wo sie am besten empfing.</translation>
    </message>
    <message>
        <source>The curves follow %1 of the mask&apos;s own skeleton within two voxels; most of the rest is at %2 mm (LPS). Where the lumen is wide or its wall rough, they run along its middle instead. Look there for a vessel that is missing.</source>
        <comment>tracing.skeleton-not-followed</comment>
        <translation>Die Kurven folgen %1 des Skeletts der Maske bis auf zwei Voxel; das meiste vom Rest liegt bei %2 mm (LPS). Wo das Lumen weit oder seine Wand rau ist, laufen sie stattdessen in seiner Mitte. Dort nach einem fehlenden Gefäß sehen.</translation>
    </message>
    <message>
        <source>The place %1 mm (LPS) lies outside the scan. Choose one inside.</source>
        <comment>tracing.path-end-outside-scan</comment>
        <translation>Die Stelle %1 mm (LPS) liegt außerhalb des Scans. Wählen Sie eine innerhalb.</translation>
    </message>
    <message>
        <source>The place %1 mm (LPS) lies in nothing brighter than its surroundings. Place it inside the vessel.</source>
        <comment>tracing.path-end-in-nothing</comment>
        <translation>Die Stelle %1 mm (LPS) liegt in nichts, was heller ist als seine Umgebung. Setzen Sie sie in das Gefäß.</translation>
    </message>
    <message>
        <source>Both places lie at the same spot of the vessel. Place them farther apart.</source>
        <comment>tracing.path-ends-too-near</comment>
        <translation>Beide Stellen liegen am selben Punkt des Gefäßes. Setzen Sie sie weiter auseinander.</translation>
    </message>
    <message>
        <source>No way was found between the two places. Place them nearer to each other.</source>
        <comment>tracing.path-not-found</comment>
        <translation>Zwischen den beiden Stellen wurde kein Weg gefunden. Setzen Sie sie näher zusammen.</translation>
    </message>
    <message>
        <source>For %1 the path runs through nothing like a vessel. Look at it, or place a point in between.</source>
        <comment>tracing.path-outside</comment>
        <translation>Auf %1 führt der Weg durch nichts Gefäßartiges. Sehen Sie ihn an, oder setzen Sie eine Stelle dazwischen.</translation>
    </message>
    <message>
        <source>Thin vessels are traced from seeds, and none is placed. Place one in each vessel, near where it begins.</source>
        <comment>tracing.tubes-need-seed</comment>
        <translation>Dünne Gefäße werden von Startpunkten aus erfasst, und keiner ist gesetzt. Setzen Sie in jedes Gefäß einen, nahe seinem Anfang.</translation>
    </message>
    <message>
        <source>No thin vessel of any length leads from the seeds. Place them in the middle of the vessels, or trace without the restriction to thin ones.</source>
        <comment>tracing.no-tube-at-seed</comment>
        <translation>Von den Startpunkten führt kein dünnes Gefäß weiter. Setzen Sie sie in die Mitte der Gefäße, oder erfassen Sie ohne die Beschränkung auf dünne.</translation>
    </message>
    <message>
        <source>More was reached than is searched: the vessels are cut short. Look for a leak into lung, liver or bone.</source>
        <comment>tracing.tubes-cut-short</comment>
        <translation>Es wurde mehr erreicht, als durchsucht wird: die Gefäße sind abgeschnitten. Suchen Sie nach einem Übertritt in Lunge, Leber oder Knochen.</translation>
    </message>
    <message>
        <source>The vessels are %1 pieces that do not connect, each with a root of its own: %2. Join those that belong together, or ask for some by a seed in each.</source>
        <comment>tracing.vessels-in-pieces</comment>
        <translation>Die Gefäße sind %1 Stücke ohne Verbindung, jedes mit eigener Wurzel: %2. Verbinden, was zusammengehört, oder durch je einen Startpunkt einzelne wählen.</translation>
    </message>
    <message>
        <source>%1 (%2 of the voxels) at %3</source>
        <comment>tracing.piece-of-length</comment>
        <translation>%1 (%2 der Voxel) bei %3</translation>
    </message>
    <message>
        <source>%1 of the voxels at %2</source>
        <comment>tracing.piece-of-share</comment>
        <translation>%1 der Voxel bei %2</translation>
    </message>
    <message>
        <source>%1 others with %2</source>
        <comment>tracing.other-pieces</comment>
        <translation>%1 weitere mit %2</translation>
    </message>
    <message>
        <source>A piece that does not connect to the traced vessels was left out: %1 mm (LPS). Place a seed in it if it belongs to the tree.</source>
        <comment>tracing.one-piece-left-out</comment>
        <translation>Ein Stück ohne Verbindung zu den erkannten Gefäßen wurde ausgelassen: %1 mm (LPS). Einen Startpunkt hineinsetzen, wenn es zum Baum gehört.</translation>
    </message>
    <message>
        <source>%1 pieces with %2 of the voxels that do not connect to the traced vessels were left out: %3. Place a seed in each that belongs to the tree.</source>
        <comment>tracing.pieces-left-out</comment>
        <translation>%1 Stücke mit %2 der Voxel ohne Verbindung zu den erkannten Gefäßen wurden ausgelassen: %3. In jedes, das zum Baum gehört, einen Startpunkt setzen.</translation>
    </message>
    <message>
        <source>A piece holds no branch of the shortest length and was left out: %1 mm (LPS). Lower the shortest branch length if it is a vessel.</source>
        <comment>tracing.one-piece-too-short</comment>
        <translation>Ein Stück enthält keinen Ast der kürzesten Länge und wurde ausgelassen: %1 mm (LPS). Den kürzesten Ast verkleinern, wenn es ein Gefäß ist.</translation>
    </message>
    <message>
        <source>%1 pieces with %2 of the voxels hold no branch of the shortest length and were left out: %3. Lower the shortest branch length if they are vessels.</source>
        <comment>tracing.pieces-too-short</comment>
        <translation>%1 Stücke mit %2 der Voxel enthalten keinen Ast der kürzesten Länge und wurden ausgelassen: %3. Den kürzesten Ast verkleinern, wenn es Gefäße sind.</translation>
    </message>
    <message>
        <source>Gaps between pieces over which a vessel clearly goes on were closed: %1, of up to %2. Look there for vessels that do not belong together.</source>
        <comment>tracing.gaps-closed</comment>
        <translation>Lücken zwischen Stücken, über die ein Gefäß deutlich weiterläuft, wurden geschlossen: %1, bis %2. Dort nach Gefäßen sehen, die nicht zusammengehören.</translation>
    </message>
    <message>
        <source>1 loop was opened at the thinnest place: look there for vessels that only touch.</source>
        <comment>tracing.one-loop-opened</comment>
        <translation>1 Schleife wurde an der dünnsten Stelle geöffnet: dort nach Gefäßen sehen, die sich nur berühren.</translation>
    </message>
    <message>
        <source>%1 loops were opened at their thinnest places: look there for vessels that only touch.</source>
        <comment>tracing.loops-opened</comment>
        <translation>%1 Schleifen wurden an den dünnsten Stellen geöffnet: dort nach Gefäßen sehen, die sich nur berühren.</translation>
    </message>
    <message>
        <source>Loops that were kept, as asked: %1. A branch ends on another where one closes.</source>
        <comment>tracing.loops-kept</comment>
        <translation>Schleifen, die wie gewünscht erhalten blieben: %1. Wo eine sich schließt, endet ein Ast auf einem anderen.</translation>
    </message>
    <message>
        <source>A part less bright than the vessels was left out, as veins and organs are. Place a seed in it if it belongs to the tree.</source>
        <comment>tracing.one-dim-part-left-out</comment>
        <translation>Ein Teil, der weniger hell ist als die Gefäße, wurde weggelassen: so sehen Venen und Organe aus. Einen Startpunkt hineinsetzen, wenn er zum Baum gehört.</translation>
    </message>
    <message>
        <source>%1 parts less bright than the vessels were left out, as veins and organs are. Place seeds in those that belong to the tree.</source>
        <comment>tracing.dim-parts-left-out</comment>
        <translation>%1 Teile, die weniger hell sind als die Gefäße, wurden weggelassen: so sehen Venen und Organe aus. In die, die zum Baum gehören, einen Startpunkt setzen.</translation>
    </message>
    <message>
        <source>Nothing in the scan is as dark as air in Hounsfield units: if its values are others, bone cannot be told from blood for sure. Look for bone among the vessels, or export the scan in Hounsfield units.</source>
        <comment>tracing.perhaps-no-hounsfield</comment>
        <translation>Nichts im Scan ist so dunkel wie Luft in Hounsfield-Einheiten: Hat er andere Werte, lässt sich Knochen nicht sicher von Blut unterscheiden. Unter den Gefäßen nach Knochen suchen oder den Scan in Hounsfield-Einheiten exportieren.</translation>
    </message>
    <message>
        <source>The vessel tree has no branches. Give a centreline with at least one branch.</source>
        <comment>tree.no-branches</comment>
        <translation>Der Gefäßbaum hat keine Äste. Eine Mittellinie mit mindestens einem Ast angeben.</translation>
    </message>
    <message>
        <source>Branch %1 occurs twice in the vessel tree. Branch ids must be unique.</source>
        <comment>tree.branch-twice</comment>
        <translation>Ast %1 kommt im Gefäßbaum doppelt vor. Ast-Nummern müssen einmalig sein.</translation>
    </message>
    <message>
        <source>Branch %1 of the vessel tree has fewer than two points. Remove it or add points.</source>
        <comment>tree.branch-too-few-points</comment>
        <translation>Ast %1 des Gefäßbaums hat weniger als zwei Punkte. Entfernen oder Punkte ergänzen.</translation>
    </message>
    <message>
        <source>Branch %1 of the vessel tree has a coordinate that is not a number (NaN or infinite).</source>
        <comment>tree.branch-not-finite</comment>
        <translation>Ast %1 des Gefäßbaums hat eine Koordinate, die keine Zahl ist (NaN oder unendlich).</translation>
    </message>
    <message>
        <source>Branch %1 of the vessel tree has no length: all its points coincide.</source>
        <comment>tree.branch-without-length</comment>
        <translation>Ast %1 des Gefäßbaums hat keine Länge: alle Punkte fallen zusammen.</translation>
    </message>
    <message>
        <source>Branch %1 of the vessel tree does not have one radius per point.</source>
        <comment>tree.branch-radii-missing</comment>
        <translation>Ast %1 des Gefäßbaums hat nicht je Punkt einen Radius.</translation>
    </message>
    <message>
        <source>Branch %1 of the vessel tree has a radius that is negative or not a number. Correct it, or give no radii along this branch.</source>
        <comment>tree.branch-radius-unusable</comment>
        <translation>Ast %1 des Gefäßbaums hat einen Radius, der negativ oder keine Zahl ist. Ihn berichtigen oder diesem Ast keine Radien geben.</translation>
    </message>
    <message>
        <source>The vessel tree has no branch %1.</source>
        <comment>tree.no-such-branch</comment>
        <translation>Der Gefäßbaum hat keinen Ast %1.</translation>
    </message>
    <message>
        <source>The range of %1 must be two angles, the lower one first, within ±%2°.</source>
        <comment>angles.range-odd</comment>
        <translation>Der Bereich von %1 braucht zwei Winkel, den kleineren zuerst, innerhalb von ±%2°.</translation>
    </message>
    <message>
        <source>Looking for angles was stopped.</source>
        <comment>angles.stopped</comment>
        <translation>Die Suche nach Winkeln wurde angehalten.</translation>
    </message>
    <message>
        <source>The step between angles must be at least %1.</source>
        <comment>angles.step-too-fine</comment>
        <translation>Der Schritt zwischen den Winkeln muss mindestens %1 sein.</translation>
    </message>
    <message>
        <source>Select one branch in the image, in the 3-D view or in the list.</source>
        <comment>angles.select-one-branch</comment>
        <translation>Einen Ast im Bild, in der 3-D-Ansicht oder in der Liste auswählen.</translation>
    </message>
    <message>
        <source>The vessels come without radii: 1 mm is assumed, so what covers the branch is a guess.</source>
        <comment>tree.radii-assumed</comment>
        <translation>Die Gefäße haben keine Radien: 1 mm wird angenommen; was den Ast verdeckt, ist geschätzt.</translation>
    </message>
    <message>
        <source>Branch %1 meets no other branch: it has no take-off. Ask for the branch itself.</source>
        <comment>tree.no-take-off</comment>
        <translation>Ast %1 trifft auf keinen anderen: er hat keinen Abgang. Nach dem Ast selbst fragen.</translation>
    </message>
    <message>
        <source>Every branch hangs on branch %1: nothing would be left.</source>
        <comment>edit.all-hang-on-branch</comment>
        <translation>Alle Äste hängen an Ast %1: nichts bliebe übrig.</translation>
    </message>
    <message>
        <source>Every branch is shorter or thinner than asked: nothing would be left. Lower the limits.</source>
        <comment>edit.all-pruned</comment>
        <translation>Jeder Ast ist kürzer oder dünner als verlangt: nichts bliebe übrig. Grenzen senken.</translation>
    </message>
    <message>
        <source>Branch %1 cannot be cut so near to its end. Delete it instead, or cut farther in.</source>
        <comment>edit.cut-too-near-end</comment>
        <translation>Ast %1 lässt sich so nah am Ende nicht trennen. Stattdessen löschen oder weiter innen trennen.</translation>
    </message>
    <message>
        <source>The whole way runs inside vessels that are traced already: there is nothing to add.</source>
        <comment>edit.branch-runs-inside</comment>
        <translation>Der ganze Weg verläuft in Gefäßen, die schon erfasst sind: es gibt nichts hinzuzufügen.</translation>
    </message>
    <message>
        <source>A branch cannot be joined to itself. Choose two branches.</source>
        <comment>edit.joined-to-itself</comment>
        <translation>Ein Ast lässt sich nicht mit sich selbst verbinden. Zwei Äste wählen.</translation>
    </message>
    <message>
        <source>The 2-D centreline is empty: no vessel was found in the image. Choose another frame or a higher sensitivity, or give a centreline file.</source>
        <comment>centreline.empty</comment>
        <translation>Die 2-D-Mittellinie ist leer: im Bild wurde kein Gefäß gefunden. Anderes Bild oder höhere Empfindlichkeit wählen, oder eine Mittelliniendatei angeben.</translation>
    </message>
    <message>
        <source>Curve %1 of the 2-D centreline has a coordinate that is not a number (NaN or infinite).</source>
        <comment>centreline.curve-not-finite</comment>
        <translation>Kurve %1 der 2-D-Mittellinie hat eine Koordinate, die keine Zahl ist (NaN oder unendlich).</translation>
    </message>
    <message>
        <source>The surface has no triangles, or the voxel size is not positive. Choose another surface.</source>
        <comment>surface.empty</comment>
        <translation>Die Oberfläche hat keine Dreiecke, oder die Voxelgröße ist nicht positiv. Andere Oberfläche wählen.</translation>
    </message>
    <message>
        <source>The surface is flat: it bounds no inside. Choose the wall of a vessel.</source>
        <comment>surface.flat</comment>
        <translation>Die Oberfläche ist flach: sie umschließt nichts. Eine Gefäßwand wählen.</translation>
    </message>
    <message>
        <source>The voxel size is too fine for a surface of this extent. Choose a larger one.</source>
        <comment>surface.voxel-too-fine</comment>
        <translation>Die Voxelgröße ist für eine so große Oberfläche zu fein. Größere wählen.</translation>
    </message>
    <message>
        <source>Nothing lies inside the surface: it is too open, or thinner than a voxel. Close its holes, or choose a smaller voxel size.</source>
        <comment>surface.nothing-inside</comment>
        <translation>In der Oberfläche liegt nichts: sie ist zu offen oder dünner als ein Voxel. Löcher schließen oder kleinere Voxel wählen.</translation>
    </message>
    <message>
        <source>it is too large for a case file. Choose an .angiopose file.</source>
        <comment>case.too-large</comment>
        <translation>ist zu groß für eine Falldatei. Eine .angiopose-Datei wählen.</translation>
    </message>
    <message>
        <source>this is %1, not a case. Choose an .angiopose file.</source>
        <comment>case.is-other</comment>
        <translation>das ist %1, kein Fall. Eine .angiopose-Datei wählen.</translation>
    </message>
    <message>
        <source>this JSON is not an AngioPose case (its format is not &quot;angiopose-case&quot;). Choose an .angiopose file.</source>
        <comment>case.not-one</comment>
        <translation>dieses JSON ist kein AngioPose-Fall (sein format ist nicht &quot;angiopose-case&quot;). Eine .angiopose-Datei wählen.</translation>
    </message>
    <message>
        <source>a value in it has the wrong kind. Compare it with the published schema.</source>
        <comment>case.wrong-kind</comment>
        <translation>ein Wert darin ist von falscher Art. Mit dem veröffentlichten Schema vergleichen.</translation>
    </message>
    <message>
        <source>the case was saved by a newer AngioPose. Update the program.</source>
        <comment>case.newer</comment>
        <translation>der Fall stammt von einem neueren AngioPose. Das Programm aktualisieren.</translation>
    </message>
    <message>
        <source>the key %1 is missing. Add it.</source>
        <comment>case.key-missing</comment>
        <translation>der Schlüssel %1 fehlt. Ergänzen.</translation>
    </message>
    <message>
        <source>the value is not one of those allowed. See the published schema.</source>
        <comment>case.value-not-allowed</comment>
        <translation>der Wert ist nicht erlaubt. Siehe das veröffentlichte Schema.</translation>
    </message>
    <message>
        <source>the value is of the wrong kind. See the published schema.</source>
        <comment>case.value-of-wrong-kind</comment>
        <translation>der Wert ist von falscher Art. Siehe das veröffentlichte Schema.</translation>
    </message>
    <message>
        <source>%1 Correct it.</source>
        <comment>case.value-wrong</comment>
        <translation>%1 Berichtigen.</translation>
    </message>
    <message>
        <source>it does not follow the published schema. Compare it with a case that loads.</source>
        <comment>case.against-schema</comment>
        <translation>folgt nicht dem veröffentlichten Schema. Mit einem ladbaren Fall vergleichen.</translation>
    </message>
    <message>
        <source>this is an input of the case and will not be overwritten. Choose another name.</source>
        <comment>case.is-input</comment>
        <translation>das ist eine Eingabe des Falls und wird nicht überschrieben. Anderen Namen wählen.</translation>
    </message>
    <message>
        <source>a file name or a text in the case is not UTF-8. Rename the file.</source>
        <comment>case.not-utf8</comment>
        <translation>ein Dateiname oder Text im Fall ist nicht UTF-8. Die Datei umbenennen.</translation>
    </message>
    <message>
        <source>a scan alone is no case yet: the case file needs traced vessels and an angiogram. Trace the vessels and open an angiogram before saving; the scan itself stays as it is.</source>
        <comment>case.scan-alone</comment>
        <translation>ein CT allein ist noch kein Fall: die Falldatei braucht erfasste Gefäße und ein Angiogramm. Vor dem Speichern die Gefäße erfassen und ein Angiogramm öffnen; das CT selbst bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>a case needs a vessel tree and an angiogram. Open both before saving.</source>
        <comment>case.incomplete</comment>
        <translation>ein Fall braucht Gefäßbaum und Angiogramm. Vor dem Speichern beide öffnen.</translation>
    </message>
    <message>
        <source>the pose is not a rigid motion of finite numbers. Reset the pose before saving.</source>
        <comment>case.pose-not-rigid</comment>
        <translation>die Lage ist keine starre Bewegung endlicher Zahlen. Vor dem Speichern zurücksetzen.</translation>
    </message>
    <message>
        <source>it is for an image of %1 x %2 pixels, but the angiogram has %3 x %4. Give the camera of this image.</source>
        <comment>case.camera-of-other-image</comment>
        <translation>gilt für ein Bild mit %1 x %2 Pixeln, das Angiogramm hat aber %3 x %4. Die Kamera dieses Bildes angeben.</translation>
    </message>
    <message>
        <source>maxVesselRadiusPx is below minVesselRadiusPx. Exchange them.</source>
        <comment>case.radii-swapped</comment>
        <translation>maxVesselRadiusPx liegt unter minVesselRadiusPx. Beide vertauschen.</translation>
    </message>
    <message>
        <source>it names no input. Give the file of the vessels as centerline, segmentation, surface or volume.</source>
        <comment>case.no-input</comment>
        <translation>nennt keine Eingabe. Die Datei der Gefäße als centerline, segmentation, surface oder volume angeben.</translation>
    </message>
    <message>
        <source>%1 Remove the key to go back to the vessels as they were before the edits.</source>
        <comment>case.edited-tree</comment>
        <translation>%1 Den Schlüssel entfernen, um zu den unbearbeiteten Gefäßen zurückzukehren.</translation>
    </message>
    <message>
        <source>branch %1 is there twice.</source>
        <comment>case.branch-twice</comment>
        <translation>Ast %1 ist doppelt vorhanden.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is unknown. Use one of %2.</source>
        <comment>case.method-unknown</comment>
        <translation>&quot;%1&quot; ist unbekannt. Möglich: %2.</translation>
    </message>
    <message>
        <source>give a number from %1 to %2.</source>
        <comment>case.option-number</comment>
        <translation>eine Zahl von %1 bis %2 angeben.</translation>
    </message>
    <message>
        <source>give one of %1.</source>
        <comment>case.option-choice</comment>
        <translation>eines von %1 angeben.</translation>
    </message>
    <message>
        <source>it is missing, and the angles do not give a start pose. %1</source>
        <comment>case.no-start-pose</comment>
        <translation>fehlt, und die Winkel ergeben keine Startlage. %1</translation>
    </message>
    <message>
        <source>the file has changed since the case was saved. Check that it is the right one.</source>
        <comment>case.file-changed</comment>
        <translation>die Datei hat sich seit dem Speichern des Falls geändert. Prüfen, ob es die richtige ist.</translation>
    </message>
    <message>
        <source>what was found in it is left out, because the vessels, the image or the traced curves have changed since. Register again.</source>
        <comment>case.result-stale</comment>
        <translation>was darin gefunden wurde, ist weggelassen, weil sich Gefäße, Bild oder gezeichnete Kurven seither geändert haben. Neu registrieren.</translation>
    </message>
    <message>
        <source>what was found in it is left out, because the case file was changed since: %1. Register again.</source>
        <comment>case.result-beside</comment>
        <translation>was darin gefunden wurde, ist weggelassen, weil die Falldatei seither geändert wurde: %1. Neu registrieren.</translation>
    </message>
    <message>
        <source>where the vessels were followed to is left out, because it does not fit the run or the pose of the case. Follow them again.</source>
        <comment>case.followed-misfit</comment>
        <translation>wohin die Gefäße verfolgt wurden, ist weggelassen, weil es nicht zur Serie oder zur Lage des Falls passt. Neu verfolgen.</translation>
    </message>
    <message>
        <source>The vessels of a followed run are shown at their poses, but not bent: %1 Follow them again.</source>
        <comment>case.bends-left-out</comment>
        <translation>Die Gefäße einer verfolgten Serie werden in ihren Lagen gezeigt, aber nicht verbogen: %1 Neu verfolgen.</translation>
    </message>
    <message>
        <source>the case names no file of their bends.</source>
        <comment>case.bends-unnamed</comment>
        <translation>der Fall nennt keine Datei ihrer Verbiegungen.</translation>
    </message>
    <message>
        <source>this is no file of bends.</source>
        <comment>case.bends-none</comment>
        <translation>das ist keine Datei von Verbiegungen.</translation>
    </message>
    <message>
        <source>the bends are of other vessels or frames.</source>
        <comment>case.bends-of-others</comment>
        <translation>die Verbiegungen sind von anderen Gefäßen oder Bildern.</translation>
    </message>
    <message>
        <source>the bends are damaged or cut short.</source>
        <comment>case.bends-cut</comment>
        <translation>die Verbiegungen sind beschädigt oder abgeschnitten.</translation>
    </message>
    <message>
        <source>the file has changed since the case was saved.</source>
        <comment>case.bends-changed</comment>
        <translation>die Datei hat sich seit dem Speichern des Falls geändert.</translation>
    </message>
    <message>
        <source>the vessels</source>
        <comment>part.vessels</comment>
        <translation>die Gefäße</translation>
    </message>
    <message>
        <source>the auxiliary branches</source>
        <comment>part.auxiliary-branches</comment>
        <translation>die Hilfsäste</translation>
    </message>
    <message>
        <source>the excluded branches</source>
        <comment>part.excluded-branches</comment>
        <translation>die ausgeschlossenen Äste</translation>
    </message>
    <message>
        <source>the image</source>
        <comment>part.image</comment>
        <translation>das Bild</translation>
    </message>
    <message>
        <source>the frame</source>
        <comment>part.frame</comment>
        <translation>das Einzelbild</translation>
    </message>
    <message>
        <source>the subtraction</source>
        <comment>part.subtraction</comment>
        <translation>die Subtraktion</translation>
    </message>
    <message>
        <source>the traced curves</source>
        <comment>part.curves</comment>
        <translation>die gezeichneten Kurven</translation>
    </message>
    <message>
        <source>the geometry</source>
        <comment>part.geometry</comment>
        <translation>die Geometrie</translation>
    </message>
    <message>
        <source>the start pose</source>
        <comment>part.start-pose</comment>
        <translation>die Startlage</translation>
    </message>
    <message>
        <source>the locked axes</source>
        <comment>part.locks</comment>
        <translation>die gesperrten Achsen</translation>
    </message>
    <message>
        <source>the method</source>
        <comment>part.method</comment>
        <translation>die Methode</translation>
    </message>
    <message>
        <source>the options</source>
        <comment>part.options</comment>
        <translation>die Einstellungen</translation>
    </message>
    <message>
        <source>this is another DICOM image than the one the case was made for.</source>
        <comment>case.other-image</comment>
        <translation>das ist ein anderes DICOM-Bild als das des Falls.</translation>
    </message>
    <message>
        <source>%1 The edited vessels are in the case; it opens without the file.</source>
        <comment>case.opens-without</comment>
        <translation>%1 Die bearbeiteten Gefäße sind im Fall; er öffnet ohne die Datei.</translation>
    </message>
    <message>
        <source>the tree has no branch %1; it is left out.</source>
        <comment>case.branch-left-out</comment>
        <translation>der Baum hat keinen Ast %1; er wird ausgelassen.</translation>
    </message>
    <message>
        <source>Another view is left out: %1</source>
        <comment>case.view-left-out</comment>
        <translation>Eine weitere Ansicht wird ausgelassen: %1</translation>
    </message>
    <message>
        <source>line %1: the name &apos;%2&apos; is no folder name. Use one without &apos;/&apos;.</source>
        <comment>batch.no-folder-name</comment>
        <translation>Zeile %1: „%2“ ist kein Ordnername. Einen ohne „/“ wählen.</translation>
    </message>
    <message>
        <source>line %1: the frame &apos;%2&apos; is no whole number.</source>
        <comment>batch.frame-no-number</comment>
        <translation>Zeile %1: das Bild „%2“ ist keine ganze Zahl.</translation>
    </message>
    <message>
        <source>line %1: the name &apos;%2&apos; is taken. Give each case its own.</source>
        <comment>batch.name-twice</comment>
        <translation>Zeile %1: der Name „%2“ ist vergeben. Jedem Fall einen eigenen geben.</translation>
    </message>
    <message>
        <source>the column %1 is missing. Give a folder that `angiopose-cli evaluate` wrote.</source>
        <comment>runs.column-missing</comment>
        <translation>die Spalte %1 fehlt. Einen Ordner angeben, den `angiopose-cli evaluate` geschrieben hat.</translation>
    </message>
    <message>
        <source>line %1, column %2 holds no number. Give a folder that `angiopose-cli evaluate` wrote.</source>
        <comment>runs.no-number</comment>
        <translation>Zeile %1, Spalte %2 enthält keine Zahl. Einen Ordner angeben, den `angiopose-cli evaluate` geschrieben hat.</translation>
    </message>
    <message>
        <source>it mixes experiments or seeds. Give each its own folder.</source>
        <comment>runs.mixed</comment>
        <translation>mischt Experimente oder Startwerte. Jedem einen eigenen Ordner geben.</translation>
    </message>
    <message>
        <source>reading was stopped.</source>
        <comment>file.reading-stopped</comment>
        <translation>das Lesen wurde angehalten.</translation>
    </message>
    <message>
        <source>there is no such file. Check the path.</source>
        <comment>file.missing</comment>
        <translation>die Datei gibt es nicht. Pfad prüfen.</translation>
    </message>
    <message>
        <source>it cannot be reached (%1). Check the path.</source>
        <comment>file.unreachable</comment>
        <translation>ist nicht erreichbar (%1). Pfad prüfen.</translation>
    </message>
    <message>
        <source>it cannot be opened (%1). Check that you may read it.</source>
        <comment>file.not-opened</comment>
        <translation>lässt sich nicht öffnen (%1). Leserechte prüfen.</translation>
    </message>
    <message>
        <source>it cannot be read (%1). Copy it to a local disk.</source>
        <comment>file.not-read</comment>
        <translation>lässt sich nicht lesen (%1). Auf eine lokale Platte kopieren.</translation>
    </message>
    <message>
        <source>it cannot be written (%1). Choose another folder or make room.</source>
        <comment>file.not-written</comment>
        <translation>lässt sich nicht schreiben (%1). Anderen Ordner wählen oder Platz schaffen.</translation>
    </message>
    <message>
        <source>this is a folder. Choose a file in it.</source>
        <comment>file.is-folder</comment>
        <translation>das ist ein Ordner. Eine Datei darin wählen.</translation>
    </message>
    <message>
        <source>this is not a regular file. Choose a file on disk.</source>
        <comment>file.not-regular</comment>
        <translation>das ist keine gewöhnliche Datei. Eine Datei auf der Platte wählen.</translation>
    </message>
    <message>
        <source>the file is empty. Export or copy it again.</source>
        <comment>file.empty</comment>
        <translation>die Datei ist leer. Neu exportieren oder kopieren.</translation>
    </message>
    <message>
        <source>this is a Git LFS pointer, not the file itself. Run `git lfs pull` where it came from.</source>
        <comment>file.lfs-pointer</comment>
        <translation>das ist ein Git-LFS-Verweis, nicht die Datei selbst. Am Ursprungsort `git lfs pull` ausführen.</translation>
    </message>
    <message>
        <source>this is not a place for a file. Give a file name in an existing folder.</source>
        <comment>file.no-place</comment>
        <translation>hier kann keine Datei liegen. Einen Namen in einem vorhandenen Ordner angeben.</translation>
    </message>
    <message>
        <source>the unit must be a positive length in mm.</source>
        <comment>file.wrong-unit</comment>
        <translation>die Einheit muss eine positive Länge in mm sein.</translation>
    </message>
    <message>
        <source>it declares more data than memory holds. The file is damaged; export it again.</source>
        <comment>file.larger-than-memory</comment>
        <translation>nennt mehr Daten, als in den Speicher passen. Die Datei ist beschädigt; neu exportieren.</translation>
    </message>
    <message>
        <source>it is decoded by the program %1, which is not there or does not start. Install AngioPose again.</source>
        <comment>file.decoder-missing</comment>
        <translation>wird von dem Programm %1 dekodiert, das fehlt oder nicht startet. AngioPose neu installieren.</translation>
    </message>
    <message>
        <source>its content makes the decoder fail. The file is damaged; export it again, or in another format.</source>
        <comment>file.decoder-died</comment>
        <translation>ihr Inhalt lässt den Dekodierer scheitern. Die Datei ist beschädigt; neu oder in einem anderen Format exportieren.</translation>
    </message>
    <message>
        <source>decoding it takes far longer than a file of its size may. The file is damaged; export it again.</source>
        <comment>file.decoder-too-long</comment>
        <translation>das Dekodieren dauert viel länger, als eine Datei dieser Größe brauchen darf. Die Datei ist beschädigt; neu exportieren.</translation>
    </message>
    <message>
        <source>decoding it takes far more memory than a file of its size may. The file is damaged; export it again.</source>
        <comment>file.decoder-too-large</comment>
        <translation>das Dekodieren braucht viel mehr Speicher, als eine Datei dieser Größe brauchen darf. Die Datei ist beschädigt; neu exportieren.</translation>
    </message>
    <message>
        <source>SHA-256 cannot be computed. Check the OpenSSL installation.</source>
        <comment>file.hash-impossible</comment>
        <translation>SHA-256 lässt sich nicht berechnen. Die OpenSSL-Installation prüfen.</translation>
    </message>
    <message>
        <source>the folder cannot be read (%1). Check the path.</source>
        <comment>folder.not-read</comment>
        <translation>der Ordner lässt sich nicht lesen (%1). Pfad prüfen.</translation>
    </message>
    <message>
        <source>the folder cannot be read to its end. Copy it to a local disk.</source>
        <comment>folder.not-read-to-end</comment>
        <translation>der Ordner lässt sich nicht zu Ende lesen. Auf eine lokale Platte kopieren.</translation>
    </message>
    <message>
        <source>it holds more than 50000 files. Choose the folder of one study.</source>
        <comment>folder.too-full</comment>
        <translation>enthält über 50000 Dateien. Den Ordner einer einzelnen Untersuchung wählen.</translation>
    </message>
    <message>
        <source>its JSON is nested more than %1 levels deep. This is no file of this program.</source>
        <comment>json.too-deep</comment>
        <translation>das JSON ist mehr als %1 Ebenen tief. Das ist keine Datei dieses Programms.</translation>
    </message>
    <message>
        <source>it is not valid JSON at line %1. Correct it there.</source>
        <comment>json.invalid</comment>
        <translation>ist in Zeile %1 kein gültiges JSON. Dort berichtigen.</translation>
    </message>
    <message>
        <source>a number in it is too large for a double. Correct it.</source>
        <comment>json.number-too-large</comment>
        <translation>eine Zahl darin ist zu groß für double. Berichtigen.</translation>
    </message>
    <message>
        <source>this is not a text table. Choose a CSV file with a header row.</source>
        <comment>table.no-text</comment>
        <translation>das ist keine Texttabelle. Eine CSV-Datei mit Kopfzeile wählen.</translation>
    </message>
    <message>
        <source>line %1 has %2 columns, the first line has %3. Separate columns by commas and use . as decimal point.</source>
        <comment>table.columns</comment>
        <translation>Zeile %1 hat %2 Spalten, die erste hat %3. Spalten durch Kommas trennen, Dezimalpunkt verwenden.</translation>
    </message>
    <message>
        <source>line %1, column %2: &quot;%3&quot; is not a finite number. Correct or remove the line.</source>
        <comment>table.no-number</comment>
        <translation>Zeile %1, Spalte %2: &quot;%3&quot; ist keine endliche Zahl. Berichtigen oder entfernen.</translation>
    </message>
    <message>
        <source>line %1: the branch must be a whole number. Correct the line.</source>
        <comment>table.branch-no-number</comment>
        <translation>Zeile %1: branch muss eine ganze Zahl sein. Berichtigen.</translation>
    </message>
    <message>
        <source>it does not hold one ITK transform. Export a single rigid transform.</source>
        <comment>pose.no-transform</comment>
        <translation>enthält nicht genau eine ITK-Transformation. Eine einzelne starre Transformation exportieren.</translation>
    </message>
    <message>
        <source>its transform &quot;%1&quot; is not rigid, or lacks parameters. Export a rigid transform (affine, Euler3D or VersorRigid3D).</source>
        <comment>pose.not-rigid-transform</comment>
        <translation>die Transformation &quot;%1&quot; ist nicht starr oder hat zu wenig Parameter. Eine starre exportieren (affine, Euler3D oder VersorRigid3D).</translation>
    </message>
    <message>
        <source>its centre is not finite. Export the transform again.</source>
        <comment>pose.centre-not-finite</comment>
        <translation>der Mittelpunkt ist nicht endlich. Die Transformation neu exportieren.</translation>
    </message>
    <message>
        <source>it has no matrix `cameraFromPatient` of four rows of four numbers, at the top or in `pose`. Give one.</source>
        <comment>pose.no-matrix</comment>
        <translation>hat keine Matrix `cameraFromPatient` mit vier Zeilen zu vier Zahlen, weder oben noch in `pose`. Eine angeben.</translation>
    </message>
    <message>
        <source>cameraFromPatient must have four rows of four numbers.</source>
        <comment>pose.rows</comment>
        <translation>cameraFromPatient muss vier Zeilen zu vier Zahlen haben.</translation>
    </message>
    <message>
        <source>cameraFromPatient has an entry that is not a finite number.</source>
        <comment>pose.not-finite</comment>
        <translation>cameraFromPatient enthält einen Eintrag, der keine endliche Zahl ist.</translation>
    </message>
    <message>
        <source>the last row of cameraFromPatient must be 0 0 0 1. Is the matrix transposed?</source>
        <comment>pose.last-row</comment>
        <translation>die letzte Zeile von cameraFromPatient muss 0 0 0 1 sein. Ist die Matrix transponiert?</translation>
    </message>
    <message>
        <source>cameraFromPatient is a reflection (determinant below 0). A mirrored image belongs into the sign of fx, never into the rotation.</source>
        <comment>pose.reflection</comment>
        <translation>cameraFromPatient ist eine Spiegelung (Determinante unter 0). Ein gespiegeltes Bild gehört ins Vorzeichen von fx, nie in die Drehung.</translation>
    </message>
    <message>
        <source>the upper left 3 x 3 of cameraFromPatient is not a rotation (scale or shear). Give a rigid pose in mm.</source>
        <comment>pose.no-rotation</comment>
        <translation>die linken oberen 3 x 3 von cameraFromPatient sind keine Drehung (Skalierung oder Scherung). Eine starre Lage in mm angeben.</translation>
    </message>
    <message>
        <source>it is too large for a pose. Choose a .json, .tfm, .mat or .h5 file.</source>
        <comment>pose.too-large</comment>
        <translation>ist zu groß für eine Lage. Eine .json-, .tfm-, .mat- oder .h5-Datei wählen.</translation>
    </message>
    <message>
        <source>this is no pose. Choose a .json, or an ITK .tfm, .mat or .h5 file.</source>
        <comment>pose.unknown</comment>
        <translation>das ist keine Lage. Eine .json-Datei oder eine von ITK (.tfm, .mat, .h5) wählen.</translation>
    </message>
    <message>
        <source>the pose is not a rigid motion of finite numbers. Reset it before saving.</source>
        <comment>pose.not-saved</comment>
        <translation>die Lage ist keine starre Bewegung endlicher Zahlen. Vor dem Speichern zurücksetzen.</translation>
    </message>
    <message>
        <source>poses are written as .json, .tfm or .h5. Change the extension.</source>
        <comment>pose.extension</comment>
        <translation>Lagen werden als .json, .tfm oder .h5 geschrieben. Die Endung ändern.</translation>
    </message>
    <message>
        <source>this is not a log of observer trials. Choose another name.</source>
        <comment>observer-log.not-one</comment>
        <translation>das ist kein Protokoll von Beobachterversuchen. Anderen Namen wählen.</translation>
    </message>
    <message>
        <source>a gzip archive</source>
        <comment>content.gzip</comment>
        <translation>ein gzip-Archiv</translation>
    </message>
    <message>
        <source>a zip archive</source>
        <comment>content.zip</comment>
        <translation>ein zip-Archiv</translation>
    </message>
    <message>
        <source>an NRRD volume</source>
        <comment>content.nrrd</comment>
        <translation>ein NRRD-Volumen</translation>
    </message>
    <message>
        <source>a NIfTI volume</source>
        <comment>content.nifti</comment>
        <translation>ein NIfTI-Volumen</translation>
    </message>
    <message>
        <source>a NIfTI header</source>
        <comment>content.nifti-header</comment>
        <translation>ein NIfTI-Header</translation>
    </message>
    <message>
        <source>an HDF5 file</source>
        <comment>content.hdf5</comment>
        <translation>eine HDF5-Datei</translation>
    </message>
    <message>
        <source>a NetCDF (MINC) volume</source>
        <comment>content.netcdf</comment>
        <translation>ein NetCDF-Volumen (MINC)</translation>
    </message>
    <message>
        <source>an MRtrix tractogram</source>
        <comment>content.mrtrix</comment>
        <translation>ein MRtrix-Traktogramm</translation>
    </message>
    <message>
        <source>a TrackVis tractogram</source>
        <comment>content.trackvis</comment>
        <translation>ein TrackVis-Traktogramm</translation>
    </message>
    <message>
        <source>an STL surface</source>
        <comment>content.stl</comment>
        <translation>eine STL-Oberfläche</translation>
    </message>
    <message>
        <source>a PLY surface</source>
        <comment>content.ply</comment>
        <translation>eine PLY-Oberfläche</translation>
    </message>
    <message>
        <source>a glTF scene</source>
        <comment>content.gltf</comment>
        <translation>eine glTF-Szene</translation>
    </message>
    <message>
        <source>a legacy VTK file</source>
        <comment>content.legacy-vtk</comment>
        <translation>eine alte VTK-Datei</translation>
    </message>
    <message>
        <source>a VTK XML file</source>
        <comment>content.vtk-xml</comment>
        <translation>eine VTK-XML-Datei</translation>
    </message>
    <message>
        <source>an XML file</source>
        <comment>content.xml</comment>
        <translation>eine XML-Datei</translation>
    </message>
    <message>
        <source>a MetaImage header</source>
        <comment>content.metaimage</comment>
        <translation>ein MetaImage-Header</translation>
    </message>
    <message>
        <source>a DICOM file</source>
        <comment>content.dicom</comment>
        <translation>eine DICOM-Datei</translation>
    </message>
    <message>
        <source>a JPEG image</source>
        <comment>content.jpeg</comment>
        <translation>ein JPEG-Bild</translation>
    </message>
    <message>
        <source>a PNG image</source>
        <comment>content.png</comment>
        <translation>ein PNG-Bild</translation>
    </message>
    <message>
        <source>a TIFF image</source>
        <comment>content.tiff</comment>
        <translation>ein TIFF-Bild</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <comment>content.pdf</comment>
        <translation>ein PDF-Dokument</translation>
    </message>
    <message>
        <source>a JSON file</source>
        <comment>content.json</comment>
        <translation>eine JSON-Datei</translation>
    </message>
    <message>
        <source>Colour image converted to grey.</source>
        <comment>image.colour-to-grey</comment>
        <translation>Farbbild in Graustufen umgewandelt.</translation>
    </message>
    <message>
        <source>The transparency of the image is ignored.</source>
        <comment>image.transparency-ignored</comment>
        <translation>Die Transparenz des Bildes bleibt unbeachtet.</translation>
    </message>
    <message>
        <source>A plain image has no C-arm geometry: enter it in the geometry of the case.</source>
        <comment>image.no-geometry</comment>
        <translation>Ein einfaches Bild hat keine C-Bogen-Geometrie: in der Geometrie des Falls eintragen.</translation>
    </message>
    <message>
        <source>The picture is a mask of two levels: its vessels are taken as they are drawn.</source>
        <comment>image.is-mask</comment>
        <translation>Das Bild ist eine Maske aus zwei Stufen: Die Gefäße werden übernommen, wie sie gezeichnet sind.</translation>
    </message>
    <message>
        <source>this is no image that this program reads. Choose a DICOM XA run, a PNG, TIFF or JPEG image.</source>
        <comment>image.unknown</comment>
        <translation>das ist kein Bild, das dieses Programm liest. Eine DICOM-XA-Serie, ein PNG-, TIFF- oder JPEG-Bild wählen.</translation>
    </message>
    <message>
        <source>this is %1, not an angiogram. Choose a DICOM XA run, a PNG, TIFF or JPEG image.</source>
        <comment>image.is-other</comment>
        <translation>das ist %1, kein Angiogramm. Eine DICOM-XA-Serie, ein PNG-, TIFF- oder JPEG-Bild wählen.</translation>
    </message>
    <message>
        <source>this is a gzip archive without a readable DICOM file in it. Unpack it and choose the angiogram itself.</source>
        <comment>image.gzip-without-dicom</comment>
        <translation>das ist ein gzip-Archiv ohne lesbare DICOM-Datei. Auspacken und das Angiogramm selbst wählen.</translation>
    </message>
    <message>
        <source>the image is damaged or cut short. Copy or export it again.</source>
        <comment>image.damaged</comment>
        <translation>das Bild ist beschädigt oder unvollständig. Neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>the image is damaged or of an unusual kind. Export it in grey or RGB with 8 or 16 bits, without tiles.</source>
        <comment>image.unusual</comment>
        <translation>das Bild ist beschädigt oder ungewöhnlich. In Grau oder RGB mit 8 oder 16 Bit ohne Kacheln exportieren.</translation>
    </message>
    <message>
        <source>the image has fewer than 8 pixels on a side, or more than this program holds. Export the angiogram at its own size.</source>
        <comment>image.size</comment>
        <translation>das Bild hat weniger als 8 Pixel je Seite, oder mehr als dieses Programm fasst. Das Angiogramm in eigener Größe exportieren.</translation>
    </message>
    <message>
        <source>the frames differ in size. All frames of a run must be equally large.</source>
        <comment>image.frames-differ</comment>
        <translation>die Bilder sind verschieden groß. Alle Bilder einer Serie müssen gleich groß sein.</translation>
    </message>
    <message>
        <source>there is no picture to write. Render or trace one first.</source>
        <comment>image.no-picture</comment>
        <translation>kein Bild zu schreiben. Zuerst eines erzeugen.</translation>
    </message>
    <message>
        <source>a pixel is not a finite number. Correct the image before writing it.</source>
        <comment>image.pixel-not-finite-writing</comment>
        <translation>ein Pixel ist keine endliche Zahl. Das Bild vor dem Schreiben berichtigen.</translation>
    </message>
    <message>
        <source>a pixel is not a finite number. Export the image again.</source>
        <comment>image.pixel-not-finite</comment>
        <translation>ein Pixel ist keine endliche Zahl. Das Bild neu exportieren.</translation>
    </message>
    <message>
        <source>this is %1, not a 2-D centreline. Choose a CSV table or a PNG mask.</source>
        <comment>centreline.is-other</comment>
        <translation>das ist %1, keine 2-D-Mittellinie. Eine CSV-Tabelle oder PNG-Maske wählen.</translation>
    </message>
    <message>
        <source>this is not a mask of two levels. Draw the vessels white on black.</source>
        <comment>centreline.no-mask</comment>
        <translation>das ist keine Maske mit zwei Stufen. Die Gefäße weiß auf schwarz zeichnen.</translation>
    </message>
    <message>
        <source>the header row has no columns x and y. The first line must name the columns: x,y and, where known, branch,radius (px).</source>
        <comment>centreline.no-columns</comment>
        <translation>der Kopfzeile fehlen die Spalten x und y. Die erste Zeile muss die Spalten nennen: x,y und, wo bekannt, branch,radius (px).</translation>
    </message>
    <message>
        <source>it has a column z: this is a 3-D centreline. Choose the centreline traced in the image.</source>
        <comment>centreline.is-3d</comment>
        <translation>hat eine Spalte z: das ist eine 3-D-Mittellinie. Die im Bild erkannte Mittellinie wählen.</translation>
    </message>
    <message>
        <source>it has more than a million points. Resample the centreline.</source>
        <comment>centreline.too-long</comment>
        <translation>hat über eine Million Punkte. Die Mittellinie ausdünnen.</translation>
    </message>
    <message>
        <source>line %1 lies far outside any image. Coordinates are in pixels.</source>
        <comment>centreline.outside</comment>
        <translation>Zeile %1 liegt weit außerhalb jedes Bildes. Koordinaten sind in Pixeln.</translation>
    </message>
    <message>
        <source>this is not a DICOM file. Choose a scan.</source>
        <comment>dicom.not-one</comment>
        <translation>das ist keine DICOM-Datei. Einen Scan wählen.</translation>
    </message>
    <message>
        <source>its deflated content is damaged or cut short. Copy or export it again.</source>
        <comment>dicom.deflate-damaged</comment>
        <translation>der gepackte Inhalt ist beschädigt oder unvollständig. Neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>no DICOM element in it can be read. The file is damaged; copy or export it again.</source>
        <comment>dicom.no-element</comment>
        <translation>kein DICOM-Element darin ist lesbar. Die Datei ist beschädigt; neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>the element %1 declares %2 bytes, but %3 are left</source>
        <comment>dicom.element-too-long</comment>
        <translation>das Element %1 nennt %2 Bytes, es bleiben aber %3</translation>
    </message>
    <message>
        <source>the sequence %1 has no end</source>
        <comment>dicom.sequence-without-end</comment>
        <translation>die Sequenz %1 hat kein Ende</translation>
    </message>
    <message>
        <source>it ends in the middle of an element</source>
        <comment>dicom.ends-within</comment>
        <translation>endet mitten in einem Element</translation>
    </message>
    <message>
        <source>The end of the file is damaged (%1); the image is complete.</source>
        <comment>dicom.end-damaged</comment>
        <translation>Das Dateiende ist beschädigt (%1); das Bild ist vollständig.</translation>
    </message>
    <message>
        <source>%1 is damaged before its pixels: %2. Copy or export it again.</source>
        <comment>dicom.damaged-before-pixels</comment>
        <translation>%1 ist vor den Pixeln beschädigt: %2. Neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>%1 holds no image. Choose the X-ray angiography run.</source>
        <comment>dicom.holds-no-image</comment>
        <translation>%1 enthält kein Bild. Die Röntgenangiographie-Serie wählen.</translation>
    </message>
    <message>
        <source>this DICOM file</source>
        <comment>dicom.this-file</comment>
        <translation>diese DICOM-Datei</translation>
    </message>
    <message>
        <source>this DICOM file (%1)</source>
        <comment>dicom.this-file-of</comment>
        <translation>diese DICOM-Datei (%1)</translation>
    </message>
    <message>
        <source>its bits per pixel contradict each other. The header is damaged; export the run again.</source>
        <comment>dicom.bits-contradict</comment>
        <translation>die Angaben der Bits je Pixel widersprechen sich. Der Header ist beschädigt; Serie neu exportieren.</translation>
    </message>
    <message>
        <source>it is stored in palette colours. Export the angiogram in grey.</source>
        <comment>dicom.palette-colours</comment>
        <translation>ist in Palettenfarben gespeichert. Das Angiogramm in Graustufen exportieren.</translation>
    </message>
    <message>
        <source>its pixels (%1, %2 samples) are not grey or colour. Export the angiogram in grey.</source>
        <comment>dicom.not-grey</comment>
        <translation>die Pixel (%1, %2 Werte) sind weder grau noch farbig. Das Angiogramm in Graustufen exportieren.</translation>
    </message>
    <message>
        <source>its pixels have %1 bits. Export the angiogram with 8 or 16 bits.</source>
        <comment>dicom.pixel-bits</comment>
        <translation>die Pixel haben %1 Bit. Das Angiogramm mit 8 oder 16 Bit exportieren.</translation>
    </message>
    <message>
        <source>its header gives no image size. The file is damaged; export the run again.</source>
        <comment>dicom.no-image-size</comment>
        <translation>der Header nennt keine Bildgröße. Die Datei ist beschädigt; Serie neu exportieren.</translation>
    </message>
    <message>
        <source>it declares %1 frames of %2 x %3 pixels, more than this program holds. Export fewer frames.</source>
        <comment>dicom.too-many-frames</comment>
        <translation>nennt %1 Bilder mit %2 x %3 Pixeln, mehr als dieses Programm fasst. Weniger Bilder exportieren.</translation>
    </message>
    <message>
        <source>its pixels are cut short: %1 of %2 bytes are there. Copy or export it again.</source>
        <comment>dicom.pixels-cut-short</comment>
        <translation>die Pixel sind unvollständig: %1 von %2 Bytes vorhanden. Neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>its compressed pixels are cut short. Copy or export it again.</source>
        <comment>dicom.packed-pixels-cut-short</comment>
        <translation>die komprimierten Pixel sind unvollständig. Neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>only %1 of its %2 frames are there. Copy or export it again.</source>
        <comment>dicom.frames-missing</comment>
        <translation>nur %1 von %2 Bildern vorhanden. Neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>frame %1 cannot be decoded (transfer syntax %2): damaged, cut short, or a compression this program does not read. Export the run again, uncompressed if possible.</source>
        <comment>dicom.frame-undecodable</comment>
        <translation>Bild %1 lässt sich nicht dekodieren (Transfersyntax %2): beschädigt, unvollständig oder unbekannte Kompression. Serie neu exportieren, möglichst unkomprimiert.</translation>
    </message>
    <message>
        <source>Frames %1 of %2 cannot be decoded: they are shown empty, the others can be read. Export the run again where they matter.</source>
        <comment>dicom.frames-lost</comment>
        <translation>Die Bilder %1 von %2 lassen sich nicht dekodieren: Sie werden leer gezeigt, die anderen sind lesbar. Serie neu exportieren, wo sie gebraucht werden.</translation>
    </message>
    <message>
        <source>Frames %1 of %2 are damaged in part: what could be decoded is shown. Compare them with another viewer before you use one.</source>
        <comment>dicom.frames-flawed</comment>
        <translation>Die Bilder %1 von %2 sind teilweise beschädigt: Gezeigt wird, was sich dekodieren ließ. Vor dem Gebrauch mit einem anderen Betrachter vergleichen.</translation>
    </message>
    <message>
        <source>The image is damaged in part: what could be decoded is shown. Compare it with another viewer before you use it.</source>
        <comment>image.flawed</comment>
        <translation>Das Bild ist teilweise beschädigt: Gezeigt wird, was sich dekodieren ließ. Vor dem Gebrauch mit einem anderen Betrachter vergleichen.</translation>
    </message>
    <message>
        <source>it is only %1 x %2 pixels. Choose the angiogram at its full size.</source>
        <comment>dicom.thumbnail</comment>
        <translation>hat nur %1 x %2 Pixel. Das Angiogramm in voller Größe wählen.</translation>
    </message>
    <message>
        <source>This is %1, not X-ray angiography: it has no C-arm geometry.</source>
        <comment>dicom.not-xray</comment>
        <translation>Das ist %1, keine Röntgenangiographie: ohne C-Bogen-Geometrie.</translation>
    </message>
    <message>
        <source>the DICOM file could not be written. Choose another format.</source>
        <comment>dicom.not-written</comment>
        <translation>Die DICOM-Datei ließ sich nicht schreiben. Anderes Format wählen.</translation>
    </message>
    <message>
        <source>there are no frames to write. Load or simulate an angiogram first.</source>
        <comment>dicom.no-frames-to-write</comment>
        <translation>keine Bilder zu schreiben. Zuerst ein Angiogramm laden oder simulieren.</translation>
    </message>
    <message>
        <source>the run is too large for an uncompressed DICOM file. Write fewer frames.</source>
        <comment>dicom.run-too-large</comment>
        <translation>die Serie ist zu groß für eine unkomprimierte DICOM-Datei. Weniger Bilder schreiben.</translation>
    </message>
    <message>
        <source>there is not enough memory to write this run. Write fewer frames.</source>
        <comment>dicom.no-memory-to-write</comment>
        <translation>der Speicher reicht nicht, um diese Serie zu schreiben. Weniger Bilder schreiben.</translation>
    </message>
    <message>
        <source>modality %1</source>
        <comment>dicom.modality</comment>
        <translation>Modalität %1</translation>
    </message>
    <message>
        <source>an image without modality</source>
        <comment>dicom.no-modality</comment>
        <translation>ein Bild ohne Modalität</translation>
    </message>
    <message>
        <source>The header gives no imager pixel spacing: %1 is derived from the calibrated pixel spacing. Check it in the geometry.</source>
        <comment>dicom.spacing-from-calibration</comment>
        <translation>Der Header nennt keine Imager Pixel Spacing: %1 aus der kalibrierten Pixelgröße abgeleitet. In der Geometrie prüfen.</translation>
    </message>
    <message>
        <source>The header gives no imager pixel spacing (0018,1164): %1 is derived from the field of view. Check it in the geometry.</source>
        <comment>dicom.spacing-from-field</comment>
        <translation>Der Header nennt keine Imager Pixel Spacing (0018,1164): %1 aus dem Bildfeld abgeleitet. In der Geometrie prüfen.</translation>
    </message>
    <message>
        <source>The header gives no imager pixel spacing (0018,1164): enter it in the geometry.</source>
        <comment>dicom.spacing-missing</comment>
        <translation>Der Header nennt keine Imager Pixel Spacing (0018,1164): in der Geometrie eintragen.</translation>
    </message>
    <message>
        <source>The header gives no imager pixel spacing (0018,1164): enter it in the geometry. The intensifier of %1 suggests at most %2.</source>
        <comment>dicom.spacing-missing-intensifier</comment>
        <translation>Der Header nennt keine Imager Pixel Spacing (0018,1164): in der Geometrie eintragen. Der Bildverstärker mit %1 legt höchstens %2 nahe.</translation>
    </message>
    <message>
        <source>The header gives only isocentre angles (0018,9463), whose signs are not certain: enter LAO/RAO and CRA/CAU in the geometry.</source>
        <comment>dicom.angles-of-isocentre</comment>
        <translation>Der Header nennt nur Isozentrumswinkel (0018,9463), deren Vorzeichen unsicher sind: LAO/RAO und CRA/CAU in der Geometrie eintragen.</translation>
    </message>
    <message>
        <source>The detector is tilted by %1 (0018,1530): the principal point is uncertain.</source>
        <comment>dicom.detector-tilted</comment>
        <translation>Der Detektor ist um %1 gekippt (0018,1530): der Hauptpunkt ist unsicher.</translation>
    </message>
    <message>
        <source>The image is taken as mirrored, after %1. Check that left and right are where they belong.</source>
        <comment>dicom.image-mirrored</comment>
        <translation>Das Bild gilt als gespiegelt, nach %1. Prüfen, ob links und rechts stimmen.</translation>
    </message>
    <message>
        <source>The C-arm moved during this run, but the header gives %1 for its %2 frames: the angles are those of the first frame. Check them for the frame you use.</source>
        <comment>dicom.gantry-moved</comment>
        <translation>Der C-Bogen hat sich bewegt, der Header nennt aber %1 für %2 Bilder: die Winkel sind die des ersten Bildes. Für das benutzte Bild prüfen.</translation>
    </message>
    <message>
        <source>no angles</source>
        <comment>dicom.gantry-no-angles</comment>
        <translation>keine Winkel</translation>
    </message>
    <message>
        <source>%1</source>
        <comment>dicom.gantry-angles</comment>
        <translation>%1</translation>
    </message>
    <message>
        <source>What was traced is hardly longer than wide: check that it is a vessel.</source>
        <comment>vessels.compact</comment>
        <translation>Das Erfasste ist kaum länger als breit: prüfen, ob es ein Gefäß ist.</translation>
    </message>
    <message>
        <source>The vessels are %1 across, or of a width that is unusual: if the unit of the file is not the millimetre, give the unit.</source>
        <comment>vessels.unusual-size</comment>
        <translation>Die Gefäße messen %1 im Ganzen oder sind ungewöhnlich breit oder schmal: ist die Einheit der Datei nicht der Millimeter, die Einheit angeben.</translation>
    </message>
    <message>
        <source>this is no surface that this program reads. Choose a .vtp, .vtk, .stl, .ply or .obj file.</source>
        <comment>surface.unknown</comment>
        <translation>das ist keine Oberfläche, die dieses Programm liest. Eine .vtp-, .vtk-, .stl-, .ply- oder .obj-Datei wählen.</translation>
    </message>
    <message>
        <source>this is %1, not a surface. Choose a .vtp, .vtk, .stl, .ply or .obj file.</source>
        <comment>surface.is-other</comment>
        <translation>das ist %1, keine Oberfläche. Eine .vtp-, .vtk-, .stl-, .ply- oder .obj-Datei wählen.</translation>
    </message>
    <message>
        <source>it holds no triangles. Choose the surface of a vessel.</source>
        <comment>surface.no-triangles</comment>
        <translation>enthält keine Dreiecke. Die Oberfläche eines Gefäßes wählen.</translation>
    </message>
    <message>
        <source>none of its triangles has an area. Choose the surface of a vessel.</source>
        <comment>surface.no-area</comment>
        <translation>keines der Dreiecke hat eine Fläche. Die Oberfläche eines Gefäßes wählen.</translation>
    </message>
    <message>
        <source>it has more triangles than this program holds. Decimate the surface.</source>
        <comment>surface.too-large</comment>
        <translation>hat mehr Dreiecke, als dieses Programm fasst. Die Oberfläche vereinfachen.</translation>
    </message>
    <message>
        <source>a coordinate is not a number, or beyond a kilometre. Correct or export it again.</source>
        <comment>surface.coordinate</comment>
        <translation>eine Koordinate ist keine Zahl oder über einen Kilometer groß. Berichtigen oder neu exportieren.</translation>
    </message>
    <message>
        <source>a triangle refers to a point that does not exist. The file is damaged; export it again.</source>
        <comment>surface.bad-index</comment>
        <translation>ein Dreieck verweist auf einen Punkt, den es nicht gibt. Die Datei ist beschädigt; neu exportieren.</translation>
    </message>
    <message>
        <source>its triangles are damaged or cut short. Copy or export it again.</source>
        <comment>surface.cut-short</comment>
        <translation>die Dreiecke sind beschädigt oder unvollständig. Neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>surfaces are written as .stl. Change the extension.</source>
        <comment>surface.extension</comment>
        <translation>Oberflächen werden als .stl geschrieben. Die Endung ändern.</translation>
    </message>
    <message>
        <source>The surface is not closed (%1 open and %2 crowded edges): its inside is decided by majority. Check the result, or close the holes.</source>
        <comment>surface.open</comment>
        <translation>Die Oberfläche ist nicht geschlossen (%1 offene und %2 mehrfache Kanten): ihr Inneres entscheidet die Mehrheit. Ergebnis prüfen oder Löcher schließen.</translation>
    </message>
    <message>
        <source>The triangles do not agree on inside and outside; overlapping parts may cancel out.</source>
        <comment>surface.disoriented</comment>
        <translation>Die Dreiecke sind sich über innen und außen uneins; überlappende Teile können sich aufheben.</translation>
    </message>
    <message>
        <source>The surface is %1 across, which is unusual: if its unit is not the millimetre, give the unit.</source>
        <comment>surface.unusual-size</comment>
        <translation>Die Oberfläche misst %1, das ist ungewöhnlich: wenn ihre Einheit nicht Millimeter ist, die Einheit angeben.</translation>
    </message>
    <message>
        <source>Points astray were left out with their triangles, since they cannot be of one body with the others: %1 (no numbers, or farther than %2 from the middle). Check the surface.</source>
        <comment>surface.stray-points</comment>
        <translation>Verirrte Punkte wurden mit ihren Dreiecken ausgelassen, da sie nicht zum selben Körper gehören können: %1 (keine Zahlen oder mehr als %2 von der Mitte). Die Oberfläche prüfen.</translation>
    </message>
    <message>
        <source>the surface is %1 across, larger than any body. Give the unit of the file, or remove points that lie astray.</source>
        <comment>surface.larger-than-body</comment>
        <translation>die Oberfläche misst %1, mehr als jeder Körper. Die Einheit der Datei angeben oder abseits liegende Punkte entfernen.</translation>
    </message>
    <message>
        <source>line %1 does not give a point. The file is damaged; export it again.</source>
        <comment>surface.obj-bad-point</comment>
        <translation>Zeile %1 ergibt keinen Punkt. Die Datei ist beschädigt; neu exportieren.</translation>
    </message>
    <message>
        <source>its PLY header is damaged or cut short. Export it again.</source>
        <comment>surface.ply-header-damaged</comment>
        <translation>der PLY-Header ist beschädigt oder unvollständig. Neu exportieren.</translation>
    </message>
    <message>
        <source>its PLY header is damaged: the element &quot;%1&quot; has no properties. Export it again.</source>
        <comment>surface.ply-element-empty</comment>
        <translation>der PLY-Header ist beschädigt: das Element &quot;%1&quot; hat keine Eigenschaften. Neu exportieren.</translation>
    </message>
    <message>
        <source>its PLY data are damaged or cut short, or a face has more than 255 corners. Export it again, as triangles.</source>
        <comment>surface.ply-data-damaged</comment>
        <translation>ihre PLY-Daten sind beschädigt oder abgeschnitten, oder eine Fläche hat mehr als 255 Ecken. Neu exportieren, als Dreiecke.</translation>
    </message>
    <message>
        <source>this is %1, not a centreline. Choose a centreline file: .vtp, .vtk, .vtu, .csv, .swc or .mrk.json.</source>
        <comment>tree.is-other</comment>
        <translation>das ist %1, keine Mittellinie. Eine Mittelliniendatei wählen: .vtp, .vtk, .vtu, .csv, .swc oder .mrk.json.</translation>
    </message>
    <message>
        <source>this is no centreline format AngioPose reads. Choose a centreline file: .vtp, .vtk, .vtu, .csv, .swc or .mrk.json.</source>
        <comment>tree.format-unknown</comment>
        <translation>dieses Mittellinienformat liest AngioPose nicht. Eine Mittelliniendatei wählen: .vtp, .vtk, .vtu, .csv, .swc oder .mrk.json.</translation>
    </message>
    <message>
        <source>it does not begin like a VTK file. Export the centrelines again.</source>
        <comment>tree.no-vtk-beginning</comment>
        <translation>beginnt nicht wie eine VTK-Datei. Die Mittellinien neu exportieren.</translation>
    </message>
    <message>
        <source>vessel trees are written as .vtp, .csv, .swc or .mrk.json. Change the extension.</source>
        <comment>tree.extension</comment>
        <translation>Gefäßbäume werden als .vtp, .csv, .swc oder .mrk.json geschrieben. Die Endung ändern.</translation>
    </message>
    <message>
        <source>it has %1 points; a centreline tree has at most %2. Resample the centrelines.</source>
        <comment>tree.too-many-points</comment>
        <translation>hat %1 Punkte; ein Gefäßbaum hat höchstens %2. Die Mittellinien ausdünnen.</translation>
    </message>
    <message>
        <source>it has %1 separate lines; a centreline tree has at most %2. Keep the vessels of interest.</source>
        <comment>tree.too-many-lines</comment>
        <translation>hat %1 getrennte Linien; ein Gefäßbaum hat höchstens %2. Nur die wichtigen Gefäße behalten.</translation>
    </message>
    <message>
        <source>it holds no lines. Choose a file with vessel centrelines.</source>
        <comment>tree.no-lines</comment>
        <translation>enthält keine Linien. Eine Datei mit Gefäß-Mittellinien wählen.</translation>
    </message>
    <message>
        <source>it holds a surface, not centrelines. Extract the centrelines first (e.g. with VMTK or Slicer) and open those.</source>
        <comment>tree.is-surface</comment>
        <translation>enthält eine Oberfläche, keine Mittellinien. Diese zuerst berechnen (etwa mit VMTK oder Slicer) und öffnen.</translation>
    </message>
    <message>
        <source>a line refers to a point that does not exist. The file is damaged; export it again.</source>
        <comment>tree.bad-index</comment>
        <translation>eine Linie verweist auf einen Punkt, den es nicht gibt. Die Datei ist beschädigt; neu exportieren.</translation>
    </message>
    <message>
        <source>its lines visit the same points too often. The file is damaged; export it again.</source>
        <comment>tree.points-repeated</comment>
        <translation>die Linien besuchen dieselben Punkte zu oft. Die Datei ist beschädigt; neu exportieren.</translation>
    </message>
    <message>
        <source>none of its lines has two different points. Choose a file with vessel centrelines.</source>
        <comment>tree.no-length</comment>
        <translation>keine der Linien hat zwei verschiedene Punkte. Eine Datei mit Gefäß-Mittellinien wählen.</translation>
    </message>
    <message>
        <source>the third line of a legacy VTK file must be ASCII or BINARY. Export it again.</source>
        <comment>tree.vtk-third-line</comment>
        <translation>die dritte Zeile einer alten VTK-Datei muss ASCII oder BINARY sein. Neu exportieren.</translation>
    </message>
    <message>
        <source>it holds no data set, not POLYDATA or UNSTRUCTURED_GRID. Export the centrelines as poly-lines.</source>
        <comment>tree.vtk-no-data-set</comment>
        <translation>enthält keinen Datensatz, kein POLYDATA oder UNSTRUCTURED_GRID. Die Mittellinien als Polylinien exportieren.</translation>
    </message>
    <message>
        <source>it holds %1, not POLYDATA or UNSTRUCTURED_GRID. Export the centrelines as poly-lines.</source>
        <comment>tree.vtk-other-data-set</comment>
        <translation>enthält %1, nicht POLYDATA oder UNSTRUCTURED_GRID. Die Mittellinien als Polylinien exportieren.</translation>
    </message>
    <message>
        <source>the section &quot;%1&quot; is damaged or cut short. Export it again.</source>
        <comment>tree.vtk-section-damaged</comment>
        <translation>der Abschnitt &quot;%1&quot; ist beschädigt oder unvollständig. Neu exportieren.</translation>
    </message>
    <message>
        <source>the VTK XML data in it is damaged or cut short. Export it again.</source>
        <comment>tree.vtk-xml-damaged</comment>
        <translation>die VTK-XML-Daten sind beschädigt oder unvollständig. Neu exportieren.</translation>
    </message>
    <message>
        <source>it is not VTK XML PolyData or UnstructuredGrid. Export the centrelines as .vtp.</source>
        <comment>tree.vtk-xml-other</comment>
        <translation>ist weder VTK-XML-PolyData noch UnstructuredGrid. Die Mittellinien als .vtp exportieren.</translation>
    </message>
    <message>
        <source>it declares %1, which cannot be. The file is damaged; export it again.</source>
        <comment>tree.vtk-xml-impossible-count</comment>
        <translation>nennt %1, was nicht sein kann. Die Datei ist beschädigt; neu exportieren.</translation>
    </message>
    <message>
        <source>it is not a Slicer markups file with curves. Export the centrelines as .mrk.json curves, .vtp, .vtk, .csv or .swc.</source>
        <comment>tree.markups-none</comment>
        <translation>ist keine Slicer-Markups-Datei mit Kurven. Die Mittellinien als .mrk.json-Kurven, .vtp, .vtk, .csv oder .swc exportieren.</translation>
    </message>
    <message>
        <source>line %1 is not `id type x y z radius parent`. Correct the line or export it again.</source>
        <comment>tree.swc-line</comment>
        <translation>Zeile %1 ist nicht `id type x y z radius parent`. Berichtigen oder neu exportieren.</translation>
    </message>
    <message>
        <source>line %1 repeats an id. Ids must be unique.</source>
        <comment>tree.swc-id-twice</comment>
        <translation>Zeile %1 wiederholt eine id. Jede id muss einmalig sein.</translation>
    </message>
    <message>
        <source>line %1 names a parent, %2, that is not there. Export the whole tree.</source>
        <comment>tree.swc-parent-missing</comment>
        <translation>Zeile %1 nennt ein Elternteil %2, das fehlt. Den ganzen Baum exportieren.</translation>
    </message>
    <message>
        <source>the first line must name the columns: x,y,z and, where known, radius,branch.</source>
        <comment>tree.table-no-header</comment>
        <translation>die erste Zeile muss die Spalten nennen: x,y,z und, wo bekannt, radius,branch.</translation>
    </message>
    <message>
        <source>the header row has no columns x, y and z. Name them (mm, patient LPS).</source>
        <comment>tree.table-no-columns</comment>
        <translation>der Kopfzeile fehlen die Spalten x, y und z. Sie benennen (mm, Patient LPS).</translation>
    </message>
    <message>
        <source>it looks like a list of graph nodes (column id), which has no order along the vessels. Give a branch column, or export the centrelines themselves.</source>
        <comment>tree.table-is-graph</comment>
        <translation>sieht nach einer Liste von Graphknoten aus (Spalte id) ohne Reihenfolge längs der Gefäße. Eine Spalte branch angeben oder die Mittellinien selbst exportieren.</translation>
    </message>
    <message>
        <source>there is no DICOM image in this folder. Choose the folder of a DICOM scan, or a volume file itself.</source>
        <comment>series.none</comment>
        <translation>in diesem Ordner ist kein DICOM-Bild. Den Ordner eines DICOM-Scans oder die Volumendatei selbst wählen.</translation>
    </message>
    <message>
        <source>this DICOM file holds no image. Choose a scan.</source>
        <comment>series.file-without-image</comment>
        <translation>diese DICOM-Datei enthält kein Bild. Einen Scan wählen.</translation>
    </message>
    <message>
        <source>the series %1 is not in this folder. Choose the folder it is in.</source>
        <comment>series.not-here</comment>
        <translation>die Serie %1 ist nicht in diesem Ordner. Den richtigen Ordner wählen.</translation>
    </message>
    <message>
        <source>the series of the case is not in this folder. Choose the folder it is in.</source>
        <comment>series.of-case-not-here</comment>
        <translation>die Serie des Falls ist nicht in diesem Ordner. Den richtigen Ordner wählen.</translation>
    </message>
    <message>
        <source>no series in this folder makes a volume. Choose another folder.</source>
        <comment>series.none-makes-volume</comment>
        <translation>keine Serie dieses Ordners ergibt ein Volumen. Anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>it holds %1 volumes (%2). Choose one by its series id; `info` lists them.</source>
        <comment>series.several</comment>
        <translation>enthält %1 Volumen (%2). Eines über seine Serien-ID wählen; `info` zeigt sie.</translation>
    </message>
    <message>
        <source>this is an X-ray run, not a volume. Open it as the angiogram.</source>
        <comment>series.is-xray</comment>
        <translation>das ist eine Röntgenserie, kein Volumen. Als Angiogramm öffnen.</translation>
    </message>
    <message>
        <source>it is a DICOM segmentation. Export it as a NIfTI or NRRD label image.</source>
        <comment>series.is-segmentation</comment>
        <translation>ist eine DICOM-Segmentierung. Als NIfTI- oder NRRD-Labelbild exportieren.</translation>
    </message>
    <message>
        <source>it is a single slice, not a volume. Copy all slices of the series, or choose another one.</source>
        <comment>series.single-slice</comment>
        <translation>ist eine einzelne Schicht, kein Volumen. Alle Schichten der Serie kopieren oder eine andere wählen.</translation>
    </message>
    <message>
        <source>its images do not say how large a pixel is, so they make no volume. Choose another series.</source>
        <comment>series.no-pixel-size</comment>
        <translation>die Bilder nennen keine Pixelgröße und ergeben kein Volumen. Andere Serie wählen.</translation>
    </message>
    <message>
        <source>its images do not say where they lie in the patient, so they make no volume. Choose another series.</source>
        <comment>series.no-place</comment>
        <translation>die Bilder nennen keine Lage im Patienten und ergeben kein Volumen. Andere Serie wählen.</translation>
    </message>
    <message>
        <source>its slices lie beside each other rather than above. Choose another series.</source>
        <comment>series.beside-each-other</comment>
        <translation>die Schichten liegen neben- statt übereinander. Andere Serie wählen.</translation>
    </message>
    <message>
        <source>its slices lie too unevenly to make a volume of them (%1 over %2). Copy all slices of the series, or choose another one.</source>
        <comment>series.too-uneven</comment>
        <translation>die Schichten liegen zu ungleich für ein Volumen (%1 auf %2). Alle Schichten der Serie kopieren oder eine andere wählen.</translation>
    </message>
    <message>
        <source>it is a colour image. Choose the scan itself, in grey values.</source>
        <comment>series.colour</comment>
        <translation>ist ein Farbbild. Den Scan selbst in Grauwerten wählen.</translation>
    </message>
    <message>
        <source>its pixels are not of the size its header gives. Export it again.</source>
        <comment>series.slice-size</comment>
        <translation>die Pixel haben nicht die Größe laut Header. Neu exportieren.</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced (%1 to %2): resampled to %3.</source>
        <comment>series.uneven-slices</comment>
        <translation>Die Schichten sind ungleich beabstandet (%1 bis %2): auf %3 umgerechnet.</translation>
    </message>
    <message>
        <source>The slices are not stacked upright (%1 off, as with a tilted gantry): shifted within their planes to where they lie.</source>
        <comment>series.slanted</comment>
        <translation>Die Schichten sind nicht gerade gestapelt (%1, wie bei geneigter Gantry): in ihren Ebenen an ihren Ort verschoben.</translation>
    </message>
    <message>
        <source>1 of %1 slices is missing (%2): filled in between their neighbours. Copy the series again if you can.</source>
        <comment>series.slice-missing</comment>
        <translation>1 von %1 Schichten fehlt (%2): zwischen den Nachbarn ergänzt. Die Serie wenn möglich neu kopieren.</translation>
    </message>
    <message>
        <source>%1 of %2 slices are missing (%3): filled in between their neighbours. Copy the series again if you can.</source>
        <comment>series.slices-missing</comment>
        <translation>%1 von %2 Schichten fehlen (%3): zwischen den Nachbarn ergänzt. Die Serie wenn möglich neu kopieren.</translation>
    </message>
    <message>
        <source>after slice %1</source>
        <comment>series.after-slices</comment>
        <translation>nach Schicht %1</translation>
    </message>
    <message>
        <source>after slice %1 and elsewhere</source>
        <comment>series.after-slices-and-elsewhere</comment>
        <translation>nach Schicht %1 und anderswo</translation>
    </message>
    <message>
        <source>%1 of %2 slices lie where another one does; the first recorded of each is used.</source>
        <comment>series.overlap</comment>
        <translation>%1 von %2 Schichten liegen auf einer anderen; die jeweils zuerst aufgenommene gilt.</translation>
    </message>
    <message>
        <source>%1 files of the series are there twice.</source>
        <comment>series.files-twice</comment>
        <translation>%1 Dateien der Serie sind doppelt vorhanden.</translation>
    </message>
    <message>
        <source>%1 files of the series are damaged at their end.</source>
        <comment>series.files-damaged</comment>
        <translation>%1 Dateien der Serie sind am Ende beschädigt.</translation>
    </message>
    <message>
        <source>The series mixes images of %1 sizes or orientations; each is listed by itself.</source>
        <comment>series.mixed</comment>
        <translation>Die Serie mischt Bilder in %1 Größen oder Ausrichtungen; jede ist einzeln aufgeführt.</translation>
    </message>
    <message>
        <source>part %1 of %2</source>
        <comment>series.part</comment>
        <translation>Teil %1 von %2</translation>
    </message>
    <message>
        <source>Its slices are stored with different scales or as float. %1</source>
        <comment>series.scales</comment>
        <translation>Ihre Schichten sind verschieden skaliert oder als Gleitkomma gespeichert. %1</translation>
    </message>
    <message>
        <source>this is no volume that this program reads. Choose a DICOM folder, NIfTI, NRRD or MetaImage (.mha, .mhd).</source>
        <comment>volume.unknown</comment>
        <translation>das ist kein Volumen, das dieses Programm liest. Einen DICOM-Ordner, NIfTI, NRRD oder MetaImage (.mha, .mhd) wählen.</translation>
    </message>
    <message>
        <source>this is %1, not a volume. Choose a DICOM folder, NIfTI, NRRD or MetaImage (.mha, .mhd).</source>
        <comment>volume.is-other</comment>
        <translation>das ist %1, kein Volumen. Einen DICOM-Ordner, NIfTI, NRRD oder MetaImage (.mha, .mhd) wählen.</translation>
    </message>
    <message>
        <source>it holds a %1, not an image. Choose the scan.</source>
        <comment>volume.holds-other</comment>
        <translation>enthält ein %1, kein Bild. Den Scan wählen.</translation>
    </message>
    <message>
        <source>it declares %1, more than this program holds. Crop the scan to the vessels.</source>
        <comment>volume.declares</comment>
        <translation>nennt %1, mehr als dieses Programm fasst. Den Scan auf die Gefäße zuschneiden.</translation>
    </message>
    <message>
        <source>the volume is larger than this computer&apos;s memory. Crop the scan to the vessels.</source>
        <comment>volume.larger-than-memory</comment>
        <translation>das Volumen ist größer als der Speicher dieses Rechners. Den Scan auf die Gefäße zuschneiden.</translation>
    </message>
    <message>
        <source>it has %1: a single slice is no volume. Choose the whole scan.</source>
        <comment>volume.single-slice</comment>
        <translation>hat %1: eine einzelne Schicht ist kein Volumen. Den ganzen Scan wählen.</translation>
    </message>
    <message>
        <source>it is %1-dimensional, but a volume has three dimensions. Choose the whole scan.</source>
        <comment>volume.not-three-dimensional</comment>
        <translation>ist %1-dimensional, ein Volumen hat aber drei Dimensionen. Den ganzen Scan wählen.</translation>
    </message>
    <message>
        <source>it has %1 dimensions (4-D or more). Save the one volume to use and open that.</source>
        <comment>volume.dimensions</comment>
        <translation>hat %1 Dimensionen (4-D oder mehr). Das gewünschte Volumen einzeln speichern und öffnen.</translation>
    </message>
    <message>
        <source>it holds %1 volumes or values per voxel (4-D). Extract the one to use and open that.</source>
        <comment>volume.several-4d</comment>
        <translation>enthält %1 Volumen oder Werte je Voxel (4-D). Das gewünschte herauslösen und öffnen.</translation>
    </message>
    <message>
        <source>it holds %1 volumes, layers or values per voxel (4-D). Save the one to use and open that.</source>
        <comment>volume.several-layers</comment>
        <translation>enthält %1 Volumen, Lagen oder Werte je Voxel (4-D). Das gewünschte einzeln speichern und öffnen.</translation>
    </message>
    <message>
        <source>it has %1 values per voxel. Choose the scan itself, in grey values.</source>
        <comment>volume.channels</comment>
        <translation>hat %1 Werte je Voxel. Den Scan selbst in Grauwerten wählen.</translation>
    </message>
    <message>
        <source>its first axis has %1 entries: this is a colour picture, not a volume. Choose the scan.</source>
        <comment>volume.colour-axis</comment>
        <translation>die erste Achse hat %1 Einträge: das ist ein Farbbild, kein Volumen. Den Scan wählen.</translation>
    </message>
    <message>
        <source>its voxels are colours. Choose the scan itself, in grey values.</source>
        <comment>volume.colours</comment>
        <translation>die Voxel sind Farben. Den Scan selbst in Grauwerten wählen.</translation>
    </message>
    <message>
        <source>its header gives %1. The file is damaged; export it again.</source>
        <comment>volume.header-gives</comment>
        <translation>der Header nennt %1. Die Datei ist beschädigt; neu exportieren.</translation>
    </message>
    <message>
        <source>its header gives no usable voxel size or place. Export the volume again.</source>
        <comment>volume.no-place</comment>
        <translation>der Header nennt keine brauchbare Voxelgröße oder Lage. Das Volumen neu exportieren.</translation>
    </message>
    <message>
        <source>its header is damaged: it names %1 dimensions. Export it again.</source>
        <comment>volume.header-dimensions</comment>
        <translation>der Header ist beschädigt: er nennt %1 Dimensionen. Neu exportieren.</translation>
    </message>
    <message>
        <source>its header is damaged: the voxels begin at an impossible place. Export it again.</source>
        <comment>volume.impossible-start</comment>
        <translation>der Header ist beschädigt: die Voxel beginnen an unmöglicher Stelle. Neu exportieren.</translation>
    </message>
    <message>
        <source>its axes are %1 apart instead of 90°. Resample the volume to perpendicular axes.</source>
        <comment>volume.skewed</comment>
        <translation>die Achsen stehen %1 statt 90° zueinander. Das Volumen auf senkrechte Achsen umrechnen.</translation>
    </message>
    <message>
        <source>its header cannot be read (%1). Export it again.</source>
        <comment>volume.header-not-read</comment>
        <translation>der Header ist nicht lesbar (%1). Neu exportieren.</translation>
    </message>
    <message>
        <source>its %1 header cannot be read. Export it again.</source>
        <comment>volume.format-header-not-read</comment>
        <translation>der %1-Header ist nicht lesbar. Neu exportieren.</translation>
    </message>
    <message>
        <source>its HeaderSize makes no sense. Correct the header.</source>
        <comment>volume.header-size</comment>
        <translation>die HeaderSize ergibt keinen Sinn. Den Header berichtigen.</translation>
    </message>
    <message>
        <source>it does not say where its voxels are (ElementDataFile). Export it again.</source>
        <comment>volume.no-data-file</comment>
        <translation>sagt nicht, wo die Voxel liegen (ElementDataFile). Neu exportieren.</translation>
    </message>
    <message>
        <source>its line skip or byte skip makes no sense. Correct the header.</source>
        <comment>volume.skips</comment>
        <translation>line skip oder byte skip ergibt keinen Sinn. Den Header berichtigen.</translation>
    </message>
    <message>
        <source>it skips lines of another file. Save header and voxels as one file.</source>
        <comment>volume.skips-lines-elsewhere</comment>
        <translation>überspringt Zeilen einer anderen Datei. Header und Voxel als eine Datei speichern.</translation>
    </message>
    <message>
        <source>its voxels lie in several files. Save it as one file.</source>
        <comment>volume.several-files</comment>
        <translation>die Voxel liegen in mehreren Dateien. Als eine Datei speichern.</translation>
    </message>
    <message>
        <source>its voxel type (&quot;%1&quot;) is not read. Save it as 16-bit or float.</source>
        <comment>volume.voxel-type</comment>
        <translation>der Voxeltyp (&quot;%1&quot;) wird nicht gelesen. Als 16 Bit oder float speichern.</translation>
    </message>
    <message>
        <source>its voxel type (NIfTI datatype %1) is not read. Save it as 16-bit or float.</source>
        <comment>volume.nifti-type</comment>
        <translation>der Voxeltyp (NIfTI-Datentyp %1) wird nicht gelesen. Als 16 Bit oder float speichern.</translation>
    </message>
    <message>
        <source>its voxel type is not read. Save it as 16-bit or float.</source>
        <comment>volume.other-voxel-type</comment>
        <translation>der Voxeltyp wird nicht gelesen. Als 16 Bit oder float speichern.</translation>
    </message>
    <message>
        <source>its voxels are packed with bzip2. Save it with gzip or raw encoding.</source>
        <comment>volume.bzip2</comment>
        <translation>die Voxel sind mit bzip2 gepackt. Mit gzip oder roh speichern.</translation>
    </message>
    <message>
        <source>its voxels are written as text (%1). Save it with gzip or raw encoding.</source>
        <comment>volume.text-encoding</comment>
        <translation>die Voxel sind als Text geschrieben (%1). Mit gzip oder roh speichern.</translation>
    </message>
    <message>
        <source>its voxels are written as text. Save it with binary data.</source>
        <comment>volume.text</comment>
        <translation>die Voxel sind als Text geschrieben. Binär speichern.</translation>
    </message>
    <message>
        <source>its voxels are cut short, or their packing is damaged. Copy or export it again.</source>
        <comment>volume.packing-damaged</comment>
        <translation>die Voxel sind unvollständig oder falsch gepackt. Neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>its voxels are cut short or damaged. Copy or export it again.</source>
        <comment>volume.voxels-damaged</comment>
        <translation>die Voxel sind unvollständig oder beschädigt. Neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>its voxels are cut short. Copy or export it again.</source>
        <comment>volume.cut-short</comment>
        <translation>die Voxel sind unvollständig. Neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>its voxels are cut short: %1 of %2 bytes are there. Copy or export it again.</source>
        <comment>volume.cut-short-by</comment>
        <translation>die Voxel sind unvollständig: %1 von %2 Bytes vorhanden. Neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>its voxels are in %1, which is not there. Copy both files together.</source>
        <comment>volume.voxels-not-there</comment>
        <translation>die Voxel stehen in %1, das fehlt. Beide Dateien zusammen kopieren.</translation>
    </message>
    <message>
        <source>the file with its voxels cannot be read (%1).</source>
        <comment>volume.voxel-file-not-read</comment>
        <translation>die Datei mit den Voxeln lässt sich nicht lesen (%1).</translation>
    </message>
    <message>
        <source>its voxels begin with the header of another volume. Open that file itself, or give the bytes to skip: -1 where the voxels are the last ones.</source>
        <comment>volume.voxels-are-header</comment>
        <translation>die Voxel beginnen mit dem Kopf eines anderen Volumens. Jene Datei selbst öffnen oder die zu überspringenden Bytes angeben: -1, wo die Voxel am Ende stehen.</translation>
    </message>
    <message>
        <source>none of its voxels is a number. Export the volume again.</source>
        <comment>volume.no-numbers</comment>
        <translation>keines der Voxel ist eine Zahl. Das Volumen neu exportieren.</translation>
    </message>
    <message>
        <source>%1 voxels are not numbers; they are taken as the lowest value.</source>
        <comment>volume.not-numbers</comment>
        <translation>%1 Voxel sind keine Zahlen; sie gelten als kleinster Wert.</translation>
    </message>
    <message>
        <source>The %1 voxels are rounded to 16 bit, in steps of %2.</source>
        <comment>volume.rounded</comment>
        <translation>Die %1-Voxel werden auf 16 Bit gerundet, in Schritten von %2.</translation>
    </message>
    <message>
        <source>The header does not say how the axes lie in the patient: i to the left, j to the back and k to the head are assumed. Check left and right.</source>
        <comment>volume.axes-assumed</comment>
        <translation>Der Header sagt nicht, wie die Achsen im Patienten liegen: i nach links, j nach hinten, k zum Kopf angenommen. Links und rechts prüfen.</translation>
    </message>
    <message>
        <source>The header does not say how the voxels lie in the patient: +x right to left, +y front to back and +z up are assumed to be i, j reversed and k. Check left and right.</source>
        <comment>volume.voxels-assumed</comment>
        <translation>Der Header sagt nicht, wie die Voxel im Patienten liegen: +x rechts nach links, +y vorn nach hinten und +z aufwärts als i, umgekehrtes j und k angenommen. Links und rechts prüfen.</translation>
    </message>
    <message>
        <source>The header gives no voxel size: 1 x 1 x 1 mm is assumed.</source>
        <comment>volume.size-assumed</comment>
        <translation>Der Header nennt keine Voxelgröße: 1 x 1 x 1 mm angenommen.</translation>
    </message>
    <message>
        <source>The voxel size is given as 1 x 1 x 1 mm: check that it was not lost on the way.</source>
        <comment>volume.size-of-one</comment>
        <translation>Die Voxelgröße ist mit 1 x 1 x 1 mm angegeben: prüfen, ob sie unterwegs verloren ging.</translation>
    </message>
    <message>
        <source>NIfTI holds at most 32767 voxels along an axis. Write .nrrd or .mha.</source>
        <comment>volume.nifti-too-long</comment>
        <translation>NIfTI fasst höchstens 32767 Voxel je Achse. .nrrd oder .mha schreiben.</translation>
    </message>
    <message>
        <source>volumes are written as .nii, .nii.gz, .nrrd or .mha. Change the extension.</source>
        <comment>volume.extension</comment>
        <translation>Volumen werden als .nii, .nii.gz, .nrrd oder .mha geschrieben. Die Endung ändern.</translation>
    </message>
    <message>
        <source>there are no voxels to write. Load a volume first.</source>
        <comment>volume.nothing-to-write</comment>
        <translation>keine Voxel zu schreiben. Zuerst ein Volumen laden.</translation>
    </message>
    <message>
        <source>there is no memory left to pack the volume.</source>
        <comment>volume.no-memory-to-pack</comment>
        <translation>kein Speicher mehr, um das Volumen zu packen.</translation>
    </message>
    <message>
        <source>this DICOM file is no segmentation. Choose a label image.</source>
        <comment>labels.no-segmentation</comment>
        <translation>Diese DICOM-Datei ist keine Segmentierung. Ein Labelbild wählen.</translation>
    </message>
    <message>
        <source>it has one plane: a single slice is no volume. Choose the whole segmentation.</source>
        <comment>labels.one-plane</comment>
        <translation>sie hat eine Ebene: Eine einzelne Schicht ist kein Volumen. Wählen Sie die ganze Segmentierung.</translation>
    </message>
    <message>
        <source>it holds %1, which is no label: labels are whole numbers from 0. Choose a label image.</source>
        <comment>labels.no-whole-number</comment>
        <translation>enthält %1, kein Label: Labels sind ganze Zahlen ab 0. Ein Labelbild wählen.</translation>
    </message>
    <message>
        <source>nothing is marked in it: every voxel is background. Choose another segmentation.</source>
        <comment>labels.nothing-marked</comment>
        <translation>nichts ist darin markiert: alle Voxel sind Hintergrund. Eine andere Segmentierung wählen.</translation>
    </message>
    <message>
        <source>it has no label %1 but %2. Choose one of these.</source>
        <comment>labels.no-such-number</comment>
        <translation>sie hat kein Label %1, aber %2. Wählen Sie eines davon.</translation>
    </message>
    <message>
        <source>it has no label &quot;%1&quot; but %2. Choose one of these.</source>
        <comment>labels.no-such-name</comment>
        <translation>sie hat kein Label „%1“, aber %2. Wählen Sie eines davon.</translation>
    </message>
    <message>
        <source>none at all</source>
        <comment>labels.none</comment>
        <translation>gar keines</translation>
    </message>
    <message>
        <source>Labels traced: %1.</source>
        <comment>labels.traced</comment>
        <translation>Erfasste Labels: %1.</translation>
    </message>
    <message>
        <source>Labels left out, by their names: %1.</source>
        <comment>labels.left-out</comment>
        <translation>Nach ihren Namen weggelassene Labels: %1.</translation>
    </message>
    <message>
        <source>The volume holds labels: its vessels are taken as they are marked.</source>
        <comment>labels.volume-holds-labels</comment>
        <translation>Das Volumen enthält Labels: die Gefäße gelten, wie sie markiert sind.</translation>
    </message>
    <message>
        <source>A length at the vessels needs their depth: open the vessels, or measure at the detector or in pixels.</source>
        <comment>measure.needs-vessels</comment>
        <translation>Eine Länge an den Gefäßen braucht deren Tiefe: die Gefäße öffnen oder am Detektor oder in Pixeln messen.</translation>
    </message>
    <message>
        <source>The vessels lie behind the source: nothing can be measured at them. Correct the pose, or measure in pixels.</source>
        <comment>measure.behind-source</comment>
        <translation>Die Gefäße liegen hinter der Quelle: an ihnen lässt sich nichts messen. Die Lage berichtigen oder in Pixeln messen.</translation>
    </message>
    <message>
        <source>The pixel spacing of the detector is not known. Type it in the geometry, or measure in pixels.</source>
        <comment>measure.needs-spacing</comment>
        <translation>Der Pixelabstand des Detektors ist nicht bekannt. In der Geometrie eingeben oder in Pixeln messen.</translation>
    </message>
    <message>
        <source>A measurement of this kind has %1 points at least; this one has %2. Draw it again.</source>
        <comment>measure.points</comment>
        <translation>Eine Messung dieser Art hat mindestens %1 Punkte; diese hat %2. Neu zeichnen.</translation>
    </message>
    <message>
        <source>A point of the measurement is not a number. Draw it again.</source>
        <comment>measure.not-finite</comment>
        <translation>Ein Punkt der Messung ist keine Zahl. Neu zeichnen.</translation>
    </message>
    <message>
        <source>The angle has a leg without length. Move its points apart.</source>
        <comment>measure.angle-open</comment>
        <translation>Der Winkel hat einen Schenkel ohne Länge. Seine Punkte auseinanderziehen.</translation>
    </message>
    <message>
        <source>The outline crosses itself: its area means nothing. Move its points.</source>
        <comment>measure.crossed</comment>
        <translation>Der Umriss kreuzt sich selbst: seine Fläche sagt nichts. Seine Punkte verschieben.</translation>
    </message>
    <message>
        <source>%1 at the vessels</source>
        <comment>measure.at-vessels</comment>
        <translation>%1 an den Gefäßen</translation>
    </message>
    <message>
        <source>%1 at the detector</source>
        <comment>measure.at-detector</comment>
        <translation>%1 am Detektor</translation>
    </message>
    <message>
        <source>%1</source>
        <comment>measure.plain</comment>
        <translation>%1</translation>
    </message>
    <message>
        <source>%1 (scale assumed)</source>
        <comment>measure.assumed</comment>
        <translation>%1 (Maßstab angenommen)</translation>
    </message>
    <message>
        <source>At the depth of the vessels&apos; centroid, %1 from the source, a pixel is %2. What runs towards the source or away from it is longer than it looks.</source>
        <comment>measure.basis-vessels</comment>
        <translation>In der Tiefe des Schwerpunkts der Gefäße, %1 von der Quelle, ist ein Pixel %2. Was zur Quelle hin oder von ihr weg verläuft, ist länger als es aussieht.</translation>
    </message>
    <message>
        <source>On the detector a pixel is %1; in the patient everything is smaller, by the magnification.</source>
        <comment>measure.basis-detector</comment>
        <translation>Auf dem Detektor ist ein Pixel %1; im Patienten ist alles kleiner, um die Vergrößerung.</translation>
    </message>
    <message>
        <source>In pixels of the image: nothing is said of the patient.</source>
        <comment>measure.basis-pixels</comment>
        <translation>In Pixeln des Bildes: über den Patienten ist damit nichts gesagt.</translation>
    </message>
    <message>
        <source>As projected: in space the angle is another one.</source>
        <comment>measure.basis-angle</comment>
        <translation>Wie projiziert: im Raum ist der Winkel ein anderer.</translation>
    </message>
    <message>
        <source>Pixels are taken to be square.</source>
        <comment>measure.square-pixels</comment>
        <translation>Pixel gelten als quadratisch.</translation>
    </message>
    <message>
        <source>The geometry behind this scale is assumed, not measured: the number may be wrong by the same share.</source>
        <comment>measure.scale-assumed</comment>
        <translation>Die Geometrie hinter diesem Maßstab ist angenommen, nicht gemessen: die Zahl kann um denselben Anteil falsch sein.</translation>
    </message>
    <message>
        <source>The geometry behind this scale was typed.</source>
        <comment>measure.scale-typed</comment>
        <translation>Die Geometrie hinter diesem Maßstab wurde eingegeben.</translation>
    </message>
    <message>
        <source>No registration found this pose: how deep the vessels lie is as it was set.</source>
        <comment>measure.depth-unchecked</comment>
        <translation>Keine Registrierung hat diese Lage gefunden: die Tiefe der Gefäße ist, wie sie gesetzt wurde.</translation>
    </message>
    <message>
        <source>The registration behind this pose is not trustworthy: nor is the depth of the vessels.</source>
        <comment>measure.pose-doubtful</comment>
        <translation>Die Registrierung hinter dieser Lage ist nicht vertrauenswürdig: die Tiefe der Gefäße auch nicht.</translation>
    </message>
    <message>
        <source>Their depth is known to ±%1 (1-σ): ±%2 of the length.</source>
        <comment>measure.depth-spread</comment>
        <translation>Ihre Tiefe ist auf ±%1 (1-σ) bekannt: ±%2 der Länge.</translation>
    </message>
    <message>
        <source>a measurement of this kind has %1 points at least, not %2. Add them or remove the measurement.</source>
        <comment>case.measurement-points</comment>
        <translation>eine Messung dieser Art hat mindestens %1 Punkte, nicht %2. Ergänzen oder die Messung entfernen.</translation>
    </message>
    <message>
        <source>Branch %1 has no length that could be measured along. Trace it again.</source>
        <comment>measure.branch-no-length</comment>
        <translation>Ast %1 hat keine Länge, entlang der sich messen ließe. Neu verfolgen.</translation>
    </message>
    <message>
        <source>This branch has no radii: its diameter is not known. Trace a scan, or open a tree with radii.</source>
        <comment>measure.branch-no-radii</comment>
        <translation>Dieser Ast hat keine Radien: sein Durchmesser ist nicht bekannt. Eine Aufnahme verfolgen oder einen Gefäßbaum mit Radien öffnen.</translation>
    </message>
    <message>
        <source>No part of this branch is even enough to be a reference: no narrowing is given.</source>
        <comment>measure.branch-no-reference</comment>
        <translation>Kein Teil dieses Astes ist gleichmäßig genug für eine Referenz: keine Verengung wird angegeben.</translation>
    </message>
    <message>
        <source>No scale was typed for this image. Type what a pixel measures, or measure in pixels.</source>
        <comment>measure.needs-typed-scale</comment>
        <translation>Für dieses Bild ist kein Maßstab eingegeben. Eingeben, was ein Pixel misst, oder in Pixeln messen.</translation>
    </message>
    <message>
        <source>%1 by the typed scale</source>
        <comment>measure.by-typed</comment>
        <translation>%1 nach eingegebenem Maßstab</translation>
    </message>
    <message>
        <source>A pixel is %1, as typed for this image. It holds where that was measured, at its depth alone.</source>
        <comment>measure.basis-typed</comment>
        <translation>Ein Pixel ist %1, wie für dieses Bild eingegeben. Das gilt dort, wo es gemessen wurde, nur in dessen Tiefe.</translation>
    </message>
    <message>
        <source>Not pointed at in this frame: choose Seen here, and click where it is seen.</source>
        <comment>check.not-seen</comment>
        <translation>In diesem Bild nicht gezeigt: „Hier zu sehen“ wählen und dorthin klicken, wo er zu sehen ist.</translation>
    </message>
    <message>
        <source>Pointed at in frame %1; the pose is of frame %2. Show that frame, or point at it here.</source>
        <comment>check.other-frame</comment>
        <translation>Gezeigt in Bild %1; die Lage gilt für Bild %2. Jenes Bild zeigen oder hier darauf zeigen.</translation>
    </message>
    <message>
        <source>It lies behind the source at this pose. Correct the pose.</source>
        <comment>check.behind-source</comment>
        <translation>Bei dieser Lage liegt er hinter der Quelle. Die Lage berichtigen.</translation>
    </message>
    <message>
        <source>In the image plane at its depth (%1 from the source): %2, %3. A pixel is %4 there: no click is finer.</source>
        <comment>check.image-error</comment>
        <translation>In der Bildebene seiner Tiefe (%1 von der Quelle): %2, %3. Ein Pixel ist dort %4: feiner ist kein Klick.</translation>
    </message>
    <message>
        <source>The pose&apos;s own covariance expects %1 there (1-σ).</source>
        <comment>check.claimed</comment>
        <translation>Die Kovarianz der Lage selbst erwartet dort %1 (1-σ).</translation>
    </message>
    <message>
        <source>No registration found this pose: nothing is claimed of it.</source>
        <comment>check.nothing-claimed</comment>
        <translation>Keine Registrierung hat diese Lage gefunden: über sie wird nichts behauptet.</translation>
    </message>
    <message>
        <source>With the vessels bent: %1.</source>
        <comment>check.bent</comment>
        <translation>Mit gebogenen Gefäßen: %1.</translation>
    </message>
    <message>
        <source>In space, where the rays of views %1 meet (%2 between them): %3. The rays pass each other by %4.</source>
        <comment>check.space-error</comment>
        <translation>Im Raum, wo sich die Strahlen der Ansichten %1 treffen (%2 zwischen ihnen): %3. Die Strahlen verfehlen einander um %4.</translation>
    </message>
    <message>
        <source>An error in space needs the point seen in two views: only one tells of it so far.</source>
        <comment>check.needs-two-views</comment>
        <translation>Ein Fehler im Raum braucht den Punkt in zwei Ansichten: bisher zeigt ihn höchstens eine.</translation>
    </message>
    <message>
        <source>The views look at it from nearly the same side (%1 between the rays): its depth cannot be told.</source>
        <comment>check.rays-alike</comment>
        <translation>Die Ansichten sehen ihn von fast derselben Seite (%1 zwischen den Strahlen): seine Tiefe ist nicht zu bestimmen.</translation>
    </message>
    <message>
        <source>%1 off</source>
        <comment>check.label</comment>
        <translation>%1 daneben</translation>
    </message>
    <message>
        <source>%1 off, %2 claimed</source>
        <comment>check.label-claimed</comment>
        <translation>%1 daneben, %2 behauptet</translation>
    </message>
    <message>
        <source>⌀ %1</source>
        <comment>check.ring-width</comment>
        <translation>⌀ %1</translation>
    </message>
    <message>
        <source>This branch has no radius here: a ring would have no size. Set a check point instead.</source>
        <comment>check.ring-needs-radius</comment>
        <translation>Dieser Ast hat hier keinen Radius: ein Ring hätte keine Größe. Stattdessen einen Prüfpunkt setzen.</translation>
    </message>
    <message>
        <source>Click on the vessels: a check point or a ring lies on them.</source>
        <comment>check.needs-vessels</comment>
        <translation>Auf die Gefäße klicken: ein Prüfpunkt oder Ring liegt auf ihnen.</translation>
    </message>
    <message>
        <source>At x %1, y %2, z %3 of the patient.</source>
        <comment>check.place</comment>
        <translation>Bei x %1, y %2, z %3 des Patienten.</translation>
    </message>
    <message>
        <source>two marks have the number %1. Give each its own.</source>
        <comment>case.mark-twice</comment>
        <translation>zwei Marken haben die Nummer %1. Jeder ihre eigene geben.</translation>
    </message>
    <message>
        <source>a ring needs a radius above 0 and a direction. Add them or remove it.</source>
        <comment>case.ring-open</comment>
        <translation>ein Ring braucht einen Radius über 0 und eine Richtung. Ergänzen oder den Ring entfernen.</translation>
    </message>
    <message>
        <source>an arrow has two points, a text one. Mend the points or remove it.</source>
        <comment>case.annotation-points</comment>
        <translation>ein Pfeil hat zwei Punkte, ein Text einen. Die Punkte berichtigen oder ihn entfernen.</translation>
    </message>
    <message>
        <source>Scan voxels of %1 × %2 × %3.</source>
        <comment>measure.basis-scan</comment>
        <translation>Scan-Voxel von %1 × %2 × %3.</translation>
    </message>
    <message>
        <source>Scan voxels; the scan is not open, so that their size is not known here.</source>
        <comment>measure.basis-scan-away</comment>
        <translation>Scan-Voxel; der Scan ist nicht geöffnet, ihre Größe daher hier nicht bekannt.</translation>
    </message>
    <message>
        <source>In the plane of the slice: legs that leave it make another angle in space.</source>
        <comment>measure.basis-scan-angle</comment>
        <translation>In der Ebene der Schicht: Schenkel, die sie verlassen, bilden im Raum einen anderen Winkel.</translation>
    </message>
    <message>
        <source>it is a report, not an image.</source>
        <comment>study.report</comment>
        <translation>sie ist ein Befund, kein Bild.</translation>
    </message>
    <message>
        <source>it only says how other images are shown.</source>
        <comment>study.presentation</comment>
        <translation>sie sagt nur, wie andere Bilder gezeigt werden.</translation>
    </message>
    <message>
        <source>it holds no image (%1).</source>
        <comment>study.no-image</comment>
        <translation>sie enthält kein Bild (%1).</translation>
    </message>
    <message>
        <source>it is a scout, which planned the scan: neither a volume nor an angiogram.</source>
        <comment>study.scout</comment>
        <translation>sie ist ein Übersichtsbild zur Planung: weder Volumen noch Angiogramm.</translation>
    </message>
    <message>
        <source>its frames are packed as a video, which is not read. Export it in another way.</source>
        <comment>study.video</comment>
        <translation>ihre Bilder sind als Video gepackt, das nicht gelesen wird. Bitte anders exportieren.</translation>
    </message>
    <message>
        <source>in images of modality %1 no vessels are traced.</source>
        <comment>study.modality</comment>
        <translation>in Bildern der Modalität %1 werden keine Gefäße gesucht.</translation>
    </message>
    <message>
        <source>the DICOMDIR lists it, but its files are not there.</source>
        <comment>study.missing</comment>
        <translation>das DICOMDIR nennt sie, aber ihre Dateien sind nicht da.</translation>
    </message>
    <message>
        <source>it has no list of files</source>
        <comment>directory.no-records</comment>
        <translation>es hat keine Liste von Dateien</translation>
    </message>
    <message>
        <source>its records do not lead to each other</source>
        <comment>directory.torn</comment>
        <translation>seine Einträge führen nicht zueinander</translation>
    </message>
    <message>
        <source>it ends in the middle of a record</source>
        <comment>directory.unfinished</comment>
        <translation>es endet mitten in einem Eintrag</translation>
    </message>
    <message>
        <source>movies are written as .mp4 or .gif. Choose one of these.</source>
        <comment>movie.kind</comment>
        <translation>Filme werden als .mp4 oder .gif geschrieben. Eines davon wählen.</translation>
    </message>
    <message>
        <source>a movie has %1 pixels on a side at least. Choose a larger size.</source>
        <comment>movie.too-small</comment>
        <translation>ein Film hat mindestens %1 Pixel je Seite. Eine größere Größe wählen.</translation>
    </message>
    <message>
        <source>MP4 holds no pictures of %1 × %2 pixels: 9,437,184 at most (4096 × 2304), and 8688 on a side. Choose a smaller size, or GIF.</source>
        <comment>movie.too-large</comment>
        <translation>MP4 fasst keine Bilder von %1 × %2 Pixeln: höchstens 9.437.184 (4096 × 2304) und 8688 je Seite. Eine kleinere Größe oder GIF wählen.</translation>
    </message>
    <message>
        <source>a GIF of %1 × %2 pixels is not written: %3 on a side at most. Choose a smaller size.</source>
        <comment>movie.gif-too-large</comment>
        <translation>ein GIF von %1 × %2 Pixeln wird nicht geschrieben: höchstens %3 je Seite. Eine kleinere Größe wählen.</translation>
    </message>
    <message>
        <source>the pictures of a movie must be equally large.</source>
        <comment>movie.sizes-differ</comment>
        <translation>die Bilder eines Films müssen gleich groß sein.</translation>
    </message>
    <message>
        <source>the movie could not be encoded. Choose another size, or GIF.</source>
        <comment>movie.encoder-failed</comment>
        <translation>der Film konnte nicht kodiert werden. Eine andere Größe oder GIF wählen.</translation>
    </message>
    <message>
        <source>the movie would be larger than 1 GB. Choose fewer frames or a smaller size.</source>
        <comment>movie.too-long</comment>
        <translation>der Film würde größer als 1 GB. Weniger Bilder oder eine kleinere Größe wählen.</translation>
    </message>
    <message>
        <source>the movie could not be written. Choose another size or format.</source>
        <comment>movie.not-made</comment>
        <translation>der Film konnte nicht geschrieben werden. Eine andere Größe oder ein anderes Format wählen.</translation>
    </message>
    <message>
        <source>The report template %1 cannot be read: it is a text in UTF-8 of at most 1 MB. Choose another one, or the built-in one.</source>
        <comment>report.template-unreadable</comment>
        <translation>Die Berichtsvorlage %1 ist nicht lesbar: Sie ist ein Text in UTF-8 von höchstens 1 MB. Eine andere wählen oder die eingebaute.</translation>
    </message>
    <message>
        <source>The report template lacks %1. Without it a report could keep back what must be read with the result: add it.</source>
        <comment>report.template-lacks</comment>
        <translation>Der Berichtsvorlage fehlt %1. Ohne das könnte ein Bericht verschweigen, was mit dem Ergebnis gelesen werden muss: hinzufügen.</translation>
    </message>
    <message>
        <source>The report template has %1, which nothing fills in. Known are %2.</source>
        <comment>report.template-unknown</comment>
        <translation>Die Berichtsvorlage enthält %1, das durch nichts ausgefüllt wird. Bekannt sind %2.</translation>
    </message>
    <message>
        <source>The report template has “%1”, by which a report could fetch or run something. Take it out.</source>
        <comment>report.template-fetches</comment>
        <translation>Die Berichtsvorlage enthält „%1“, womit ein Bericht etwas laden oder ausführen könnte. Das entfernen.</translation>
    </message>
    <message>
        <source>The picture %1 of the report template cannot be read. Put it beside the template, as PNG or JPEG of at most 16 MB and 8192 pixels a side.</source>
        <comment>report.template-picture</comment>
        <translation>Das Bild %1 der Berichtsvorlage ist nicht lesbar. Es neben die Vorlage legen, als PNG oder JPEG von höchstens 16 MB und 8192 Pixeln je Seite.</translation>
    </message>
    <message>
        <source>the pictures together are more than a DICOM object may hold. Choose a smaller width or fewer frames.</source>
        <comment>object.too-large</comment>
        <translation>die Bilder zusammen sind mehr, als ein DICOM-Objekt fassen darf. Eine kleinere Breite oder weniger Bilder wählen.</translation>
    </message>
    <message>
        <source>this is not a PDF. Export the report as PDF first.</source>
        <comment>object.no-pdf</comment>
        <translation>das ist kein PDF. Zuerst den Bericht als PDF exportieren.</translation>
    </message>
    <message>
        <source>a presentation state refers to a DICOM image, and the angiogram is none that can be referred to. Open it as DICOM, or leave the presentation state out.</source>
        <comment>object.no-reference</comment>
        <translation>ein Presentation State verweist auf ein DICOM-Bild, und das Angiogramm ist keines, auf das sich verweisen lässt. Es als DICOM öffnen oder den Presentation State weglassen.</translation>
    </message>
    <message>
        <source>no vessels lie on the image. Move them there first, or leave the presentation state out.</source>
        <comment>object.no-lines</comment>
        <translation>auf dem Bild liegen keine Gefäße. Sie zuerst dorthin schieben oder den Presentation State weglassen.</translation>
    </message>
    <message>
        <source>the pose is not a rigid motion of finite numbers. Reset the pose first.</source>
        <comment>object.pose-not-rigid</comment>
        <translation>die Lage ist keine starre Bewegung aus endlichen Zahlen. Zuerst die Lage zurücksetzen.</translation>
    </message>
    <message>
        <source>no vessel lies in the scan. Check that scan and vessels are of one patient, or leave the segmentation out.</source>
        <comment>object.no-voxels</comment>
        <translation>im Scan liegt kein Gefäß. Prüfen, ob Scan und Gefäße von einem Patienten sind, oder die Segmentierung weglassen.</translation>
    </message>
    <message>
        <source>nothing was measured and nothing registered. Do one of these first, or leave the measurements out.</source>
        <comment>object.nothing-measured</comment>
        <translation>nichts wurde gemessen und nichts registriert. Zuerst eines davon tun oder die Messungen weglassen.</translation>
    </message>
    <message>
        <source>this DICOM file holds no registration of one frame of reference to another. Choose a spatial registration.</source>
        <comment>pose.no-registration</comment>
        <translation>diese DICOM-Datei enthält keine Registrierung eines Bezugssystems zu einem anderen. Eine Spatial Registration wählen.</translation>
    </message>
    <message>
        <source>a segmentation needs the scan or the mask that the vessels come from. Open it first, or leave the segmentation out.</source>
        <comment>dicom-export.no-scan</comment>
        <translation>eine Segmentierung braucht den Scan oder die Maske, aus denen die Gefäße kommen. Zuerst öffnen oder die Segmentierung weglassen.</translation>
    </message>
    <message>
        <source>reports are written by the program angiopose, which is not at &apos;%1&apos;. Install the window&apos;s program beside angiopose-cli, or build its target angiopose.</source>
        <comment>report.program-missing</comment>
        <translation>Berichte schreibt das Programm angiopose, das nicht unter &apos;%1&apos; liegt. Das Programm des Fensters neben angiopose-cli installieren oder sein Ziel angiopose bauen.</translation>
    </message>
    <message>
        <source>The program angiopose was ended by signal %1; no report was written. angiopose-cli support-bundle gathers what tells why.</source>
        <comment>report.program-fault</comment>
        <translation>Das Programm angiopose wurde durch Signal %1 beendet; es wurde kein Bericht geschrieben. angiopose-cli support-bundle sammelt, was den Grund verrät.</translation>
    </message>
    <message>
        <source>the report is written. It says that this pose is not trustworthy, and why.</source>
        <comment>report.distrusted</comment>
        <translation>der Bericht ist geschrieben. Er sagt, dass diese Lage nicht vertrauenswürdig ist, und warum.</translation>
    </message>
    <message>
        <source>stopped; no report was written.</source>
        <comment>report.stopped</comment>
        <translation>angehalten; es wurde kein Bericht geschrieben.</translation>
    </message>
    <message>
        <source>a report is made by angiopose-cli report, or by the window. Give its PDF by --report, or leave it out.</source>
        <comment>dicom-export.no-report</comment>
        <translation>einen Bericht macht angiopose-cli report oder das Fenster. Sein PDF mit --report angeben oder weglassen.</translation>
    </message>
    <message>
        <source>Left out: %1: %2</source>
        <comment>dicom-export.left-out</comment>
        <translation>Weggelassen: %1: %2</translation>
    </message>
    <message>
        <source>The angiogram is no DICOM image: its objects begin a study of their own, without a patient.</source>
        <comment>dicom-export.new-study</comment>
        <translation>Das Angiogramm ist kein DICOM-Bild: Seine Objekte beginnen eine eigene Studie ohne Patienten.</translation>
    </message>
    <message>
        <source>The scan is no DICOM series: its segmentation refers to none and has a frame of reference of its own.</source>
        <comment>dicom-export.no-scan-study</comment>
        <translation>Der Scan ist keine DICOM-Serie: Seine Segmentierung verweist auf keine und hat ein eigenes Bezugssystem.</translation>
    </message>
    <message>
        <source>A spatial registration is a rigid matrix alone: it cannot hold the perspective camera, without which it gives no overlay. That stands in its private elements and in camera.json beside it.</source>
        <comment>dicom-export.rigid-only</comment>
        <translation>Eine Spatial Registration ist nur eine starre Matrix: Die perspektivische Kamera, ohne die sie keine Überlagerung ergibt, kann sie nicht enthalten. Diese steht in ihren privaten Elementen und daneben in camera.json.</translation>
    </message>
    <message>
        <source>The presentation state shows the image as it is stored, not subtracted: its grey values are others than here.</source>
        <comment>dicom-export.treated</comment>
        <translation>Der Presentation State zeigt das Bild, wie es gespeichert ist, nicht subtrahiert: Seine Grauwerte sind andere als hier.</translation>
    </message>
    <message>
        <source>this case allows none of the objects. Open vessels and an angiogram first.</source>
        <comment>dicom-export.nothing</comment>
        <translation>dieser Fall erlaubt keines der Objekte. Zuerst Gefäße und ein Angiogramm öffnen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is unknown. Use %2.</source>
        <comment>dicom-export.kind-unknown</comment>
        <translation>„%1“ ist unbekannt. %2 verwenden.</translation>
    </message>
    <message>
        <source>stopped; nothing was written.</source>
        <comment>dicom-export.stopped</comment>
        <translation>angehalten; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Vessels of a registered 3-D tree drawn over the image, window and size as chosen</source>
        <comment>dicom-export.derivation</comment>
        <translation>Gefäße eines registrierten 3-D-Baums über das Bild gezeichnet, Fenster und Größe wie gewählt</translation>
    </message>
    <message>
        <source>No registration is known that led to this pose. Register first.</source>
        <comment>movie.no-history</comment>
        <translation>Keine Registrierung ist bekannt, die zu dieser Lage führte. Zuerst registrieren.</translation>
    </message>
    <message>
        <source>stopped before the movie was whole. Nothing was written.</source>
        <comment>movie.stopped</comment>
        <translation>angehalten, bevor der Film fertig war. Nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>pose of frame %1</source>
        <comment>movie.pose-of-frame</comment>
        <translation>Lage des Bildes %1</translation>
    </message>
    <message>
        <source>pose followed to this frame</source>
        <comment>movie.followed</comment>
        <translation>bis zu diesem Bild verfolgte Lage</translation>
    </message>
    <message>
        <source>pose followed to this frame · not trustworthy</source>
        <comment>movie.followed-distrusted</comment>
        <translation>bis zu diesem Bild verfolgte Lage · nicht vertrauenswürdig</translation>
    </message>
    <message>
        <source>step %1 of %2 · median %3</source>
        <comment>movie.step</comment>
        <translation>Schritt %1 von %2 · Median %3</translation>
    </message>
    <message>
        <source>step %1 of %2 · median %3 · its result is not trustworthy</source>
        <comment>movie.step-distrusted</comment>
        <translation>Schritt %1 von %2 · Median %3 · sein Ergebnis ist nicht vertrauenswürdig</translation>
    </message>
    <message>
        <source>seen from the front, turned by %1</source>
        <comment>movie.turned</comment>
        <translation>von vorn gesehen, um %1 gedreht</translation>
    </message>
    <message>
        <source>it cannot be written: it would be larger than files may be here, by a limit of the system (ulimit -f) or of the drive. Raise the limit or choose another folder.</source>
        <comment>file.beyond-limit</comment>
        <translation>sie lässt sich nicht schreiben: sie würde größer, als Dateien hier sein dürfen, durch eine Grenze des Systems (ulimit -f) oder des Laufwerks. Heben Sie die Grenze an oder wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>it was changed elsewhere since it was opened here. Save under another name, or open it again.</source>
        <comment>case.changed-elsewhere</comment>
        <translation>sie wurde anderswo geändert, seit sie hier geöffnet wurde. Speichern Sie unter anderem Namen oder öffnen Sie sie neu.</translation>
    </message>
    <message>
        <source>it is open elsewhere too: process %1 on %2. Save under another name, or close it there.</source>
        <comment>case.open-elsewhere</comment>
        <translation>sie ist auch anderswo geöffnet: Prozess %1 auf %2. Speichern Sie unter anderem Namen oder schließen Sie sie dort.</translation>
    </message>
    <message>
        <source>it lists no cases. Begin it with a header row that has the column case, and one of reference and pairs; a row for each case.</source>
        <comment>own.no-header</comment>
        <translation>sie führt keine Fälle auf. Beginnen Sie sie mit einer Kopfzeile mit der Spalte case und einer von reference und pairs; je Fall eine Zeile.</translation>
    </message>
    <message>
        <source>line %1 names no case. Write the path of a case file into the column case.</source>
        <comment>own.no-case</comment>
        <translation>Zeile %1 nennt keinen Fall. Schreiben Sie den Pfad einer Falldatei in die Spalte case.</translation>
    </message>
    <message>
        <source>line %1 has no truth. Name a pose in the column reference, or a table of pairs of points in pairs.</source>
        <comment>own.no-truth</comment>
        <translation>Zeile %1 hat keine Wahrheit. Nennen Sie eine Lage in der Spalte reference oder eine Tabelle von Punktpaaren in pairs.</translation>
    </message>
    <message>
        <source>line %1 says in the column bent where the vessels lay. That needs a pose in reference to see them with, and leaves no landmarks, for these would have to bend, too.</source>
        <comment>own.bent-alone</comment>
        <translation>Zeile %1 sagt in der Spalte bent, wo die Gefäße lagen. Das braucht eine Lage in reference, mit der sie gesehen werden, und lässt keine Landmarken zu, denn auch diese müssten sich biegen.</translation>
    </message>
    <message>
        <source>its branches are not those of the case&apos;s vessels, with as many points each. Bent vessels are judged point by point: move the points of the case&apos;s own vessel file.</source>
        <comment>own.bent-other</comment>
        <translation>Ihre Äste sind nicht die der Gefäße des Falles mit je ebenso vielen Punkten. Gebogene Gefäße werden Punkt für Punkt beurteilt: Verschieben Sie die Punkte der Gefäßdatei des Falles.</translation>
    </message>
    <message>
        <source>line %1: &apos;%2&apos; cannot be a condition&apos;s name, for files are called by it. Use letters, digits, dots, dashes and underscores.</source>
        <comment>own.condition-name</comment>
        <translation>Zeile %1: &apos;%2&apos; kann kein Name einer Bedingung sein, denn Dateien heißen danach. Nehmen Sie Buchstaben, Ziffern, Punkte, Binde- und Unterstriche.</translation>
    </message>
    <message>
        <source>a column is called pose. without a name after the dot. Name what found these poses.</source>
        <comment>own.pose-without-name</comment>
        <translation>eine Spalte heißt pose. ohne Namen nach dem Punkt. Nennen Sie, was diese Lagen gefunden hat.</translation>
    </message>
    <message>
        <source>it has no column %1. Landmarks need x, y, z (mm, LPS), pairs of points u and v (px) besides.</source>
        <comment>own.point-column-missing</comment>
        <translation>sie hat keine Spalte %1. Landmarken brauchen x, y, z (mm, LPS), Punktpaare dazu u und v (px).</translation>
    </message>
    <message>
        <source>it holds no points.</source>
        <comment>own.no-points</comment>
        <translation>sie enthält keine Punkte.</translation>
    </message>
    <message>
        <source>it has no column %1: it is no log of blind trials, or one of an earlier version that did not keep the centroid. Such logs are written by Registration, Blind trial.</source>
        <comment>observers.column-missing</comment>
        <translation>sie hat keine Spalte %1: Sie ist kein Protokoll blinder Versuche, oder eines einer früheren Version, die den Schwerpunkt nicht behielt. Solche Protokolle schreibt Registrierung, Blinder Versuch.</translation>
    </message>
    <message>
        <source>The logs hold no two finished trials of one image, so nothing can be compared. Let an observer repeat a trial, or another one do it.</source>
        <comment>observers.too-few</comment>
        <translation>Die Protokolle enthalten keine zwei beendeten Versuche an einem Bild, also ist nichts zu vergleichen. Lassen Sie einen Versuch wiederholen oder eine andere Person ihn machen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no key of %2. It knows: %3.</source>
        <comment>study.unknown-key</comment>
        <translation>&apos;%1&apos; ist kein Schlüssel von %2. Es kennt: %3.</translation>
    </message>
    <message>
        <source>%1 lacks &apos;%2&apos;.</source>
        <comment>study.missing-key</comment>
        <translation>%1 fehlt &apos;%2&apos;.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; of %2 cannot be this: %3.</source>
        <comment>study.wrong-value</comment>
        <translation>&apos;%1&apos; von %2 kann nicht dies sein: %3.</translation>
    </message>
    <message>
        <source>it is no study. Begin it with &quot;format&quot;: &quot;angiopose-study&quot;, &quot;version&quot;: 1.</source>
        <comment>study.no-study</comment>
        <translation>sie ist keine Studie. Beginnen Sie sie mit &quot;format&quot;: &quot;angiopose-study&quot;, &quot;version&quot;: 1.</translation>
    </message>
    <message>
        <source>two settings are called &apos;%1&apos;. Give each a name of its own: folders are called by it.</source>
        <comment>study.name-twice</comment>
        <translation>zwei Einstellungen heißen &apos;%1&apos;. Geben Sie jeder einen eigenen Namen: Ordner heißen danach.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; of %2 must lie between %3 and %4.</source>
        <comment>study.out-of-range</comment>
        <translation>&apos;%1&apos; von %2 muss zwischen %3 und %4 liegen.</translation>
    </message>
    <message>
        <source>`evaluate own` needs one table of cases and what is known of them: angiopose-cli evaluate own CASES.csv --output FOLDER.</source>
        <comment>evaluate.no-manifest</comment>
        <translation>`evaluate own` braucht eine Tabelle der Fälle und dessen, was von ihnen bekannt ist: angiopose-cli evaluate own CASES.csv --output FOLDER.</translation>
    </message>
    <message>
        <source>`evaluate observers` needs a log of blind trials: angiopose-cli evaluate observers TRIALS.csv --output FOLDER.</source>
        <comment>evaluate.no-log</comment>
        <translation>`evaluate observers` braucht ein Protokoll blinder Versuche: angiopose-cli evaluate observers TRIALS.csv --output FOLDER.</translation>
    </message>
    <message>
        <source>The experiment &apos;%1&apos; makes its own trials. Leave &apos;%2&apos; out, or write `evaluate own %2`.</source>
        <comment>evaluate.input-of-experiment</comment>
        <translation>Das Experiment &apos;%1&apos; macht seine Versuche selbst. Lassen Sie &apos;%2&apos; weg oder schreiben Sie `evaluate own %2`.</translation>
    </message>
    <message>
        <source>`simulate` needs --seed for one case or --study for many.</source>
        <comment>simulate.what</comment>
        <translation>`simulate` braucht --seed für einen Fall oder --study für viele.</translation>
    </message>
    <message>
        <source>%1 voxels lie far beyond all others (between %2 and %3); they are taken as the lowest or highest of those.</source>
        <comment>volume.stray-values</comment>
        <translation>%1 Voxel liegen weit jenseits aller anderen (zwischen %2 und %3); sie gelten als kleinster oder größter Wert von diesen.</translation>
    </message>
    <message>
        <source>what was printed did not all arrive: the drive or pipe behind the standard output is full or closed. Make room, or send it elsewhere.</source>
        <comment>run.output-not-written</comment>
        <translation>Was ausgegeben wurde, ist nicht ganz angekommen: Laufwerk oder Pipe hinter der Standardausgabe ist voll oder geschlossen. Schaffen Sie Platz, oder leiten Sie sie anderswohin.</translation>
    </message>
    <message>
        <source>the audit file cannot be written (%1), so that what was done is not in it. Make room, or allow writing to it.</source>
        <comment>audit.not-written</comment>
        <translation>die Audit-Datei kann nicht geschrieben werden (%1), sodass nicht darin steht, was getan wurde. Schaffen Sie Platz, oder erlauben Sie das Schreiben.</translation>
    </message>
    <message>
        <source>No header tells where the table stood: where the vessels lie in this view is found from its image, only the turn from angles.</source>
        <comment>geometry.table-unknown</comment>
        <translation>Kein Header sagt, wo der Tisch stand: Wo die Gefäße in dieser Ansicht liegen, folgt aus ihrem Bild, nur die Drehung aus den Winkeln.</translation>
    </message>
    <message>
        <source>Only (0018,1111) tells a distance, and it differs between the views (%1, %2): it is no isocenter. The shift between the views is not used; type the distance source to isocenter (SOD) of both.</source>
        <comment>geometry.isocenter-unknown</comment>
        <translation>Nur (0018,1111) nennt einen Abstand, und er ist zwischen den Ansichten verschieden (%1, %2): Er ist kein Isozentrum. Die Verschiebung zwischen den Ansichten wird nicht verwendet; bitte für beide den Abstand Quelle–Isozentrum (SOD) eingeben.</translation>
    </message>
    <message>
        <source>The table moved during one of the runs: the shift between the views counts as unknown (50 mm).</source>
        <comment>geometry.table-moved-in-view</comment>
        <translation>Der Tisch bewegte sich während einer der Serien: Die Verschiebung zwischen den Ansichten gilt als unbekannt (50 mm).</translation>
    </message>
    <message>
        <source>Little was traced here but lines that stand still through the run, as shutter edges, leads and bones do: the frame shows no contrast agent to track.</source>
        <comment>follow.stands-still</comment>
        <translation>Hier wurde kaum etwas gefunden außer Linien, die in der ganzen Serie stillstehen, wie Blendenränder, Kabel und Knochen: das Bild zeigt kein Kontrastmittel, dem zu folgen wäre.</translation>
    </message>
    <message>
        <source>Frame %1 does not exist: the image has frames 1 to %2.</source>
        <comment>frame.missing</comment>
        <translation>Bild %1 gibt es nicht: die Aufnahme hat die Bilder 1 bis %2.</translation>
    </message>
    <message>
        <source>Mask frame %1 does not exist, counted from 1. The run has frames 1 to %2.</source>
        <comment>subtraction.mask-frame-missing</comment>
        <translation>Maskenbild %1 gibt es nicht, von 1 an gezählt. Die Serie hat die Bilder 1 bis %2.</translation>
    </message>
    <message>
        <source>A wide vessel that was not traced runs beside the traced ones for %1, at %2: possibly the false lumen of a dissection. Place a seed in each lumen to trace both.</source>
        <comment>tracing.other-lumen-beside</comment>
        <translation>Neben den erkannten Gefäßen verläuft über %1 ein weites, nicht erkanntes Gefäß, bei %2: möglicherweise das falsche Lumen einer Dissektion. Einen Startpunkt in jedes Lumen setzen, um beide zu erkennen.</translation>
    </message>
    <message>
        <source>%1 does not exist: counted from 0, as in case files, the image has frames 0 to %2.</source>
        <comment>case.frame-missing</comment>
        <translation>%1 gibt es nicht: von 0 an gezählt, wie in Falldateien, hat die Aufnahme die Bilder 0 bis %2.</translation>
    </message>
    <message>
        <source>The image is shown as its orientation tag (%1) states, turned or mirrored from how its pixels are stored.</source>
        <comment>image.turned</comment>
        <translation>Das Bild wird so gezeigt, wie seine Orientierungsangabe (%1) es verlangt: gegenüber den gespeicherten Pixeln gedreht oder gespiegelt.</translation>
    </message>
    <message>
        <source>page %1 has %2 x %3 pixels, the first has %4 x %5. Export the frames of one run, all equally large.</source>
        <comment>image.pages-differ</comment>
        <translation>Seite %1 hat %2 x %3 Pixel, die erste %4 x %5. Exportieren Sie die Bilder einer Serie, alle gleich groß.</translation>
    </message>
    <message>
        <source>it has %1 pages. Export the mask as one image.</source>
        <comment>centreline.mask-pages</comment>
        <translation>sie hat %1 Seiten. Exportieren Sie die Maske als ein einziges Bild.</translation>
    </message>
    <message>
        <source>Frames in the header: %1, in the file: %2. Those in the file are loaded. Copy or export it again where some are missing.</source>
        <comment>dicom.frames-other</comment>
        <translation>Bilder laut Header: %1, in der Datei: %2. Die in der Datei werden geladen. Neu kopieren oder exportieren, falls welche fehlen.</translation>
    </message>
    <message>
        <source>The header contradicts itself about the time between frames: Frame Time %1, Frame Time Vector %2. %3 is used.</source>
        <comment>dicom.frame-times</comment>
        <translation>Der Header widerspricht sich bei der Zeit zwischen Bildern: Frame Time %1, Frame Time Vector %2. Es gilt %3.</translation>
    </message>
    <message>
        <source>a volume made of projections (modality %1)</source>
        <comment>dicom.reconstruction</comment>
        <translation>ein aus Projektionen berechnetes Volumen (Modalität %1)</translation>
    </message>
    <message>
        <source>The header&apos;s %1 shutter (0018,1600) leaves nothing of the image (%2): it is ignored. Check that no shutter edge is traced as a vessel.</source>
        <comment>dicom.shutter-unusable</comment>
        <translation>Die Blende %1 des Headers (0018,1600) lässt vom Bild nichts übrig (%2): sie wird ignoriert. Prüfen, dass kein Blendenrand als Gefäß nachgezeichnet ist.</translation>
    </message>
    <message>
        <source>The image is taken as turned clockwise by %1, after %2. Check that head and left are where they belong.</source>
        <comment>dicom.image-turned</comment>
        <translation>Das Bild gilt als um %1 im Uhrzeigersinn gedreht, nach %2. Bitte prüfen, ob Kopf und links am richtigen Ort sind.</translation>
    </message>
    <message>
        <source>Patient Orientation (0020,0020) says %1, which no image at these angles can be: check the angles, and whether the image is mirrored or turned.</source>
        <comment>dicom.orientation-unlike-angles</comment>
        <translation>Patient Orientation (0020,0020) lautet %1, was bei diesen Winkeln kein Bild sein kann: Bitte die Winkel prüfen, und ob das Bild gespiegelt oder gedreht ist.</translation>
    </message>
    <message>
        <source>The header has the object at %1 from the source, the isocenter at %2: the vessels start at the first, the gantry turns about the second.</source>
        <comment>dicom.object-off-isocenter</comment>
        <translation>Laut Header liegt das Objekt %1 von der Quelle entfernt, das Isozentrum %2: Die Gefäße beginnen im ersten Abstand, der C-Bogen dreht um den zweiten.</translation>
    </message>
    <message>
        <source>The file states its unit (&quot;%1&quot;): one unit is read as %2. Give the unit if that is wrong.</source>
        <comment>vessels.unit-stated</comment>
        <translation>Die Datei nennt ihre Einheit („%1“): eine Einheit wird als %2 gelesen. Geben Sie die Einheit an, falls das nicht stimmt.</translation>
    </message>
    <message>
        <source>The file states its unit (&quot;%1&quot;, which is %2), but one unit is read as %3, as was asked for. Check the size.</source>
        <comment>vessels.unit-overruled</comment>
        <translation>Die Datei nennt ihre Einheit („%1“, also %2), aber eine Einheit wird wie verlangt als %3 gelesen. Prüfen Sie die Größe.</translation>
    </message>
    <message>
        <source>The file states two units (&quot;%1&quot; and &quot;%2&quot;). Check the size, and give the unit if it is wrong.</source>
        <comment>vessels.units-contradict</comment>
        <translation>Die Datei nennt zwei Einheiten („%1“ und „%2“). Prüfen Sie die Größe und geben Sie die Einheit an, falls sie nicht stimmt.</translation>
    </message>
    <message>
        <source>its axes are %1, not LPS or RAS. Export it in patient coordinates (LPS).</source>
        <comment>vessels.axes-other</comment>
        <translation>ihre Achsen sind %1, nicht LPS oder RAS. Exportieren Sie sie in Patientenkoordinaten (LPS).</translation>
    </message>
    <message>
        <source>Lines whose first points stood at the end, moved back to the beginning: %1. Check the vessels.</source>
        <comment>tree.turned-round</comment>
        <translation>Linien, deren erste Punkte am Ende standen und an den Anfang zurückgesetzt wurden: %1. Prüfen Sie die Gefäße.</translation>
    </message>
    <message>
        <source>The lines leap %1 times, by up to %2, over many usual steps: they were cut there. Check the order of the points.</source>
        <comment>tree.leaps</comment>
        <translation>Die Linien springen %1-mal um bis zu %2, weit mehr als ihr üblicher Punktabstand: sie wurden dort getrennt. Prüfen Sie die Reihenfolge der Punkte.</translation>
    </message>
    <message>
        <source>%1 points of the curves are not placed and were left out.</source>
        <comment>tree.markups-not-placed</comment>
        <translation>%1 Punkte der Kurven sind nicht gesetzt und wurden weggelassen.</translation>
    </message>
    <message>
        <source>its header declares %1 triangles, but the file holds %2. Copy or export it again.</source>
        <comment>surface.stl-too-few</comment>
        <translation>ihr Kopf nennt %1 Dreiecke, aber die Datei enthält %2. Kopieren oder exportieren Sie sie erneut.</translation>
    </message>
    <message>
        <source>The header declares %1 triangles, but the file has room for %2: what is behind those declared was not read. Check that nothing is missing.</source>
        <comment>surface.stl-too-many</comment>
        <translation>Der Kopf nennt %1 Dreiecke, aber die Datei hat Platz für %2: was hinter den genannten steht, wurde nicht gelesen. Prüfen Sie, ob etwas fehlt.</translation>
    </message>
    <message>
        <source>The text ends after %1 triangles without &quot;endsolid&quot;: it may be cut short. Check that nothing is missing.</source>
        <comment>surface.stl-without-end</comment>
        <translation>Der Text endet nach %1 Dreiecken ohne „endsolid“: er ist vielleicht abgeschnitten. Prüfen Sie, ob etwas fehlt.</translation>
    </message>
    <message>
        <source>its coordinates are in &quot;%1&quot;, which is no unit of length known here. Export them in mm.</source>
        <comment>tree.markups-unit</comment>
        <translation>ihre Koordinaten sind in „%1“, einer hier unbekannten Längeneinheit. Exportieren Sie sie in mm.</translation>
    </message>
    <message>
        <source>The header contradicts itself: slices %1 apart (Spacing Between Slices), %2 by their positions. The positions are used.</source>
        <comment>series.step</comment>
        <translation>Der Header widerspricht sich: Schichtabstand %1 (Spacing Between Slices), nach den Positionen %2. Die Positionen gelten.</translation>
    </message>
    <message>
        <source>part %1 of %2 (acquisition %3)</source>
        <comment>series.acquisition</comment>
        <translation>Teil %1 von %2 (Akquisition %3)</translation>
    </message>
    <message>
        <source>%1 of %2 images of the series share a SOP Instance UID although they differ: all of them are read. Export the series again before you archive it.</source>
        <comment>series.same-uid</comment>
        <translation>%1 von %2 Bildern der Serie teilen sich eine SOP Instance UID, obwohl sie verschieden sind: Alle werden gelesen. Vor dem Archivieren die Serie neu exportieren.</translation>
    </message>
    <message>
        <source>%1 patients or studies share the UID of this series; each is listed by itself.</source>
        <comment>series.of-several</comment>
        <translation>%1 Patienten oder Studien teilen sich die UID dieser Serie; jede ist einzeln aufgeführt.</translation>
    </message>
    <message>
        <source>The header gives lengths in &quot;%1&quot;, which is not a known unit: millimeters are assumed. Check the voxel size.</source>
        <comment>volume.unit-unknown</comment>
        <translation>Der Header gibt Längen in „%1“ an, einer unbekannten Einheit: Millimeter werden angenommen. Voxelgröße prüfen.</translation>
    </message>
    <message>
        <source>Its two placements (qform and sform) differ by up to %1; the qform, in the scanner&apos;s coordinates, is used.</source>
        <comment>volume.nifti-qform-used</comment>
        <translation>Ihre zwei Lageangaben (qform und sform) weichen um bis zu %1 ab; die qform in Gerätekoordinaten gilt.</translation>
    </message>
    <message>
        <source>Its two placements (qform and sform) differ by up to %1; the sform is used.</source>
        <comment>volume.nifti-sform-used</comment>
        <translation>Ihre zwei Lageangaben (qform und sform) weichen um bis zu %1 ab; die sform gilt.</translation>
    </message>
    <message>
        <source>The header contradicts itself about the voxel size: %1 (pixdim), %2 by its placement. The placement is used. Check which is right.</source>
        <comment>volume.nifti-sizes</comment>
        <translation>Der Header widerspricht sich bei der Voxelgröße: %1 (pixdim), %2 nach der Lageangabe. Die Lageangabe gilt. Prüfen, was stimmt.</translation>
    </message>
    <message>
        <source>The header contradicts itself about the voxel type: %1 bits (bitpix), but %2 bits by its datatype (%3), which is used.</source>
        <comment>volume.nifti-bits</comment>
        <translation>Der Header widerspricht sich beim Voxeltyp: %1 Bit (bitpix), aber %2 Bit nach dem Datentyp (%3), der gilt.</translation>
    </message>
    <message>
        <source>The header says that the voxels begin at byte %1, which is inside the header: they are read from byte %2.</source>
        <comment>volume.nifti-start-within-header</comment>
        <translation>Laut Header beginnen die Voxel bei Byte %1, also innerhalb des Headers: Sie werden ab Byte %2 gelesen.</translation>
    </message>
    <message>
        <source>a voxel size of %1 mm cannot be written. Correct the spacing, origin and directions of the volume.</source>
        <comment>volume.no-size-to-write</comment>
        <translation>eine Voxelgröße von %1 mm lässt sich nicht schreiben. Abstand, Ursprung und Richtungen des Volumens berichtigen.</translation>
    </message>
    <message>
        <source>frame %1 does not exist, counted from 1. It has frames 1 to %2.</source>
        <comment>command.frame-beyond-run</comment>
        <translation>Bild %1 gibt es nicht, von 1 an gezählt. Die Aufnahme hat die Bilder 1 bis %2.</translation>
    </message>
    <message>
        <source>NOT RELIABLE</source>
        <comment>fit.not-reliable</comment>
        <translation>NICHT VERLÄSSLICH</translation>
    </message>
    <message>
        <source>These distances are over the %1 of the tree judged opacified. Whole tree: median %2, 95th percentile %3.</source>
        <comment>fit.over-opacified</comment>
        <translation>Diese Abstände gelten für die %1 des Gefäßbaums, die als kontrastiert gelten. Ganzer Gefäßbaum: Median %2, 95. Perzentil %3.</translation>
    </message>
    <message>
        <source>Excluded branches: %1 (medians). With them: median %2, 95th percentile %3.</source>
        <comment>fit.without-excluded</comment>
        <translation>Ausgeschlossene Äste: %1 (Mediane). Mit ihnen: Median %2, 95. Perzentil %3.</translation>
    </message>
    <message>
        <source>Auxiliary branches: %1 (medians).</source>
        <comment>fit.auxiliary</comment>
        <translation>Hilfsäste: %1 (Mediane).</translation>
    </message>
    <message>
        <source>at this pose all vessels lie at or behind the X-ray source, where nothing projects. Check the pose and its direction: camera from patient.</source>
        <comment>pose.all-behind-source</comment>
        <translation>in dieser Lage liegen alle Gefäße an oder hinter der Röntgenquelle, wo nichts abgebildet wird. Lage und ihre Richtung prüfen: Kamera aus Patient.</translation>
    </message>
    <message>
        <source>At this pose no vessel lies inside the image. Check the pose.</source>
        <comment>pose.all-outside-image</comment>
        <translation>In dieser Lage liegt kein Gefäß im Bild. Lage prüfen.</translation>
    </message>
    <message>
        <source>frame %1 of %2</source>
        <comment>picture.frame</comment>
        <translation>Bild %1 von %2</translation>
    </message>
    <message>
        <source>There are no frames %1 to %2 in that order: the run has frames 1 to %3. Choose others.</source>
        <comment>movie.frames-beyond</comment>
        <translation>Die Bilder %1 bis %2 gibt es in dieser Reihenfolge nicht: die Serie hat die Bilder 1 bis %3. Andere wählen.</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Finds the pose of a 3-D vessel tree in a 2-D angiogram. Not for clinical use.</source>
        <translation>Findet die Lage eines 3-D-Gefäßbaums in einem 2-D-Angiogramm. Nicht für den klinischen Einsatz.</translation>
    </message>
    <message>
        <source>A case, or a centreline and an angiogram.</source>
        <translation>Ein Fall, oder eine Mittellinie und ein Angiogramm.</translation>
    </message>
    <message>
        <source>Who draws the angiogram: vtk (OpenGL), painter (the processor), or auto: vtk where a graphics card does OpenGL.</source>
        <translation>Wer das Angiogramm zeichnet: vtk (OpenGL), painter (der Prozessor) oder auto: vtk, wo eine Grafikkarte OpenGL rechnet.</translation>
    </message>
    <message>
        <source>No renderer is called “%1”: auto, vtk or painter.</source>
        <translation>Kein Renderer heißt „%1“: auto, vtk oder painter.</translation>
    </message>
    <message>
        <source>There is no display to show the window on. angiopose-cli does the same work without one.</source>
        <translation>Es gibt keine Anzeige, auf der das Fenster erscheinen kann. angiopose-cli leistet dasselbe ohne.</translation>
    </message>
    <message>
        <source>Write the report of a case, .pdf or .html, and end; needs no display.</source>
        <translation>Den Bericht eines Falls schreiben, .pdf oder .html, und enden; braucht keinen Bildschirm.</translation>
    </message>
    <message>
        <source>Beside --report: register the case first.</source>
        <translation>Neben --report: den Fall zuerst registrieren.</translation>
    </message>
    <message>
        <source>Beside --report: the page to fill in, in place of the built-in one.</source>
        <translation>Neben --report: die auszufüllende Seite anstelle der eingebauten.</translation>
    </message>
    <message>
        <source>Beside --report: who makes it, in place of the account&apos;s name.</source>
        <translation>Neben --report: wer ihn macht, anstelle des Benutzernamens.</translation>
    </message>
    <message>
        <source>Beside --report: name the patient, which is left out else.</source>
        <translation>Neben --report: den Patienten nennen, der sonst wegbleibt.</translation>
    </message>
    <message>
        <source>Beside --report: its language, in place of the window&apos;s.</source>
        <translation>Neben --report: seine Sprache anstelle der des Fensters.</translation>
    </message>
    <message>
        <source>A report is written in %1, not in “%2”.</source>
        <translation>Ein Bericht wird in %1 geschrieben, nicht in „%2“.</translation>
    </message>
    <message>
        <source>--register, --template, --author, --identity and --language go beside --report FILE alone.</source>
        <translation>--register, --template, --author, --identity und --language gibt es nur neben --report FILE.</translation>
    </message>
    <message>
        <source>A report is written as .pdf or .html, not as “%1”.</source>
        <translation>Ein Bericht wird als .pdf oder .html geschrieben, nicht als „%1“.</translation>
    </message>
    <message>
        <source>A report is of one case: angiopose --report FILE CASE</source>
        <translation>Ein Bericht ist von einem Fall: angiopose --report FILE CASE</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::AngiogramAnnotations</name>
    <message>
        <source>%1 mm at vessel</source>
        <translation>%1 mm am Gefäß</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::AngiogramPanel</name>
    <message>
        <source>%1 frames before each</source>
        <translation>%1 Bilder vor jedem</translation>
    </message>
    <message>
        <source>none found: mark them below</source>
        <translation>keine gefunden: unten markieren</translation>
    </message>
    <message>
        <source>%1 (automatic)</source>
        <translation>%1 (automatisch)</translation>
    </message>
    <message>
        <source>Angiogram</source>
        <translation>Angiogramm</translation>
    </message>
    <message>
        <source>Whole run in one picture</source>
        <translation>Ganze Serie in einem Bild</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Choose the frames before the contrast medium arrives</source>
        <translation>Die Bilder vor Ankunft des Kontrastmittels wählen</translation>
    </message>
    <message>
        <source>Find the shift of each frame</source>
        <translation>Die Verschiebung jedes Bildes finden</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>Vorgaben</translation>
    </message>
    <message>
        <source>Trace as the program would by itself</source>
        <translation>Erfassen, wie das Programm es von selbst täte</translation>
    </message>
    <message>
        <source>Subtract mask</source>
        <translation>Maske abziehen</translation>
    </message>
    <message>
        <source>Show native frames</source>
        <translation>Native Bilder zeigen</translation>
    </message>
    <message>
        <source>One frame at a time</source>
        <translation>Ein Bild nach dem anderen</translation>
    </message>
    <message>
        <source>Choose mask frames automatically</source>
        <translation>Maskenbilder automatisch wählen</translation>
    </message>
    <message>
        <source>Find the mask&apos;s shift</source>
        <translation>Verschiebung der Maske finden</translation>
    </message>
    <message>
        <source>Mask shift to the right</source>
        <translation>Maskenverschiebung nach rechts</translation>
    </message>
    <message>
        <source>Mask shift down</source>
        <translation>Maskenverschiebung nach unten</translation>
    </message>
    <message>
        <source>How far the mask moves to the right, px</source>
        <translation>Wie weit die Maske nach rechts rückt, px</translation>
    </message>
    <message>
        <source>How far the mask moves down, px</source>
        <translation>Wie weit die Maske nach unten rückt, px</translation>
    </message>
    <message>
        <source>mask frames</source>
        <translation>Maskenbilder</translation>
    </message>
    <message>
        <source>shift →  ↓</source>
        <translation>Versatz →  ↓</translation>
    </message>
    <message>
        <source>Move the mask</source>
        <translation>Maske verschieben</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>logarithmic</source>
        <translation>logarithmisch</translation>
    </message>
    <message>
        <source>How stored values relate to the X-ray intensity (0028,1040)</source>
        <translation>Wie gespeicherte Werte zur Röntgenintensität stehen (0028,1040)</translation>
    </message>
    <message>
        <source>Pixel values</source>
        <translation>Pixelwerte</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>dunkel</translation>
    </message>
    <message>
        <source>bright</source>
        <translation>hell</translation>
    </message>
    <message>
        <source>Whether contrast medium is darker or brighter than the background</source>
        <translation>Ob Kontrastmittel dunkler oder heller als der Hintergrund ist</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>Gefäße</translation>
    </message>
    <message>
        <source>Change the meaning of pixel values</source>
        <translation>Bedeutung der Pixelwerte ändern</translation>
    </message>
    <message>
        <source>Vessels are dark</source>
        <translation>Gefäße sind dunkel</translation>
    </message>
    <message>
        <source>Vessels are bright</source>
        <translation>Gefäße sind hell</translation>
    </message>
    <message>
        <source>pixel values</source>
        <translation>Pixelwerte</translation>
    </message>
    <message>
        <source>vessels</source>
        <translation>Gefäße</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>shortest vessel</source>
        <translation>kürzestes Gefäß</translation>
    </message>
    <message>
        <source>Isolated pieces shorter than this are left out; spurs shorter than a third of it too</source>
        <translation>Kürzere Einzelstücke entfallen; Sporne unter einem Drittel davon auch</translation>
    </message>
    <message>
        <source>sensitivity</source>
        <translation>Empfindlichkeit</translation>
    </message>
    <message>
        <source>Above 1: fainter vessels are traced as well</source>
        <translation>Über 1: auch schwächere Gefäße werden erfasst</translation>
    </message>
    <message>
        <source>widest radius</source>
        <translation>größter Radius</translation>
    </message>
    <message>
        <source>Radius of the widest vessel looked for</source>
        <translation>Radius des weitesten gesuchten Gefäßes</translation>
    </message>
    <message>
        <source>Default tracing</source>
        <translation>Vorgabe der Erkennung</translation>
    </message>
    <message>
        <source>Tracing</source>
        <translation>Erkennung</translation>
    </message>
    <message>
        <source>subtracting …</source>
        <translation>subtrahiert …</translation>
    </message>
    <message>
        <source>subtracted</source>
        <translation>subtrahiert</translation>
    </message>
    <message>
        <source>composite</source>
        <translation>Gesamtbild</translation>
    </message>
    <message>
        <source>native</source>
        <translation>nativ</translation>
    </message>
    <message>
        <source>Move the mask with arrows or the mouse</source>
        <translation>Maske mit Pfeilen oder Maus verschieben</translation>
    </message>
    <message>
        <source>Take away what the mask frames show as well: bones and organs</source>
        <translation>Wegnehmen, was auch die Maskenbilder zeigen: Knochen und Organe</translation>
    </message>
    <message>
        <source>Every frame shows the darkest value of each pixel over the run</source>
        <translation>Jedes Bild zeigt den dunkelsten Wert jedes Pixels der Serie</translation>
    </message>
    <message>
        <source>Edit vessels</source>
        <translation>Gefäße bearbeiten</translation>
    </message>
    <message>
        <source>Leave out, erase, draw and cut traced curves</source>
        <translation>Erkannte Kurven weglassen, radieren, zeichnen, trennen</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Window W: how many grey values lie between black and white</source>
        <translation>Fenster W: wie viele Grauwerte zwischen Schwarz und Weiß liegen</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Zentrum</translation>
    </message>
    <message>
        <source>Level L: the grey value in the middle of them</source>
        <translation>Zentrum L: der Grauwert in der Mitte davon</translation>
    </message>
    <message>
        <source>window, level</source>
        <translation>Fenster, Zentrum</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::AngiogramView</name>
    <message>
        <source>Angiogram with the projected vessel tree</source>
        <translation>Angiogramm mit projiziertem Gefäßbaum</translation>
    </message>
    <message>
        <source>Mirrored image, mirrored back by the view</source>
        <translation>Gespiegeltes Bild, von der Ansicht zurückgespiegelt</translation>
    </message>
    <message>
        <source>Seen from the source: the view is mirrored</source>
        <translation>Vom Fokus gesehen: die Ansicht ist gespiegelt</translation>
    </message>
    <message>
        <source>Mirrored image: as seen from the source</source>
        <translation>Gespiegeltes Bild: wie vom Fokus gesehen</translation>
    </message>
    <message>
        <source>flicker %1 · swipe %2 · hide H · outline %3</source>
        <translation>Blinken %1 · Wischen %2 · Verbergen H · Umriss %3</translation>
    </message>
    <message>
        <source>No angiogram yet: drop one here, or open it (%1).</source>
        <translation>Noch kein Angiogramm: hier eines ablegen oder öffnen (%1).</translation>
    </message>
    <message>
        <source>frame %1 of %2</source>
        <translation>Bild %1 von %2</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::AuxiliaryDialog</name>
    <message>
        <source>Use %1 instead</source>
        <translation>Stattdessen %1</translation>
    </message>
    <message>
        <source>Its search alternates between the chosen branches and the whole tree.</source>
        <translation>Die Suche wechselt zwischen den gewählten Ästen und dem ganzen Baum.</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Up to generation</source>
        <translation>Bis Generation</translation>
    </message>
    <message>
        <source>Generation 0 begins at the root of the tree.</source>
        <translation>Generation 0 beginnt an der Wurzel.</translation>
    </message>
    <message>
        <source>At least this wide</source>
        <translation>Mindestens so weit</translation>
    </message>
    <message>
        <source>By the median radius of a branch.</source>
        <translation>Nach dem mittleren Radius des Astes (Median).</translation>
    </message>
    <message>
        <source>Choose these</source>
        <translation>Diese wählen</translation>
    </message>
    <message>
        <source>Makes the suggested branches the auxiliary ones.</source>
        <translation>Macht die vorgeschlagenen Äste zu Hilfsästen.</translation>
    </message>
    <message>
        <source>Auxiliary branches</source>
        <translation>Hilfsäste</translation>
    </message>
    <message>
        <source>The alternating methods solve for these branches first, so choose what is filled, still and told apart well. One image tells a branch only across its course: which ones pin which step of the pose is computed here for the pose as it is.</source>
        <translation>Wechselnde Methoden lösen zuerst für diese Äste: wählen, was gefüllt, ruhig und gut unterscheidbar ist. Ein Bild bestimmt einen Ast nur quer zu seinem Verlauf: welche Äste welchen Freiheitsgrad festlegen, ist hier für die jetzige Lage berechnet.</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>all branches</source>
        <translation>alle Äste</translation>
    </message>
    <message>
        <source>the chosen</source>
        <translation>die gewählten</translation>
    </message>
    <message>
        <source>pinned best by</source>
        <translation>am besten durch</translation>
    </message>
    <message>
        <source>± is one standard deviation expected of traced vessels with usual noise.</source>
        <translation>± ist eine Standardabweichung, wie bei üblichem Rauschen zu erwarten.</translation>
    </message>
    <message>
        <source>Last generation</source>
        <translation>Letzte Generation</translation>
    </message>
    <message>
        <source>Smallest radius</source>
        <translation>Kleinster Radius</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Without chosen branches the nodes of the tree are used.</source>
        <translation>Ohne gewählte Äste gelten die Knoten des Gefäßbaums.</translation>
    </message>
    <message>
        <source>Vessels, camera and pose are needed for a suggestion.</source>
        <translation>Für einen Vorschlag sind Gefäße, Kamera und Lage nötig.</translation>
    </message>
    <message>
        <source>Suggested: %1. They tell nearly as much as all together.</source>
        <translation>Vorschlag: %1. Sie verraten fast so viel wie alle zusammen.</translation>
    </message>
    <message>
        <source>This tree knows no generations.</source>
        <translation>Dieser Gefäßbaum kennt keine Generationen.</translation>
    </message>
    <message>
        <source>This tree knows no radii.</source>
        <translation>Dieser Gefäßbaum kennt keine Radien.</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Draw around the branches on the image.</source>
        <translation>Die Äste im Bild umfahren.</translation>
    </message>
    <message>
        <source>In view</source>
        <translation>Im Blick</translation>
    </message>
    <message>
        <source>The branches that lie wholly in the view.</source>
        <translation>Die Äste, die ganz im Blickfeld liegen.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::BlindTrialDialog</name>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Start shifted by up to</source>
        <translation>Start verschoben bis</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Start turned by up to</source>
        <translation>Start gedreht bis</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Start trial</source>
        <translation>Versuch beginnen</translation>
    </message>
    <message>
        <source>Blind observer trial</source>
        <translation>Blinder Beobachterversuch</translation>
    </message>
    <message>
        <source>The vessels start at random around the pose as it is. Until Done all numbers, residual colours and earlier poses are out of sight; time and final pose go to the log, and the case stays as it is.</source>
        <translation>Die Gefäße beginnen zufällig um die jetzige Lage. Bis „Fertig“ sind alle Zahlen, Abweichungsfarben und früheren Lagen verborgen; Zeit und Endlage kommen ins Protokoll, der Fall bleibt, wie er ist.</translation>
    </message>
    <message>
        <source>Observer</source>
        <translation>Beobachter</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Log of the trials</source>
        <translation>Protokoll der Versuche</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Observer and log are needed.</source>
        <translation>Beobachter und Protokoll sind nötig.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::BottomStrip</name>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Stop the running task</source>
        <translation>Laufende Aufgabe anhalten</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::BranchDelegate</name>
    <message>
        <source>aux</source>
        <translation>Hilfs</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>out</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>g%1</source>
        <translation>G%1</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>verborgen</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::BranchModel</name>
    <message>
        <source>%1, %2 mm long</source>
        <translation>%1, %2 mm lang</translation>
    </message>
    <message>
        <source>in the auxiliary set</source>
        <translation>in der Hilfsmenge</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>ausgeschlossen</translation>
    </message>
    <message>
        <source>median residual %1 mm</source>
        <translation>mittlere Abweichung %1 mm</translation>
    </message>
    <message>
        <source>radius %1 mm</source>
        <translation>Radius %1 mm</translation>
    </message>
    <message>
        <source>generation %1</source>
        <translation>Generation %1</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>verborgen</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::BranchPanel</name>
    <message>
        <source>Branches</source>
        <translation>Äste</translation>
    </message>
    <message>
        <source>Only these auxiliary</source>
        <translation>Nur diese als Hilfsäste</translation>
    </message>
    <message>
        <source>No auxiliary branches (use the nodes)</source>
        <translation>Keine Hilfsäste (Knoten verwenden)</translation>
    </message>
    <message>
        <source>as in the tree</source>
        <translation>wie im Gefäßbaum</translation>
    </message>
    <message>
        <source>by name</source>
        <translation>nach Name</translation>
    </message>
    <message>
        <source>by length</source>
        <translation>nach Länge</translation>
    </message>
    <message>
        <source>by radius</source>
        <translation>nach Radius</translation>
    </message>
    <message>
        <source>by generation</source>
        <translation>nach Generation</translation>
    </message>
    <message>
        <source>by residual</source>
        <translation>nach Abweichung</translation>
    </message>
    <message>
        <source>Find a branch</source>
        <translation>Ast suchen</translation>
    </message>
    <message>
        <source>Order of the branches</source>
        <translation>Reihenfolge der Äste</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Selects both branches and moves the cross-hair to the gap.</source>
        <translation>Wählt beide Äste und setzt das Fadenkreuz an die Lücke.</translation>
    </message>
    <message>
        <source>Generation</source>
        <translation>Generation</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>No vessels yet. Open a CT scan, a mask of vessels or a centreline.</source>
        <translation>Noch keine Gefäße. Ein CT, eine Gefäßmaske oder eine Mittellinie öffnen.</translation>
    </message>
    <message>
        <source>Closes the gap; undo opens it again.</source>
        <translation>Schließt die Lücke; Rückgängig öffnet sie wieder.</translation>
    </message>
    <message>
        <source>%1 auxiliary · %2 exclude</source>
        <translation>%1 Hilfsast · %2 ausschließen</translation>
    </message>
    <message>
        <source>Auxiliary on or off</source>
        <translation>Hilfsast an oder aus</translation>
    </message>
    <message>
        <source>Exclude or include</source>
        <translation>Ausschließen oder einbeziehen</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::CommandTable</name>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Pack case for others …</source>
        <translation>Fall für andere packen …</translation>
    </message>
    <message>
        <source>Export DICOM objects …</source>
        <translation>DICOM-Objekte exportieren …</translation>
    </message>
    <message>
        <source>Play slower</source>
        <translation>Langsamer abspielen</translation>
    </message>
    <message>
        <source>Play faster</source>
        <translation>Schneller abspielen</translation>
    </message>
    <message>
        <source>Play back and forth</source>
        <translation>Hin und her abspielen</translation>
    </message>
    <message>
        <source>Play from this frame on</source>
        <translation>Ab diesem Bild abspielen</translation>
    </message>
    <message>
        <source>Play up to this frame</source>
        <translation>Bis zu diesem Bild abspielen</translation>
    </message>
    <message>
        <source>Play the whole run</source>
        <translation>Die ganze Serie abspielen</translation>
    </message>
    <message>
        <source>Views side by side</source>
        <translation>Ansichten nebeneinander</translation>
    </message>
    <message>
        <source>Cross-hair through views side by side</source>
        <translation>Fadenkreuz durch Ansichten nebeneinander</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Close case</source>
        <translation>Fall schließen</translation>
    </message>
    <message>
        <source>New window</source>
        <translation>Neues Fenster</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Open folder or disc …</source>
        <translation>Ordner oder CD öffnen …</translation>
    </message>
    <message>
        <source>Open sample case</source>
        <translation>Beispielfall öffnen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save as …</source>
        <translation>Speichern unter …</translation>
    </message>
    <message>
        <source>Export overlay …</source>
        <translation>Überlagerung exportieren …</translation>
    </message>
    <message>
        <source>Export result …</source>
        <translation>Ergebnis exportieren …</translation>
    </message>
    <message>
        <source>Export pose …</source>
        <translation>Lage exportieren …</translation>
    </message>
    <message>
        <source>Export traced vessels …</source>
        <translation>Erkannte Gefäße exportieren …</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Nudge mode</source>
        <translation>Justiermodus</translation>
    </message>
    <message>
        <source>Back to start pose</source>
        <translation>Zurück zur Startlage</translation>
    </message>
    <message>
        <source>Copy pose as matrix</source>
        <translation>Lage als Matrix kopieren</translation>
    </message>
    <message>
        <source>Selected branches auxiliary on or off</source>
        <translation>Gewählte Äste als Hilfsäste an oder aus</translation>
    </message>
    <message>
        <source>Auxiliary: the branches in view</source>
        <translation>Hilfsäste: die im Blickfeld</translation>
    </message>
    <message>
        <source>Auxiliary: the wider half</source>
        <translation>Hilfsäste: die weitere Hälfte</translation>
    </message>
    <message>
        <source>Exclude or include selected branches</source>
        <translation>Gewählte Äste aus- oder einschließen</translation>
    </message>
    <message>
        <source>Select all branches</source>
        <translation>Alle Äste wählen</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Registrieren</translation>
    </message>
    <message>
        <source>Stop and keep the best pose</source>
        <translation>Anhalten und beste Lage behalten</translation>
    </message>
    <message>
        <source>Fit the image to the window</source>
        <translation>Bild in das Fenster einpassen</translation>
    </message>
    <message>
        <source>Automatic brightness</source>
        <translation>Automatische Fensterung</translation>
    </message>
    <message>
        <source>Invert grey values</source>
        <translation>Grauwerte umkehren</translation>
    </message>
    <message>
        <source>Brightness: every grey value</source>
        <translation>Fensterung: alle Grauwerte</translation>
    </message>
    <message>
        <source>More contrast</source>
        <translation>Mehr Kontrast</translation>
    </message>
    <message>
        <source>Less contrast</source>
        <translation>Weniger Kontrast</translation>
    </message>
    <message>
        <source>Near vessels bright, far ones dim</source>
        <translation>Nahe Gefäße hell, ferne dunkel</translation>
    </message>
    <message>
        <source>Swipe, lens, off</source>
        <translation>Wischen, Lupe, aus</translation>
    </message>
    <message>
        <source>Zoom to the worst branch, the next</source>
        <translation>Zum schlechtesten Ast zoomen, zum nächsten</translation>
    </message>
    <message>
        <source>Show traced vessels</source>
        <translation>Erkannte Gefäße zeigen</translation>
    </message>
    <message>
        <source>Flicker start pose and pose</source>
        <translation>Startlage und Lage im Wechsel</translation>
    </message>
    <message>
        <source>Colours: how far bent vessels moved</source>
        <translation>Farben: wie weit gebogene Gefäße sich bewegten</translation>
    </message>
    <message>
        <source>Vessels bent, where that is known, or rigid</source>
        <translation>Gefäße gebogen, wo bekannt, oder starr</translation>
    </message>
    <message>
        <source>Replay the last run</source>
        <translation>Letzten Lauf wiedergeben</translation>
    </message>
    <message>
        <source>Swing along what the image cannot tell</source>
        <translation>Schwingen, wo das Bild nichts verrät</translation>
    </message>
    <message>
        <source>Show the run&apos;s other solutions</source>
        <translation>Andere Lösungen des Laufs zeigen</translation>
    </message>
    <message>
        <source>Take the solution shown</source>
        <translation>Gezeigte Lösung übernehmen</translation>
    </message>
    <message>
        <source>Overlay fainter</source>
        <translation>Überlagerung schwächer</translation>
    </message>
    <message>
        <source>Overlay stronger</source>
        <translation>Überlagerung stärker</translation>
    </message>
    <message>
        <source>Play frames</source>
        <translation>Bilder abspielen</translation>
    </message>
    <message>
        <source>Hide patient identity</source>
        <translation>Patientendaten verbergen</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Vollbild</translation>
    </message>
    <message>
        <source>Reduce motion</source>
        <translation>Bewegung verringern</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Wie der Desktop</translation>
    </message>
    <message>
        <source>About AngioPose</source>
        <translation>Über AngioPose</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Registration</source>
        <translation>&amp;Registrierung</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>Language of the desktop</source>
        <translation>Sprache des Desktops</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Save picture of the window …</source>
        <translation>Bild des Fensters speichern …</translation>
    </message>
    <message>
        <source>Copy picture of the window</source>
        <translation>Bild des Fensters kopieren</translation>
    </message>
    <message>
        <source>Radiology: left drag windows</source>
        <translation>Radiologie: links ziehen fenstert</translation>
    </message>
    <message>
        <source>3D Slicer: left only picks</source>
        <translation>3D Slicer: links wählt nur</translation>
    </message>
    <message>
        <source>Scroll: left drag runs the frames</source>
        <translation>Blättern: links ziehen wechselt Bilder</translation>
    </message>
    <message>
        <source>Help on what the mouse points at</source>
        <translation>Hilfe zu dem, worauf die Maus zeigt</translation>
    </message>
    <message>
        <source>Short tour</source>
        <translation>Kurzer Rundgang</translation>
    </message>
    <message>
        <source>What a good fit looks like</source>
        <translation>Wie eine gute Einpassung aussieht</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>Edit traced vessels</source>
        <translation>Erkannte Gefäße bearbeiten</translation>
    </message>
    <message>
        <source>Trace this frame again</source>
        <translation>Dieses Bild neu erfassen</translation>
    </message>
    <message>
        <source>Subtract mask, native</source>
        <translation>Maske abziehen, nativ</translation>
    </message>
    <message>
        <source>Move the mask by hand</source>
        <translation>Maske von Hand verschieben</translation>
    </message>
    <message>
        <source>This frame is the mask</source>
        <translation>Dieses Bild ist die Maske</translation>
    </message>
    <message>
        <source>Whole run in one picture</source>
        <translation>Ganze Serie in einem Bild</translation>
    </message>
    <message>
        <source>Click pairs of landmarks</source>
        <translation>Landmarkenpaare klicken</translation>
    </message>
    <message>
        <source>Place vessels by landmarks</source>
        <translation>Gefäße nach Landmarken legen</translation>
    </message>
    <message>
        <source>Auxiliary: draw a lasso</source>
        <translation>Hilfsäste: Lasso ziehen</translation>
    </message>
    <message>
        <source>Auxiliary: which branches …</source>
        <translation>Hilfsäste: welche Äste …</translation>
    </message>
    <message>
        <source>C-arm angles for the branch …</source>
        <translation>C-Bogen-Winkel für den Ast …</translation>
    </message>
    <message>
        <source>Trace the scan again</source>
        <translation>CT neu erfassen</translation>
    </message>
    <message>
        <source>Find a branch</source>
        <translation>Ast suchen</translation>
    </message>
    <message>
        <source>Rename branch</source>
        <translation>Ast umbenennen</translation>
    </message>
    <message>
        <source>Cut branch at the cross-hair</source>
        <translation>Ast am Fadenkreuz trennen</translation>
    </message>
    <message>
        <source>Join two branches</source>
        <translation>Zwei Äste verbinden</translation>
    </message>
    <message>
        <source>Smooth branches</source>
        <translation>Äste glätten</translation>
    </message>
    <message>
        <source>Root at the branch&apos;s end near the cross-hair</source>
        <translation>Wurzel am Astende beim Fadenkreuz</translation>
    </message>
    <message>
        <source>Hide or show branches</source>
        <translation>Äste verbergen oder zeigen</translation>
    </message>
    <message>
        <source>Show all branches</source>
        <translation>Alle Äste zeigen</translation>
    </message>
    <message>
        <source>Delete branches</source>
        <translation>Äste löschen</translation>
    </message>
    <message>
        <source>Delete branches and what leaves them</source>
        <translation>Äste und ihre Abgänge löschen</translation>
    </message>
    <message>
        <source>Prune short or thin branches …</source>
        <translation>Kurze oder dünne Äste ausdünnen …</translation>
    </message>
    <message>
        <source>Join the pieces at the next gap</source>
        <translation>Stücke an der nächsten Lücke verbinden</translation>
    </message>
    <message>
        <source>Keep this pose</source>
        <translation>Diese Lage behalten</translation>
    </message>
    <message>
        <source>Switch between poses A and B</source>
        <translation>Zwischen Lage A und B wechseln</translation>
    </message>
    <message>
        <source>Compare poses and methods …</source>
        <translation>Lagen und Methoden vergleichen …</translation>
    </message>
    <message>
        <source>Blind observer trial …</source>
        <translation>Blinder Beobachterversuch …</translation>
    </message>
    <message>
        <source>Trial done</source>
        <translation>Versuch fertig</translation>
    </message>
    <message>
        <source>Seen from the source (mirrored)</source>
        <translation>Vom Fokus gesehen (gespiegelt)</translation>
    </message>
    <message>
        <source>Opacification over time</source>
        <translation>Kontrastfüllung über die Zeit</translation>
    </message>
    <message>
        <source>3-D, axial, coronal, sagittal below the branches</source>
        <translation>3-D, axial, koronar, sagittal unter den Ästen</translation>
    </message>
    <message>
        <source>Slices instead of the angiogram</source>
        <translation>Schichten statt Angiogramm</translation>
    </message>
    <message>
        <source>Image alone, without the columns</source>
        <translation>Bild allein, ohne die Spalten</translation>
    </message>
    <message>
        <source>Ve&amp;ssels</source>
        <translation>&amp;Gefäße</translation>
    </message>
    <message>
        <source>Start pose from the angles</source>
        <translation>Startlage aus den Winkeln</translation>
    </message>
    <message>
        <source>This pose is the start pose</source>
        <translation>Diese Lage ist die Startlage</translation>
    </message>
    <message>
        <source>&amp;Angiogram</source>
        <translation>A&amp;ngiogramm</translation>
    </message>
    <message>
        <source>&amp;Pose</source>
        <translation>&amp;Lage</translation>
    </message>
    <message>
        <source>3-D and slices alone</source>
        <translation>3-D und Schichten allein</translation>
    </message>
    <message>
        <source>Angiogram in a window of its own</source>
        <translation>Angiogramm in eigenem Fenster</translation>
    </message>
    <message>
        <source>3-D and slices in a window of their own</source>
        <translation>3-D und Schichten in eigenem Fenster</translation>
    </message>
    <message>
        <source>All slices in a window of their own</source>
        <translation>Alle Schichten in eigenem Fenster</translation>
    </message>
    <message>
        <source>Views alone and in windows</source>
        <translation>Ansichten allein und in Fenstern</translation>
    </message>
    <message>
        <source>Export followed poses …</source>
        <translation>Verfolgte Lagen exportieren …</translation>
    </message>
    <message>
        <source>Add a view …</source>
        <translation>Ansicht hinzufügen …</translation>
    </message>
    <message>
        <source>Show the next view</source>
        <translation>Nächste Ansicht zeigen</translation>
    </message>
    <message>
        <source>Follow the vessels through the run</source>
        <translation>Gefäße durch die Serie verfolgen</translation>
    </message>
    <message>
        <source>Vessels: centreline, outline, tube, radiograph</source>
        <translation>Gefäße: Mittellinie, Umriss, Röhre, Röntgenbild</translation>
    </message>
    <message>
        <source>Brightness: the vessels alone</source>
        <translation>Helligkeit: nur die Gefäße</translation>
    </message>
    <message>
        <source>Brightness: soft, with bone and catheter</source>
        <translation>Helligkeit: weich, mit Knochen und Katheter</translation>
    </message>
    <message>
        <source>Blue to amber</source>
        <translation>Blau bis Bernstein</translation>
    </message>
    <message>
        <source>Blue, white, red</source>
        <translation>Blau, weiß, rot</translation>
    </message>
    <message>
        <source>Brightness alone</source>
        <translation>Nur Helligkeit</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>Colours of vessels and residuals</source>
        <translation>Farben von Gefäßen und Abständen</translation>
    </message>
    <message>
        <source>Choose the labels that are vessels</source>
        <translation>Labels wählen, die Gefäße sind</translation>
    </message>
    <message>
        <source>Pick the point to turn about</source>
        <translation>Drehpunkt wählen</translation>
    </message>
    <message>
        <source>Turn about the centroid again</source>
        <translation>Wieder um den Schwerpunkt drehen</translation>
    </message>
    <message>
        <source>3-D view: everything, the vessels alone</source>
        <translation>3-D-Ansicht: alles, nur die Gefäße</translation>
    </message>
    <message>
        <source>Export vessel tree …</source>
        <translation>Gefäßbaum exportieren …</translation>
    </message>
    <message>
        <source>Export bent vessels …</source>
        <translation>Gebogene Gefäße exportieren …</translation>
    </message>
    <message>
        <source>Export report …</source>
        <translation>Bericht exportieren …</translation>
    </message>
    <message>
        <source>Export measurements …</source>
        <translation>Messungen exportieren …</translation>
    </message>
    <message>
        <source>Measure a length</source>
        <translation>Länge messen</translation>
    </message>
    <message>
        <source>Measure an angle</source>
        <translation>Winkel messen</translation>
    </message>
    <message>
        <source>Measure an area</source>
        <translation>Fläche messen</translation>
    </message>
    <message>
        <source>Export measures of the branches …</source>
        <translation>Maße der Äste exportieren …</translation>
    </message>
    <message>
        <source>Set a check point</source>
        <translation>Prüfpunkt setzen</translation>
    </message>
    <message>
        <source>Set the ring of an ostium</source>
        <translation>Ring eines Ostiums setzen</translation>
    </message>
    <message>
        <source>Say where a check point is seen</source>
        <translation>Zeigen, wo ein Prüfpunkt zu sehen ist</translation>
    </message>
    <message>
        <source>Draw an arrow</source>
        <translation>Pfeil zeichnen</translation>
    </message>
    <message>
        <source>Write a text on the image</source>
        <translation>Text auf das Bild schreiben</translation>
    </message>
    <message>
        <source>Export check points …</source>
        <translation>Prüfpunkte exportieren …</translation>
    </message>
    <message>
        <source>Export lumen mask …</source>
        <translation>Gefäßmaske exportieren …</translation>
    </message>
    <message>
        <source>Trace one vessel between two places</source>
        <translation>Ein Gefäß zwischen zwei Stellen erfassen</translation>
    </message>
    <message>
        <source>Paint into the lumen mask</source>
        <translation>In die Gefäßmaske malen</translation>
    </message>
    <message>
        <source>Erase from the lumen mask</source>
        <translation>In der Gefäßmaske radieren</translation>
    </message>
    <message>
        <source>Cut the lumen mask by a lasso</source>
        <translation>Gefäßmaske mit dem Lasso schneiden</translation>
    </message>
    <message>
        <source>Trace the edited mask</source>
        <translation>Bearbeitete Maske erfassen</translation>
    </message>
    <message>
        <source>Scan in the 3-D view</source>
        <translation>Scan in der 3-D-Ansicht</translation>
    </message>
    <message>
        <source>Scan in 3-D: vessels, vessels and bone</source>
        <translation>Scan in 3-D: Gefäße, Gefäße und Knochen</translation>
    </message>
    <message>
        <source>Scan in 3-D: only around the vessels</source>
        <translation>Scan in 3-D: nur um die Gefäße</translation>
    </message>
    <message>
        <source>Radiograph of the scan on the detector</source>
        <translation>Röntgenbild des Scans auf dem Detektor</translation>
    </message>
    <message>
        <source>Fold the left column</source>
        <translation>Linke Spalte einklappen</translation>
    </message>
    <message>
        <source>Fold the right column</source>
        <translation>Rechte Spalte einklappen</translation>
    </message>
    <message>
        <source>The layout follows the step</source>
        <translation>Die Anordnung folgt dem Schritt</translation>
    </message>
    <message>
        <source>Layout of this step as it came</source>
        <translation>Anordnung dieses Schritts wie ausgeliefert</translation>
    </message>
    <message>
        <source>Export movie …</source>
        <translation>Film exportieren …</translation>
    </message>
    <message>
        <source>Open from archive …</source>
        <translation>Aus Archiv öffnen …</translation>
    </message>
    <message>
        <source>Send to archive …</source>
        <translation>An Archiv senden …</translation>
    </message>
    <message>
        <source>De-identify files …</source>
        <translation>Dateien ohne Identität …</translation>
    </message>
    <message>
        <source>Private mode</source>
        <translation>Privater Modus</translation>
    </message>
    <message>
        <source>Keep an audit file …</source>
        <translation>Audit-Datei führen …</translation>
    </message>
    <message>
        <source>Save support bundle …</source>
        <translation>Supportpaket speichern …</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ConvergencePlot</name>
    <message>
        <source>Convergence</source>
        <translation>Konvergenz</translation>
    </message>
    <message>
        <source>shown after a run</source>
        <translation>nach einem Lauf zu sehen</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>Schritt %1</translation>
    </message>
    <message>
        <source>median distance</source>
        <translation>medianer Abstand</translation>
    </message>
    <message>
        <source>shift of the vessels in one step</source>
        <translation>Verschiebung der Gefäße je Schritt</translation>
    </message>
    <message>
        <source>Above: half of the vessel points lie nearer than this to the traced vessels.
Below: how far a step moved the vessels, root of the mean square over all points; the bottom line is no shift.</source>
        <translation>Oben: die Hälfte der Gefäßpunkte liegt näher als dies an den erfassten Gefäßen.
Unten: wie weit ein Schritt die Gefäße bewegte, quadratisches Mittel über alle Punkte; die unterste Linie heißt keine Verschiebung.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::CornerViews</name>
    <message>
        <source>3-D</source>
        <translation>3-D</translation>
    </message>
    <message>
        <source>All slices, large</source>
        <translation>Alle Schichten, groß</translation>
    </message>
    <message>
        <source>Only this view in the window, and back</source>
        <translation>Nur diese Ansicht im Fenster, und zurück</translation>
    </message>
    <message>
        <source>In a window of its own, and back</source>
        <translation>In eigenem Fenster, und zurück</translation>
    </message>
    <message>
        <source>Double click: only this view in the window, and back</source>
        <translation>Doppelklick: nur diese Ansicht im Fenster, und zurück</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::CurveEditBar</name>
    <message>
        <source>1 curve</source>
        <translation>1 Kurve</translation>
    </message>
    <message>
        <source>Not a vessel</source>
        <translation>Kein Gefäß</translation>
    </message>
    <message>
        <source>Click a curve to leave it out</source>
        <translation>Kurve anklicken, um sie wegzulassen</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Brush over parts of curves</source>
        <translation>Über Kurventeile streichen</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Click along a vessel: the line follows it</source>
        <translation>Am Gefäß entlang klicken: die Linie folgt ihm</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>Click where a curve is to fall in two</source>
        <translation>Klicken, wo eine Kurve geteilt werden soll</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Leave out what lies in a box; Ctrl: keep it alone</source>
        <translation>Weglassen, was im Rahmen liegt; Strg: nur das behalten</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Leave out what lies in a lasso; Ctrl: keep it alone</source>
        <translation>Weglassen, was im Lasso liegt; Strg: nur das behalten</translation>
    </message>
    <message>
        <source>Trace again</source>
        <translation>Neu erfassen</translation>
    </message>
    <message>
        <source>Forget the edits of this frame and trace it automatically; undo brings them back</source>
        <translation>Bearbeitung dieses Bildes verwerfen und automatisch erfassen; Rückgängig bringt sie zurück</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>%1 curves</source>
        <translation>%1 Kurven</translation>
    </message>
    <message>
        <source>%1 curves, %2 suspect (S)</source>
        <translation>%1 Kurven, %2 verdächtig (S)</translation>
    </message>
    <message>
        <source>Catheter</source>
        <translation>Katheter</translation>
    </message>
    <message>
        <source>Click a catheter or wire to keep it apart: it is no vessel, but can be followed</source>
        <translation>Katheter oder Draht anklicken, um ihn abzusondern: kein Gefäß, aber er lässt sich verfolgen</translation>
    </message>
    <message>
        <source>Follow the wire</source>
        <translation>Draht verfolgen</translation>
    </message>
    <message>
        <source>Find the way of the tree that the catheter or wire takes (method Wire or catheter)</source>
        <translation>Den Weg durch den Baum finden, den Katheter oder Draht nimmt (Verfahren Draht oder Katheter)</translation>
    </message>
    <message>
        <source>%1, %2 apart</source>
        <translation>%1, %2 abgesondert</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::EditCurvesTool</name>
    <message>
        <source>Mark as not a vessel</source>
        <translation>Als Nicht-Gefäß markieren</translation>
    </message>
    <message>
        <source>Edit vessels: tracing this frame …</source>
        <translation>Gefäße bearbeiten: Bild wird erfasst …</translation>
    </message>
    <message>
        <source>Erase: brush over curves, [ ] size of the brush, Esc ends</source>
        <translation>Radieren: über Kurven streichen, [ ] Pinselgröße, Esc beendet</translation>
    </message>
    <message>
        <source>Draw: click along the vessel, Enter ends, Backspace takes a point back, Shift straight</source>
        <translation>Zeichnen: am Gefäß entlang klicken, Eingabe beendet, Rücktaste nimmt einen Punkt zurück, Umschalt gerade</translation>
    </message>
    <message>
        <source>Cut: click where a curve is to fall in two, Esc ends</source>
        <translation>Trennen: klicken, wo eine Kurve geteilt werden soll, Esc beendet</translation>
    </message>
    <message>
        <source>Not a vessel: click a curve to leave it out, Esc ends</source>
        <translation>Kein Gefäß: Kurve anklicken, um sie wegzulassen, Esc beendet</translation>
    </message>
    <message>
        <source>Box: drag around what is no vessel; Ctrl keeps the inside alone, Esc ends</source>
        <translation>Rahmen: um das ziehen, was kein Gefäß ist; Strg behält nur das Innere, Esc beendet</translation>
    </message>
    <message>
        <source>Lasso: draw around what is no vessel; Ctrl keeps the inside alone, Esc ends</source>
        <translation>Lasso: umfahren, was kein Gefäß ist; Strg behält nur das Innere, Esc beendet</translation>
    </message>
    <message>
        <source>Erase curves</source>
        <translation>Kurven radieren</translation>
    </message>
    <message>
        <source>Restrict to a region</source>
        <translation>Auf einen Bereich beschränken</translation>
    </message>
    <message>
        <source>Leave out a region</source>
        <translation>Bereich weglassen</translation>
    </message>
    <message>
        <source>Cut a curve</source>
        <translation>Kurve trennen</translation>
    </message>
    <message>
        <source>Draw a curve</source>
        <translation>Kurve zeichnen</translation>
    </message>
    <message>
        <source>Perhaps a catheter: A vessel, W catheter or wire, Delete leaves it out, S next</source>
        <translation>Vielleicht ein Katheter: A Gefäß, W Katheter oder Draht, Entf lässt weg, S nächster</translation>
    </message>
    <message>
        <source>Catheter or wire: click a curve to keep it apart, or to take it back, Esc ends</source>
        <translation>Katheter oder Draht: Kurve anklicken, um sie abzusondern oder zurückzunehmen, Esc beendet</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ExportDialog</name>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>In print</source>
        <translation>Im Druck</translation>
    </message>
    <message>
        <source>dpi</source>
        <translation>dpi</translation>
    </message>
    <message>
        <source>Vessels over the image</source>
        <translation>Gefäße über dem Bild</translation>
    </message>
    <message>
        <source>The image alone</source>
        <translation>Nur das Bild</translation>
    </message>
    <message>
        <source>Grey values of the image, 16 bit</source>
        <translation>Grauwerte des Bildes, 16 Bit</translation>
    </message>
    <message>
        <source>PNG, pixels</source>
        <translation>PNG, Bildpunkte</translation>
    </message>
    <message>
        <source>SVG, lines and texts</source>
        <translation>SVG, Linien und Texte</translation>
    </message>
    <message>
        <source>PDF, lines and texts</source>
        <translation>PDF, Linien und Texte</translation>
    </message>
    <message>
        <source>as large as the frame</source>
        <translation>so groß wie das Einzelbild</translation>
    </message>
    <message>
        <source>%1 × %2 px, %3 × %4 cm</source>
        <translation>%1 × %2 px, %3 × %4 cm</translation>
    </message>
    <message>
        <source>The picture says “Not for clinical use” (grey values of 16 bit in their text fields alone) and carries inputs, method and pose.</source>
        <translation>Das Bild sagt „Nicht für klinischen Gebrauch“ (Grauwerte mit 16 Bit nur in ihren Textfeldern) und trägt Eingaben, Methode und Pose.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Residual colours with their scale</source>
        <translation>Abweichungsfarben mit Skala</translation>
    </message>
    <message>
        <source>Patient identity in the picture</source>
        <translation>Patientendaten im Bild</translation>
    </message>
    <message>
        <source>Export overlay</source>
        <translation>Überlagerung exportieren</translation>
    </message>
    <message>
        <source>As in the window</source>
        <translation>Wie im Fenster</translation>
    </message>
    <message>
        <source>1024 px wide</source>
        <translation>1024 px breit</translation>
    </message>
    <message>
        <source>2048 px wide</source>
        <translation>2048 px breit</translation>
    </message>
    <message>
        <source>Other width</source>
        <translation>Andere Breite</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Export …</source>
        <translation>Exportieren …</translation>
    </message>
    <message>
        <source>Texts in English</source>
        <translation>Texte auf Englisch</translation>
    </message>
    <message>
        <source>Swipe or lens as in the window</source>
        <translation>Wischen oder Lupe wie im Fenster</translation>
    </message>
    <message>
        <source>Start pose beside it: before and after</source>
        <translation>Startlage daneben: vorher und nachher</translation>
    </message>
    <message>
        <source>twice %1</source>
        <translation>zweimal %1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::FrameBars</name>
    <message>
        <source>R wave</source>
        <translation>R-Zacke</translation>
    </message>
    <message>
        <source>Drag the ends to play a part of the run, double click for all of it</source>
        <translation>Die Enden ziehen, um einen Teil der Serie abzuspielen; Doppelklick: alles</translation>
    </message>
    <message>
        <source>Frames by opacification</source>
        <translation>Bilder nach Kontrastfüllung</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>the fullest</source>
        <translation>das vollste</translation>
    </message>
    <message>
        <source>mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>Shift+drag marks mask frames, double click shows the curve</source>
        <translation>Umschalt+Ziehen markiert Maskenbilder, Doppelklick zeigt die Kurve</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::GeometryPanel</name>
    <message>
        <source>type it</source>
        <translation>eintippen</translation>
    </message>
    <message>
        <source>SID</source>
        <translation>SID</translation>
    </message>
    <message>
        <source>Source to detector distance</source>
        <translation>Abstand Fokus–Detektor</translation>
    </message>
    <message>
        <source>SOD</source>
        <translation>SOD</translation>
    </message>
    <message>
        <source>Source to isocentre distance</source>
        <translation>Abstand Fokus–Isozentrum</translation>
    </message>
    <message>
        <source>pixel</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>LAO / RAO</source>
        <translation>LAO / RAO</translation>
    </message>
    <message>
        <source>Primary angle: LAO positive, RAO negative</source>
        <translation>Primärwinkel: LAO positiv, RAO negativ</translation>
    </message>
    <message>
        <source>CRA / CAU</source>
        <translation>CRA / CAU</translation>
    </message>
    <message>
        <source>Secondary angle: CRA positive, CAU negative</source>
        <translation>Sekundärwinkel: kranial positiv, kaudal negativ</translation>
    </message>
    <message>
        <source>header</source>
        <translation>Header</translation>
    </message>
    <message>
        <source>derived</source>
        <translation>abgeleitet</translation>
    </message>
    <message>
        <source>typed</source>
        <translation>eingegeben</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometrie</translation>
    </message>
    <message>
        <source>Assume usual values</source>
        <translation>Übliche Werte annehmen</translation>
    </message>
    <message>
        <source>Use distances and spacing instead</source>
        <translation>Stattdessen Abstände und Pixelgröße</translation>
    </message>
    <message>
        <source>SID 1000 mm, SOD 750 mm, pixel 0.3 mm, angles 0°: only for what is missing.</source>
        <translation>SID 1000 mm, SOD 750 mm, Pixel 0,3 mm, Winkel 0°: nur für das, was fehlt.</translation>
    </message>
    <message>
        <source>Camera from the case file: f %1 px, centre %2, %3 px, %4.</source>
        <translation>Kamera aus der Falldatei: f %1 px, Mitte %2, %3 px, %4.</translation>
    </message>
    <message>
        <source>seen from the detector</source>
        <translation>vom Detektor gesehen</translation>
    </message>
    <message>
        <source>mirrored</source>
        <translation>gespiegelt</translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation>unvollständig</translation>
    </message>
    <message>
        <source>SID %1</source>
        <translation>SID %1</translation>
    </message>
    <message>
        <source>%1 mm/px</source>
        <translation>%1 mm/px</translation>
    </message>
    <message>
        <source>missing values</source>
        <translation>fehlende Werte</translation>
    </message>
    <message>
        <source>Roll, centre, isocentre</source>
        <translation>Rollen, Mitte, Isozentrum</translation>
    </message>
    <message>
        <source>What the header says</source>
        <translation>Was der Header sagt</translation>
    </message>
    <message>
        <source>as from the detector</source>
        <translation>wie vom Detektor</translation>
    </message>
    <message>
        <source>Side that the image is shown from</source>
        <translation>Seite, von der das Bild gezeigt ist</translation>
    </message>
    <message>
        <source>Angiograms are shown as seen from the detector. A mirrored export shows left and right exchanged: the projection is mirrored with it, the vessels never are.</source>
        <translation>Angiogramme zeigt man vom Detektor gesehen. Ein gespiegelter Export vertauscht links und rechts: die Projektion wird mitgespiegelt, die Gefäße nie.</translation>
    </message>
    <message>
        <source>side of the image</source>
        <translation>Bildseite</translation>
    </message>
    <message>
        <source>image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>%1 tags</source>
        <translation>%1 Tags</translation>
    </message>
    <message>
        <source>The header gives no pixel spacing; this one is derived. Press Enter in it to confirm, or type it.</source>
        <translation>Der Header nennt keine Pixelgröße; diese ist abgeleitet. Mit Eingabe im Feld bestätigen oder eintragen.</translation>
    </message>
    <message>
        <source>The image is taken as mirrored (%1): check that left and right are where they belong.</source>
        <translation>Das Bild gilt als gespiegelt (%1): prüfen, ob links und rechts stimmen.</translation>
    </message>
    <message>
        <source>The gantry turns during this run: at this frame by %1° LAO/RAO and %2° CRA/CAU since the first.</source>
        <translation>Der C-Bogen dreht sich in dieser Serie: bei diesem Bild um %1° LAO/RAO und %2° CRA/CAU seit dem ersten.</translation>
    </message>
    <message>
        <source>Pixel pitch on the detector. Enter confirms a derived one.</source>
        <translation>Pixelabstand auf dem Detektor. Eingabe bestätigt einen abgeleiteten.</translation>
    </message>
    <message>
        <source>field width</source>
        <translation>Bildbreite</translation>
    </message>
    <message>
        <source>Width of the image on the detector: gives the pixel pitch</source>
        <translation>Breite des Bildes auf dem Detektor: ergibt den Pixelabstand</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>The image is turned clockwise by this</source>
        <translation>Um so viel ist das Bild im Uhrzeigersinn gedreht</translation>
    </message>
    <message>
        <source>centre right</source>
        <translation>Mitte rechts</translation>
    </message>
    <message>
        <source>Column that the beam axis meets; 0 is the middle of the first</source>
        <translation>Spalte, die der Zentralstrahl trifft; 0 ist die Mitte der ersten</translation>
    </message>
    <message>
        <source>centre down</source>
        <translation>Mitte unten</translation>
    </message>
    <message>
        <source>Row that the beam axis meets; 0 is the middle of the first</source>
        <translation>Zeile, die der Zentralstrahl trifft; 0 ist die Mitte der ersten</translation>
    </message>
    <message>
        <source>isocentre L</source>
        <translation>Isozentrum L</translation>
    </message>
    <message>
        <source>What the gantry turns about, in the vessels&apos; coordinates: left</source>
        <translation>Drehpunkt des C-Bogens in Gefäßkoordinaten: links</translation>
    </message>
    <message>
        <source>isocentre P</source>
        <translation>Isozentrum P</translation>
    </message>
    <message>
        <source>What the gantry turns about, in the vessels&apos; coordinates: posterior</source>
        <translation>Drehpunkt des C-Bogens in Gefäßkoordinaten: hinten</translation>
    </message>
    <message>
        <source>isocentre H</source>
        <translation>Isozentrum H</translation>
    </message>
    <message>
        <source>What the gantry turns about, in the vessels&apos; coordinates: head</source>
        <translation>Drehpunkt des C-Bogens in Gefäßkoordinaten: Kopf</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::GoodFit</name>
    <message>
        <source>Good: vessels have moved</source>
        <translation>Gut: Gefäße haben sich bewegt</translation>
    </message>
    <message>
        <source>Bad: shifted</source>
        <translation>Schlecht: verschoben</translation>
    </message>
    <message>
        <source>Bad: turned</source>
        <translation>Schlecht: verdreht</translation>
    </message>
    <message>
        <source>Bad: wrong view angle</source>
        <translation>Schlecht: falscher Winkel</translation>
    </message>
    <message>
        <source>Lines run in the middle of their vessels, blue all along, into the side branches too.</source>
        <translation>Die Linien laufen mitten in ihren Gefäßen, durchgehend blau, auch in die Seitenäste.</translation>
    </message>
    <message>
        <source>Amber only where this frame shows no contrast; every filled vessel is blue.</source>
        <translation>Gelb nur, wo dieses Bild kein Kontrastmittel zeigt; jedes gefüllte Gefäß ist blau.</translation>
    </message>
    <message>
        <source>Small differences to both sides: beating and breathing. No rigid pose does better.</source>
        <translation>Kleine Abweichungen nach beiden Seiten: Herzschlag und Atmung. Keine starre Lage ist besser.</translation>
    </message>
    <message>
        <source>All lines miss to the same side. Register again, or nudge with the arrows.</source>
        <translation>Alle Linien liegen zur selben Seite daneben. Neu registrieren oder mit den Pfeilen schieben.</translation>
    </message>
    <message>
        <source>Fits in the middle and misses more and more outwards: turned in the image plane.</source>
        <translation>Passt in der Mitte und nach außen immer weniger: in der Bildebene verdreht.</translation>
    </message>
    <message>
        <source>The trunk fits, side branches point elsewhere: LAO/RAO or CRA/CAU are off.</source>
        <translation>Der Stamm passt, Seitenäste zeigen woandershin: LAO/RAO oder CRA/CAU stimmen nicht.</translation>
    </message>
    <message>
        <source>What a good fit looks like</source>
        <translation>Wie eine gute Einpassung aussieht</translation>
    </message>
    <message>
        <source>Simulated vessels. Blue lies on a vessel, amber 2 mm off or more.</source>
        <translation>Simulierte Gefäße. Blau liegt auf einem Gefäß, gelb 2 mm daneben oder mehr.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>drawing …</source>
        <translation>wird gezeichnet …</translation>
    </message>
    <message>
        <source>Good: everything fits</source>
        <translation>Gut: alles passt</translation>
    </message>
    <message>
        <source>Good: branches unfilled</source>
        <translation>Gut: Äste ungefüllt</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::HeaderBar</name>
    <message>
        <source>Not for clinical use</source>
        <translation>Nicht für den klinischen Einsatz</translation>
    </message>
    <message>
        <source>AngioPose is a research program, not a medical device.</source>
        <translation>AngioPose ist ein Forschungsprogramm, kein Medizinprodukt.</translation>
    </message>
    <message>
        <source>More menus</source>
        <translation>Weitere Menüs</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::HelpPage</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::HistogramPlot</name>
    <message>
        <source>Histogram of residuals</source>
        <translation>Histogramm der Abweichungen</translation>
    </message>
    <message>
        <source>no residuals yet</source>
        <translation>noch keine Abweichungen</translation>
    </message>
    <message>
        <source>above %1</source>
        <translation>über %1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::KeyNotes</name>
    <message>
        <source>← → ↑ ↓</source>
        <translation>← → ↑ ↓</translation>
    </message>
    <message>
        <source>move by 1 mm (Shift 10 mm, Ctrl 0.1 mm)</source>
        <translation>schieben um 1 mm (Umschalt 10 mm, Strg 0,1 mm)</translation>
    </message>
    <message>
        <source>PgUp PgDn</source>
        <translation>Bild↑ Bild↓</translation>
    </message>
    <message>
        <source>move away from or to the source</source>
        <translation>vom Fokus weg oder zu ihm hin</translation>
    </message>
    <message>
        <source>, .</source>
        <translation>, .</translation>
    </message>
    <message>
        <source>roll by 1°</source>
        <translation>rollen um 1°</translation>
    </message>
    <message>
        <source>Alt+arrows</source>
        <translation>Alt+Pfeile</translation>
    </message>
    <message>
        <source>turn LAO/RAO and CRA/CAU by 1°</source>
        <translation>LAO/RAO und CRA/CAU um 1° drehen</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>ziehen</translation>
    </message>
    <message>
        <source>left drag</source>
        <translation>links ziehen</translation>
    </message>
    <message>
        <source>window and level</source>
        <translation>Fensterung</translation>
    </message>
    <message>
        <source>middle drag</source>
        <translation>Mitte ziehen</translation>
    </message>
    <message>
        <source>pan</source>
        <translation>verschieben</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>zoomen</translation>
    </message>
    <message>
        <source>wheel, ↑ ↓, Home, End</source>
        <translation>Rad, ↑ ↓, Pos1, Ende</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>H (hold)</source>
        <translation>H (halten)</translation>
    </message>
    <message>
        <source>hide the overlay</source>
        <translation>Überlagerung verbergen</translation>
    </message>
    <message>
        <source>click</source>
        <translation>klicken</translation>
    </message>
    <message>
        <source>pick a branch (Ctrl adds)</source>
        <translation>Ast wählen (Strg fügt hinzu)</translation>
    </message>
    <message>
        <source>In nudge mode</source>
        <translation>Im Justiermodus</translation>
    </message>
    <message>
        <source>On the angiogram</source>
        <translation>Auf dem Angiogramm</translation>
    </message>
    <message>
        <source>move; on the ring roll; Esc takes it back, then ends the mode</source>
        <translation>schieben; am Ring drehen; Esc nimmt zurück, dann endet der Modus</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Strg+Rad</translation>
    </message>
    <message>
        <source>right click</source>
        <translation>Rechtsklick</translation>
    </message>
    <message>
        <source>menu of what can be done here</source>
        <translation>Menü mit dem, was hier möglich ist</translation>
    </message>
    <message>
        <source>left drag, arrows</source>
        <translation>links ziehen, Pfeile</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>drehen</translation>
    </message>
    <message>
        <source>right drag, wheel, + −</source>
        <translation>rechts ziehen, Rad, + −</translation>
    </message>
    <message>
        <source>double click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>Shift+left drag</source>
        <translation>Umschalt+links ziehen</translation>
    </message>
    <message>
        <source>Ctrl+left drag</source>
        <translation>Strg+links ziehen</translation>
    </message>
    <message>
        <source>right drag</source>
        <translation>rechts ziehen</translation>
    </message>
    <message>
        <source>On the 3-D view</source>
        <translation>Auf der 3-D-Ansicht</translation>
    </message>
    <message>
        <source>in 3-D or a slice, then in the image: one pair</source>
        <translation>in 3-D oder einer Schicht, dann im Bild: ein Paar</translation>
    </message>
    <message>
        <source>a node of the vessels to its place, or a cross elsewhere</source>
        <translation>ein Gefäßknoten an seinen Ort, oder ein Kreuz anderswohin</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>place the vessels by the pairs</source>
        <translation>die Gefäße nach den Paaren legen</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>remove the last pair</source>
        <translation>das letzte Paar entfernen</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>click curves that are no vessels</source>
        <translation>Kurven anklicken, die keine Gefäße sind</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>erase with a brush; [ ] its size</source>
        <translation>mit dem Pinsel radieren; [ ] Größe</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>draw: Enter ends, Backspace takes a point back, Shift straight</source>
        <translation>zeichnen: Eingabe beendet, Rücktaste nimmt zurück, Umschalt gerade</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>cut a curve</source>
        <translation>Kurve trennen</translation>
    </message>
    <message>
        <source>B L</source>
        <translation>B L</translation>
    </message>
    <message>
        <source>box or lasso around what is no vessel; Ctrl: keep the inside alone</source>
        <translation>Rahmen oder Lasso um das, was kein Gefäß ist; Strg: nur das Innere behalten</translation>
    </message>
    <message>
        <source>✓ ✗</source>
        <translation>✓ ✗</translation>
    </message>
    <message>
        <source>dashed curves may be a catheter: keep or leave out</source>
        <translation>gestrichelte Kurven sind vielleicht ein Katheter: behalten oder weglassen</translation>
    </message>
    <message>
        <source>click, left drag, Ctrl+arrows</source>
        <translation>klicken, links ziehen, Strg+Pfeile</translation>
    </message>
    <message>
        <source>cross-hair, linked with all views</source>
        <translation>Fadenkreuz, mit allen Ansichten verbunden</translation>
    </message>
    <message>
        <source>picks the point at the cross-hair, as a click does</source>
        <translation>wählt den Punkt am Fadenkreuz wie ein Klick</translation>
    </message>
    <message>
        <source>wheel, ↑ ↓, PgUp PgDn</source>
        <translation>Rad, ↑ ↓, Bild↑ Bild↓</translation>
    </message>
    <message>
        <source>slices (Shift 10)</source>
        <translation>Schichten (Umschalt 10)</translation>
    </message>
    <message>
        <source>window and level; a right click opens the menu</source>
        <translation>Fensterung; ein Rechtsklick öffnet das Menü</translation>
    </message>
    <message>
        <source>middle drag, Ctrl+wheel</source>
        <translation>Mitte ziehen, Strg+Rad</translation>
    </message>
    <message>
        <source>pan and zoom</source>
        <translation>verschieben und zoomen</translation>
    </message>
    <message>
        <source>all slices large, and back</source>
        <translation>alle Schichten groß, und zurück</translation>
    </message>
    <message>
        <source>While clicking landmarks</source>
        <translation>Beim Klicken von Landmarken</translation>
    </message>
    <message>
        <source>While editing vessels</source>
        <translation>Beim Bearbeiten der Gefäße</translation>
    </message>
    <message>
        <source>On a slice</source>
        <translation>In einer Schicht</translation>
    </message>
    <message>
        <source>this view alone, and back</source>
        <translation>nur diese Ansicht, und zurück</translation>
    </message>
    <message>
        <source>S, then A or Del</source>
        <translation>S, dann A oder Entf</translation>
    </message>
    <message>
        <source>the next of the dashed curves: keep or leave out</source>
        <translation>die nächste der gestrichelten Kurven: behalten oder weglassen</translation>
    </message>
    <message>
        <source>While picking the pivot</source>
        <translation>Beim Wählen des Drehpunkts</translation>
    </message>
    <message>
        <source>a place on the vessels, in the image, in 3-D or in a slice</source>
        <translation>eine Stelle auf den Gefäßen, im Bild, in 3-D oder in einer Schicht</translation>
    </message>
    <message>
        <source>← →</source>
        <translation>← →</translation>
    </message>
    <message>
        <source>the next bifurcation or end</source>
        <translation>die nächste Verzweigung oder das nächste Ende</translation>
    </message>
    <message>
        <source>takes the place shown</source>
        <translation>nimmt die gezeigte Stelle</translation>
    </message>
    <message>
        <source>back to the centroid</source>
        <translation>zurück zum Schwerpunkt</translation>
    </message>
    <message>
        <source>While measuring</source>
        <translation>Beim Messen</translation>
    </message>
    <message>
        <source>click, drag</source>
        <translation>Klick, Ziehen</translation>
    </message>
    <message>
        <source>set a point, or move one that is there</source>
        <translation>setzt einen Punkt oder verschiebt einen</translation>
    </message>
    <message>
        <source>Enter, double click</source>
        <translation>Eingabe, Doppelklick</translation>
    </message>
    <message>
        <source>closes an area</source>
        <translation>schließt eine Fläche</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Rücktaste</translation>
    </message>
    <message>
        <source>takes a point back</source>
        <translation>nimmt einen Punkt zurück</translation>
    </message>
    <message>
        <source>removes the chosen measurement, or the last</source>
        <translation>entfernt die gewählte Messung oder die letzte</translation>
    </message>
    <message>
        <source>While marking</source>
        <translation>Beim Markieren</translation>
    </message>
    <message>
        <source>sets a check point or ring on the vessels, here, in 3-D or in a slice</source>
        <translation>setzt Prüfpunkt oder Ring auf die Gefäße, hier, in 3-D oder in einer Schicht</translation>
    </message>
    <message>
        <source>draws an arrow, or moves what is there</source>
        <translation>zeichnet einen Pfeil oder verschiebt, was da ist</translation>
    </message>
    <message>
        <source>ends a text; Esc drops it</source>
        <translation>beendet einen Text; Esc verwirft ihn</translation>
    </message>
    <message>
        <source>removes the chosen mark, or the last</source>
        <translation>entfernt die gewählte Marke oder die letzte</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::KeySheet</name>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Search keys and what they do</source>
        <translation>Tasten und Wirkungen suchen</translation>
    </message>
    <message>
        <source>Search keys</source>
        <translation>Tasten suchen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>No key for “%1”.</source>
        <translation>Keine Taste für „%1“.</translation>
    </message>
    <message>
        <source>Keys and what they do</source>
        <translation>Tasten und ihre Wirkung</translation>
    </message>
    <message>
        <source>Reset all keys</source>
        <translation>Alle Tasten zurücksetzen</translation>
    </message>
    <message>
        <source>Enter or double-click on a line takes a new key for it.</source>
        <translation>Eingabetaste oder Doppelklick auf eine Zeile nimmt eine neue Taste an.</translation>
    </message>
    <message>
        <source>This key is fixed.</source>
        <translation>Diese Taste ist fest.</translation>
    </message>
    <message>
        <source>Press the new key for “%1”. Esc keeps the old one, Delete leaves none.</source>
        <translation>Neue Taste für „%1“ drücken. Esc behält die alte, Entf lässt keine.</translation>
    </message>
    <message>
        <source>The old key stays.</source>
        <translation>Die alte Taste bleibt.</translation>
    </message>
    <message>
        <source>“%1” is needed elsewhere. Press another key.</source>
        <translation>„%1“ wird anderswo gebraucht. Eine andere Taste drücken.</translation>
    </message>
    <message>
        <source>“%1” belongs to “%2”. Press it again to take it from there, or press another key.</source>
        <translation>„%1“ gehört zu „%2“. Nochmals drücken nimmt sie von dort, oder eine andere drücken.</translation>
    </message>
    <message>
        <source>No key any more.</source>
        <translation>Keine Taste mehr.</translation>
    </message>
    <message>
        <source>The key is “%1” now.</source>
        <translation>Die Taste ist jetzt „%1“.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::LabelChoice</name>
    <message>
        <source>%1 ml</source>
        <translation>%1 ml</translation>
    </message>
    <message>
        <source>Label %1</source>
        <translation>Label %1</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Ticks every label of the list</source>
        <translation>Kreuzt jedes Label der Liste an</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Unticks every label of the list</source>
        <translation>Nimmt das Kreuz von jedem Label der Liste</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>Gefäße</translation>
    </message>
    <message>
        <source>Ticks those that are vessels by their names</source>
        <translation>Kreuzt die an, die dem Namen nach Gefäße sind</translation>
    </message>
    <message>
        <source>Find a label</source>
        <translation>Label suchen</translation>
    </message>
    <message>
        <source>Labels that are vessels</source>
        <translation>Labels, die Gefäße sind</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>Reading the labels …</source>
        <translation>Die Labels werden gelesen …</translation>
    </message>
    <message>
        <source>%1 of %2 ticked, %3</source>
        <translation>%1 von %2 angekreuzt, %3</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::LandmarkPanel</name>
    <message>
        <source>Landmarks</source>
        <translation>Landmarken</translation>
    </message>
    <message>
        <source>Place vessels</source>
        <translation>Gefäße legen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Landmarks and how far each is off</source>
        <translation>Landmarken und ihre Abweichung</translation>
    </message>
    <message>
        <source>Find the start pose from the pairs: Enter while clicking. Undo brings the old one back.</source>
        <translation>Startlage aus den Paaren finden: Eingabe beim Klicken. Rückgängig bringt die alte zurück.</translation>
    </message>
    <message>
        <source>Remove the chosen pairs: Delete</source>
        <translation>Gewählte Paare entfernen: Entf</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>not in view</source>
        <translation>nicht im Bild</translation>
    </message>
    <message>
        <source>%1 pairs</source>
        <translation>%1 Paare</translation>
    </message>
    <message>
        <source>Click pairs</source>
        <translation>Paare klicken</translation>
    </message>
    <message>
        <source>A place on the vessels in 3-D (or a slice), then the same place in the image.</source>
        <translation>Eine Stelle an den Gefäßen in 3-D (oder einer Schicht), dann dieselbe im Bild.</translation>
    </message>
    <message>
        <source>%1: click pairs, then place</source>
        <translation>%1: Paare klicken, dann einpassen</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::LandmarkTool</name>
    <message>
        <source>Landmarks: now click the same place in the image</source>
        <translation>Landmarken: jetzt dieselbe Stelle im Bild anklicken</translation>
    </message>
    <message>
        <source>Landmarks: now click the same place on the vessels in 3-D</source>
        <translation>Landmarken: jetzt dieselbe Stelle an den Gefäßen in 3-D anklicken</translation>
    </message>
    <message>
        <source>Landmarks: click in 3-D and here, or drag a node · Enter places</source>
        <translation>Landmarken: in 3-D und hier klicken, oder Knoten ziehen · Eingabe legt</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::LassoTool</name>
    <message>
        <source>Lasso: draw around the auxiliary branches, Shift adds, Ctrl removes, Esc ends</source>
        <translation>Lasso: Hilfsäste umfahren, Umschalt fügt hinzu, Strg entfernt, Esc beendet</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MainWindow</name>
    <message>
        <source>AngioPose: angiogram</source>
        <translation>AngioPose: Angiogramm</translation>
    </message>
    <message>
        <source>AngioPose: 3-D and slices</source>
        <translation>AngioPose: 3-D und Schichten</translation>
    </message>
    <message>
        <source>AngioPose: slices</source>
        <translation>AngioPose: Schichten</translation>
    </message>
    <message>
        <source>Branches, 3-D and slices</source>
        <translation>Äste, 3-D und Schichten</translation>
    </message>
    <message>
        <source>Pose, registration, result</source>
        <translation>Lage, Registrierung, Ergebnis</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MaskShiftTool</name>
    <message>
        <source>Mask: arrows or drag move it, Shift 1 px, Ctrl 0.05 px, Esc ends · right %1, down %2 px</source>
        <translation>Maske: Pfeile oder Ziehen, Umschalt 1 px, Strg 0,05 px, Esc beendet · rechts %1, unten %2 px</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MessageDialog</name>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Copy details</source>
        <translation>Einzelheiten kopieren</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MissingInputs</name>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Where are the inputs?</source>
        <translation>Wo sind die Eingaben?</translation>
    </message>
    <message>
        <source>“%1” refers to files that are not where they were, and a search beside it and among recent cases did not find them. The case itself is unharmed.</source>
        <translation>„%1“ verweist auf Dateien, die nicht mehr am Ort sind; die Suche daneben und bei den letzten Fällen fand sie nicht. Der Fall selbst ist unversehrt.</translation>
    </message>
    <message>
        <source>was in %1</source>
        <translation>war in %1</translation>
    </message>
    <message>
        <source>Locate …</source>
        <translation>Suchen …</translation>
    </message>
    <message>
        <source>Locate %1</source>
        <translation>%1 suchen</translation>
    </message>
    <message>
        <source>Search a folder …</source>
        <translation>Ordner durchsuchen …</translation>
    </message>
    <message>
        <source>Looks in the folder and all below it, by name and by content.</source>
        <translation>Sucht im Ordner und allen darunter, nach Name und Inhalt.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>jetzt %1</translation>
    </message>
    <message>
        <source>Search a folder</source>
        <translation>Ordner durchsuchen</translation>
    </message>
    <message>
        <source>Open without</source>
        <translation>Ohne öffnen</translation>
    </message>
    <message>
        <source>What is missing is a scan beside the vessels, or another view: the rest opens.</source>
        <translation>Es fehlt ein Scan neben den Gefäßen oder eine weitere Ansicht: der Rest öffnet sich.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MotionPlot</name>
    <message>
        <source>Motion of the vessels by frame</source>
        <translation>Bewegung der Gefäße je Bild</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>frame %1: %2 mm across, %3 mm in depth, %4°</source>
        <translation>Bild %1: %2 mm quer, %3 mm in der Tiefe, %4°</translation>
    </message>
    <message>
        <source>%1 (not explained by the vessels)</source>
        <translation>%1 (durch die Gefäße nicht erklärt)</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::NudgeTool</name>
    <message>
        <source>Nudge: drag shifts, ring rolls, arcs turn, slide is depth, Ctrl is fine, Esc takes back</source>
        <translation>Justieren: Ziehen schiebt, Ring rollt, Bögen drehen, Pfeil links Tiefe, Strg fein, Esc zurück</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::OpacificationPlot</name>
    <message>
        <source>Opacification over the frames</source>
        <translation>Kontrastfüllung über die Bilder</translation>
    </message>
    <message>
        <source>%1 · %2 s</source>
        <translation>%1 · %2 s</translation>
    </message>
    <message>
        <source>Only runs of several frames have a curve</source>
        <translation>Nur Serien mit mehreren Bildern haben eine Kurve</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PivotMark</name>
    <message>
        <source>pivot</source>
        <translation>Drehpunkt</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PivotTool</name>
    <message>
        <source>Pivot: click the vessels, here or in 3-D · ← → and Enter: bifurcations · Del: centroid</source>
        <translation>Drehpunkt: Gefäße anklicken, hier oder in 3-D · ← → und Eingabe: Verzweigungen · Entf: Schwerpunkt</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PortDialog</name>
    <message>
        <source>Encrypted (TLS)</source>
        <translation>Verschlüsselt (TLS)</translation>
    </message>
    <message>
        <source>Our certificate (PEM)</source>
        <translation>Unser Zertifikat (PEM)</translation>
    </message>
    <message>
        <source>Key of our certificate (PEM)</source>
        <translation>Schlüssel unseres Zertifikats (PEM)</translation>
    </message>
    <message>
        <source>Certificates trusted (PEM)</source>
        <translation>Vertraute Zertifikate (PEM)</translation>
    </message>
    <message>
        <source>Security of the receiving port</source>
        <translation>Sicherheit des Empfangsports</translation>
    </message>
    <message>
        <source>With TLS, callers must show a certificate that checks, and so do we.</source>
        <translation>Mit TLS müssen Anrufer ein gültiges Zertifikat zeigen, und wir ebenso.</translation>
    </message>
    <message>
        <source>anyone</source>
        <translation>jeder</translation>
    </message>
    <message>
        <source>AE titles that may call</source>
        <translation>AE-Titel, die anrufen dürfen</translation>
    </message>
    <message>
        <source>With commas between them; empty: any</source>
        <translation>Mit Kommas dazwischen; leer: alle</translation>
    </message>
    <message>
        <source>Addresses that may call</source>
        <translation>Adressen, die anrufen dürfen</translation>
    </message>
    <message>
        <source>IP addresses with commas between them, as 10.0.0.7; empty: any</source>
        <translation>IP-Adressen mit Kommas dazwischen, wie 10.0.0.7; leer: alle</translation>
    </message>
    <message>
        <source>Our certificate</source>
        <translation>Unser Zertifikat</translation>
    </message>
    <message>
        <source>PEM file that callers see</source>
        <translation>PEM-Datei, die Anrufer sehen</translation>
    </message>
    <message>
        <source>Its key</source>
        <translation>Sein Schlüssel</translation>
    </message>
    <message>
        <source>PEM file; only its path is stored</source>
        <translation>PEM-Datei; nur ihr Pfad wird gespeichert</translation>
    </message>
    <message>
        <source>Certificates trusted</source>
        <translation>Vertraute Zertifikate</translation>
    </message>
    <message>
        <source>PEM file by which those of callers are checked; empty: those that the system trusts</source>
        <translation>PEM-Datei, mit der die der Anrufer geprüft werden; leer: die, denen das System vertraut</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PoseAxis</name>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>up</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>along ray</source>
        <translation>im Strahl</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>LAO / RAO</source>
        <translation>LAO / RAO</translation>
    </message>
    <message>
        <source>CRA / CAU</source>
        <translation>CRA / CAU</translation>
    </message>
    <message>
        <source>To the right on screen, in mm at the vessels. Nudge: ← →</source>
        <translation>Nach rechts am Bildschirm, in mm an den Gefäßen. Justieren: ← →</translation>
    </message>
    <message>
        <source>Up on screen, in mm at the vessels. Nudge: ↑ ↓</source>
        <translation>Nach oben am Bildschirm, in mm an den Gefäßen. Justieren: ↑ ↓</translation>
    </message>
    <message>
        <source>Away from the X-ray source, in mm. Nudge: PgUp PgDn</source>
        <translation>Weg vom Röntgenfokus, in mm. Justieren: Bild↑ Bild↓</translation>
    </message>
    <message>
        <source>Clockwise on screen. Nudge: , .</source>
        <translation>Im Uhrzeigersinn am Bildschirm. Justieren: , .</translation>
    </message>
    <message>
        <source>As if the C-arm went to LAO (+) or RAO (−). Nudge: Alt+← Alt+→</source>
        <translation>Als führe der C-Bogen nach LAO (+) oder RAO (−). Justieren: Alt+← Alt+→</translation>
    </message>
    <message>
        <source>As if the C-arm went cranial (+) or caudal (−). Nudge: Alt+↑ Alt+↓</source>
        <translation>Als führe der C-Bogen nach kranial (+) oder kaudal (−). Justieren: Alt+↑ Alt+↓</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PosePanel</name>
    <message>
        <source>%1 ±%2</source>
        <translation>%1 ±%2</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Back to start pose</source>
        <translation>Zurück zur Startlage</translation>
    </message>
    <message>
        <source>Pose %1</source>
        <translation>Lage %1</translation>
    </message>
    <message>
        <source>Lock %1</source>
        <translation>%1 sperren</translation>
    </message>
    <message>
        <source>Keep this value: nudging, dragging, typing and Register leave it as it is.</source>
        <translation>Diesen Wert halten: Justieren, Ziehen, Tippen und Registrieren lassen ihn.</translation>
    </message>
    <message>
        <source>Undo brings the pose back.</source>
        <translation>Rückgängig bringt die Lage zurück.</translation>
    </message>
    <message>
        <source>nudging · arrows · %1 ends</source>
        <translation>justieren · Pfeile · %1 beendet</translation>
    </message>
    <message>
        <source>nudge %1 · fine Ctrl · coarse Shift</source>
        <translation>justieren %1 · fein Strg · grob Umschalt</translation>
    </message>
    <message>
        <source>Turns about the picked pivot, and shifts are those of it. %1 goes back to the centroid.</source>
        <translation>Dreht um den gewählten Drehpunkt, und die Verschiebungen sind seine. %1 führt zum Schwerpunkt zurück.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PoseTable</name>
    <message>
        <source>Run</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Runs the ticked methods one after the other from the pose as it is.</source>
        <translation>Startet die angehakten Methoden nacheinander von der jetzigen Lage aus.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Stops the running method and skips the rest; what is finished stays.</source>
        <translation>Hält die laufende Methode an und überspringt den Rest; Fertiges bleibt.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Moves the vessels there; undo takes it back.</source>
        <translation>Bringt die Gefäße dorthin; Rückgängig nimmt es zurück.</translation>
    </message>
    <message>
        <source>Use as reference</source>
        <translation>Als Bezug</translation>
    </message>
    <message>
        <source>Differences are told from this pose.</source>
        <translation>Unterschiede gelten gegen diese Lage.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Removes the snapshots; undo brings them back.</source>
        <translation>Entfernt die Lagen; Rückgängig bringt sie zurück.</translation>
    </message>
    <message>
        <source>Compare poses</source>
        <translation>Lagen vergleichen</translation>
    </message>
    <message>
        <source>Poses side by side</source>
        <translation>Lagen nebeneinander</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>median mm</source>
        <translation>Median mm</translation>
    </message>
    <message>
        <source>95 % mm</source>
        <translation>95 % mm</translation>
    </message>
    <message>
        <source>covered %</source>
        <translation>abgedeckt %</translation>
    </message>
    <message>
        <source>Δ in plane mm</source>
        <translation>Δ Bildebene mm</translation>
    </message>
    <message>
        <source>Δ depth mm</source>
        <translation>Δ Tiefe mm</translation>
    </message>
    <message>
        <source>Δ turn °</source>
        <translation>Δ Drehung °</translation>
    </message>
    <message>
        <source>run ms</source>
        <translation>Lauf ms</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Autor</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Export CSV …</source>
        <translation>CSV exportieren …</translation>
    </message>
    <message>
        <source>Writes the table with poses as matrices.</source>
        <translation>Schreibt die Tabelle mit Lagen als Matrizen.</translation>
    </message>
    <message>
        <source>Run several methods</source>
        <translation>Mehrere Methoden laufen lassen</translation>
    </message>
    <message>
        <source>each leaves its pose in the table; the case keeps its own</source>
        <translation>jede hinterlässt ihre Lage in der Tabelle; der Fall behält seine</translation>
    </message>
    <message>
        <source>The pose as it is</source>
        <translation>Die jetzige Lage</translation>
    </message>
    <message>
        <source>This fit was not trustworthy.</source>
        <translation>Diese Einpassung war nicht vertrauenswürdig.</translation>
    </message>
    <message>
        <source>Differences are told from “%1”, about the centre of the tree. Amber: not trustworthy.</source>
        <translation>Unterschiede gegen „%1“, um die Mitte des Gefäßbaums. Gelb: nicht vertrauenswürdig.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PruneDialog</name>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Prune</source>
        <translation>Ausdünnen</translation>
    </message>
    <message>
        <source>Remove end branches that are</source>
        <translation>Endäste entfernen, die</translation>
    </message>
    <message>
        <source>shorter than</source>
        <translation>kürzer sind als</translation>
    </message>
    <message>
        <source>on average thinner than (radius)</source>
        <translation>im Mittel dünner sind als (Radius)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Nothing would be left. Lower the limits.</source>
        <translation>Nichts bliebe übrig. Grenzen senken.</translation>
    </message>
    <message>
        <source>No branch goes.</source>
        <translation>Kein Ast entfällt.</translation>
    </message>
    <message>
        <source>1 branch goes.</source>
        <translation>1 Ast entfällt.</translation>
    </message>
    <message>
        <source>%1 branches go.</source>
        <translation>%1 Äste entfallen.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::RecoveryDialog</name>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Recover unsaved work?</source>
        <translation>Nicht Gespeichertes wiederherstellen?</translation>
    </message>
    <message>
        <source>AngioPose ended unexpectedly. These cases had changes that were not saved; recovering opens the copy and leaves the saved case as it is.</source>
        <translation>AngioPose wurde unerwartet beendet. Diese Fälle hatten ungespeicherte Änderungen; Wiederherstellen öffnet die Kopie und lässt den gespeicherten Fall, wie er ist.</translation>
    </message>
    <message>
        <source>Decide later</source>
        <translation>Später entscheiden</translation>
    </message>
    <message>
        <source>Copies of unsaved work</source>
        <translation>Kopien ungespeicherter Arbeit</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>Fall</translation>
    </message>
    <message>
        <source>Last copy</source>
        <translation>Letzte Kopie</translation>
    </message>
    <message>
        <source>Saved in</source>
        <translation>Gespeichert in</translation>
    </message>
    <message>
        <source>never saved</source>
        <translation>nie gespeichert</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::RegistrationPanel</name>
    <message>
        <source>Registration</source>
        <translation>Registrierung</translation>
    </message>
    <message>
        <source>Method and options</source>
        <translation>Methode und Optionen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Registrieren</translation>
    </message>
    <message>
        <source>Ends the run and keeps the best pose so far.</source>
        <translation>Beendet den Lauf und behält die bisher beste Lage.</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>About this method</source>
        <translation>Über diese Methode</translation>
    </message>
    <message>
        <source>What this method minimises, when it fails, and its source.</source>
        <translation>Was diese Methode minimiert, wann sie versagt, und ihre Quelle.</translation>
    </message>
    <message>
        <source>1 auxiliary branch</source>
        <translation>1 Hilfsast</translation>
    </message>
    <message>
        <source>%1 auxiliary branches</source>
        <translation>%1 Hilfsäste</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>Registering …</source>
        <translation>Registriert …</translation>
    </message>
    <message>
        <source>Register keeps the locked degree of freedom.</source>
        <translation>Registrieren hält den gesperrten Freiheitsgrad.</translation>
    </message>
    <message>
        <source>Register keeps the %1 locked degrees of freedom.</source>
        <translation>Registrieren hält die %1 gesperrten Freiheitsgrade.</translation>
    </message>
    <message>
        <source>All %1 views together</source>
        <translation>Alle %1 Ansichten zusammen</translation>
    </message>
    <message>
        <source>Finds the pose that lays the vessels onto the angiogram.</source>
        <translation>Findet die Lage, die die Gefäße auf das Angiogramm legt.</translation>
    </message>
    <message>
        <source>One pose for all views: moving by hand moves the vessels in all of them, and Register fits all by AngioPose&apos;s own method, for depth in one view is a shift in another. Without the tick only the shown view is meant.</source>
        <translation>Eine Lage für alle Ansichten: Von Hand verschoben bewegen sich die Gefäße in allen, und Registrieren passt alle mit AngioPoses eigener Methode ein; die Tiefe der einen Ansicht ist eine Verschiebung in der anderen. Ohne Haken ist nur die gezeigte Ansicht gemeint.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ResultPanel</name>
    <message>
        <source>%1 · of an earlier run</source>
        <translation>%1 · aus einem früheren Lauf</translation>
    </message>
    <message>
        <source>What this pose was fitted to has changed since the run that found it. R registers again.</source>
        <translation>Woran diese Lage angepasst wurde, hat sich seit dem Lauf geändert. R registriert neu.</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1 · moved by hand</source>
        <translation>%1 · von Hand verschoben</translation>
    </message>
    <message>
        <source>%1 · start pose</source>
        <translation>%1 · Startlage</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>Abweichungen</translation>
    </message>
    <message>
        <source>Convergence</source>
        <translation>Konvergenz</translation>
    </message>
    <message>
        <source>median, mm</source>
        <translation>Median, mm</translation>
    </message>
    <message>
        <source>95 %, mm</source>
        <translation>95 %, mm</translation>
    </message>
    <message>
        <source>covered</source>
        <translation>abgedeckt</translation>
    </message>
    <message>
        <source>Share of the traced vessels that the tree explains within 3 px.</source>
        <translation>Anteil der erkannten Gefäße, den der Gefäßbaum auf 3 px erklärt.</translation>
    </message>
    <message>
        <source>± is one standard deviation.</source>
        <translation>± ist eine Standardabweichung.</translation>
    </message>
    <message>
        <source>nothing to judge yet</source>
        <translation>noch nichts zu beurteilen</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>This is the start pose: nothing is fitted yet. R registers, N nudges.</source>
        <translation>Das ist die Startlage: noch nichts eingepasst. R registriert, N justiert.</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>mm across, by frame</source>
        <translation>mm quer, je Bild</translation>
    </message>
    <message>
        <source>%1 · followed</source>
        <translation>%1 · verfolgt</translation>
    </message>
    <message>
        <source>%1 → %2 px · steps: %3</source>
        <translation>%1 → %2 px · Schritte: %3</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>Schritt %1</translation>
    </message>
    <message>
        <source>median %1 mm over %2 % judged opacified, whole tree %3 mm</source>
        <translation>Median %1 mm über als kontrastiert geltende %2 %, ganzer Gefäßbaum %3 mm</translation>
    </message>
    <message>
        <source>median %1 mm</source>
        <translation>Median %1 mm</translation>
    </message>
    <message>
        <source>Moved by hand, not registered</source>
        <translation>Von Hand bewegt, nicht registriert</translation>
    </message>
    <message>
        <source>Inputs changed since this registration</source>
        <translation>Eingaben seit dieser Registrierung geändert</translation>
    </message>
    <message>
        <source>Start pose, not registered</source>
        <translation>Ausgangslage, nicht registriert</translation>
    </message>
    <message>
        <source>NOT RELIABLE · %1</source>
        <translation>NICHT VERLÄSSLICH · %1</translation>
    </message>
    <message>
        <source>No check speaks against it · %1</source>
        <translation>Keine Prüfung spricht dagegen · %1</translation>
    </message>
    <message>
        <source>Half of the vessel points judged opacified lie nearer than this.</source>
        <translation>Die Hälfte der Gefäßpunkte, die als kontrastiert gelten, liegt näher.</translation>
    </message>
    <message>
        <source>95 of 100 vessel points judged opacified lie nearer than this.</source>
        <translation>95 von 100 Gefäßpunkten, die als kontrastiert gelten, liegen näher.</translation>
    </message>
    <message>
        <source>mm, points judged opacified</source>
        <translation>mm, als kontrastiert geltende Punkte</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ResultSentences</name>
    <message>
        <source>%1 of %2 branches agree within %3 mm.</source>
        <translation>%1 von %2 Ästen stimmen auf %3 mm überein.</translation>
    </message>
    <message>
        <source>Depth ±%1 mm: one view cannot tell it.</source>
        <translation>Tiefe ±%1 mm: eine Ansicht allein verrät sie nicht.</translation>
    </message>
    <message>
        <source>Within 2 mm of the vessels with a probability of %1 %.</source>
        <translation>Mit einer Wahrscheinlichkeit von %1 % höchstens 2 mm neben den Gefäßen.</translation>
    </message>
    <message>
        <source>Depth is the least certain: ±%1 mm.</source>
        <translation>Am unsichersten ist die Tiefe: ±%1 mm.</translation>
    </message>
    <message>
        <source>%1 is %2 mm off: perhaps unfilled in this frame, or moved.</source>
        <translation>%1 liegt %2 mm daneben: in diesem Bild vielleicht nicht gefüllt oder verschoben.</translation>
    </message>
    <message>
        <source>%1 branches are up to %2 mm off: unfilled in this frame, or the pose is wrong.</source>
        <translation>%1 Äste liegen bis %2 mm daneben: in diesem Bild nicht gefüllt, oder die Lage ist falsch.</translation>
    </message>
    <message>
        <source>%1 and %2 are up to %3 mm off: perhaps unfilled in this frame, or moved.</source>
        <translation>%1 und %2 liegen bis %3 mm daneben: in diesem Bild vielleicht nicht gefüllt oder verschoben.</translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation>Ast %1</translation>
    </message>
    <message>
        <source>In plane ±%1 mm, rotation ±%2°.</source>
        <translation>In der Bildebene ±%1 mm, Drehung ±%2°.</translation>
    </message>
    <message>
        <source>In plane ±%1 mm.</source>
        <translation>In der Bildebene ±%1 mm.</translation>
    </message>
    <message>
        <source>Rotation ±%1°.</source>
        <translation>Drehung ±%1°.</translation>
    </message>
    <message>
        <source>With the errors of the geometry: depth ±%1 mm, sideways ±%2 mm.</source>
        <translation>Mit den Fehlern der Geometrie: Tiefe ±%1 mm, seitlich ±%2 mm.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::Section</name>
    <message>
        <source>Fold %1</source>
        <translation>%1 ein- oder ausklappen</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SeriesChooser</name>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Choose a series</source>
        <translation>Serie wählen</translation>
    </message>
    <message>
        <source>Which series?</source>
        <translation>Welche Serie?</translation>
    </message>
    <message numerus="yes">
        <source>%1 holds %n series.</source>
        <translation>
            <numerusform>%1 enthält %n Serien.</numerusform>
            <numerusform>%1 enthält %n Serien.</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Series of the folder</source>
        <translation>Serien des Ordners</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalität</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Spacing in mm</source>
        <translation>Abstand in mm</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SliceModel</name>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronar</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SliceView</name>
    <message>
        <source>x %1  y %2  z %3 mm</source>
        <translation>x %1  y %2  z %3 mm</translation>
    </message>
    <message>
        <source>No scan</source>
        <translation>Kein CT</translation>
    </message>
    <message>
        <source>%1 %2 / %3</source>
        <translation>%1 %2 / %3</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>außerhalb</translation>
    </message>
    <message>
        <source>%1 HU</source>
        <translation>%1 HE</translation>
    </message>
    <message>
        <source>W %1 L %2</source>
        <translation>W %1 L %2</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MethodWords</name>
    <message>
        <source>by hand</source>
        <translation>von Hand</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SnapshotPanel</name>
    <message>
        <source>median %1 mm, 95 % %2 mm, covered %3 %</source>
        <translation>Median %1 mm, 95 % %2 mm, abgedeckt %3 %</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>Compare …</source>
        <translation>Vergleichen …</translation>
    </message>
    <message>
        <source>Kept poses</source>
        <translation>Behaltene Lagen</translation>
    </message>
    <message>
        <source>Runs (%1)</source>
        <translation>Läufe (%1)</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>Restore	Return</source>
        <translation>Wiederherstellen	Eingabe</translation>
    </message>
    <message>
        <source>Use as A</source>
        <translation>Als A</translation>
    </message>
    <message>
        <source>Use as B</source>
        <translation>Als B</translation>
    </message>
    <message>
        <source>Rename	F2</source>
        <translation>Umbenennen	F2</translation>
    </message>
    <message>
        <source>Delete	Del</source>
        <translation>Löschen	Entf</translation>
    </message>
    <message>
        <source>%1 keeps the pose; %2 goes between two. Every run leaves its pose here.</source>
        <translation>%1 behält die Lage; %2 wechselt zwischen zweien. Jeder Lauf hinterlässt seine Lage hier.</translation>
    </message>
    <message>
        <source>Keep pose</source>
        <translation>Lage behalten</translation>
    </message>
    <message>
        <source>Keeps this pose with its numbers under a name.</source>
        <translation>Behält diese Lage mit ihren Zahlen unter einem Namen.</translation>
    </message>
    <message>
        <source>Poses and methods side by side, as a table.</source>
        <translation>Lagen und Methoden nebeneinander als Tabelle.</translation>
    </message>
    <message>
        <source>median mm · %1: A ⇄ B</source>
        <translation>Median mm · %1: A ⇄ B</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SolutionStrip</name>
    <message>
        <source>Solutions</source>
        <translation>Lösungen</translation>
    </message>
    <message>
        <source>Solutions of the run</source>
        <translation>Lösungen des Laufs</translation>
    </message>
    <message>
        <source>%1 shows the next · %2 takes it</source>
        <translation>%1 nächste · %2 nimmt sie</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::StepBar</name>
    <message>
        <source>Vessels</source>
        <translation>Gefäße</translation>
    </message>
    <message>
        <source>Angiogram</source>
        <translation>Angiogramm</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometrie</translation>
    </message>
    <message>
        <source>Start pose</source>
        <translation>Startlage</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Registrieren</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::StepButton</name>
    <message>
        <source>done</source>
        <translation>erledigt</translation>
    </message>
    <message>
        <source>needs a look</source>
        <translation>bitte ansehen</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <translation>%1: %2, %3</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::Tour</name>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SeedList</name>
    <message>
        <source>%1  %2  %3  %4</source>
        <translation>%1  %2  %3  %4</translation>
    </message>
    <message>
        <source>Seeds</source>
        <translation>Startpunkte</translation>
    </message>
    <message>
        <source>Then click vessels in a slice: only what is connected to a seed is traced.</source>
        <translation>Dann Gefäße in einer Schicht anklicken: nur Verbundenes wird erfasst.</translation>
    </message>
    <message>
        <source>Avoid</source>
        <translation>Meiden</translation>
    </message>
    <message>
        <source>Then click heart, veins or bone in a slice: what is reached from there on wider ways is left out.</source>
        <translation>Dann Herz, Venen oder Knochen anklicken: was von dort auf weiteren Wegen erreicht wird, entfällt.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Seeds and places to avoid</source>
        <translation>Startpunkte und zu meidende Stellen</translation>
    </message>
    <message>
        <source>+ seed %1</source>
        <translation>+ Startpunkt %1</translation>
    </message>
    <message>
        <source>× avoid %1</source>
        <translation>× meiden %1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ThresholdField</name>
    <message>
        <source>Automatic threshold</source>
        <translation>Automatische Schwelle</translation>
    </message>
    <message>
        <source>HU</source>
        <translation>HE</translation>
    </message>
    <message>
        <source>Show in the slices what is above</source>
        <translation>In den Schichten zeigen, was darüber liegt</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>The vessels begin at this value of the scan.</source>
        <translation>Ab diesem Wert des CT beginnen die Gefäße.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::TracingPanel</name>
    <message>
        <source>Thin vessels only, from the seeds</source>
        <translation>Nur dünne Gefäße ab Startpunkt</translation>
    </message>
    <message>
        <source>For coronary arteries beside filled chambers, hepatic arteries beside the portal vein: what is wider than a centimetre ends the vessels. Needs seeds.</source>
        <translation>Für Kranzgefäße neben gefüllten Herzkammern, Leberarterien neben der Pfortader: was breiter als ein Zentimeter ist, beendet die Gefäße. Braucht Startpunkte.</translation>
    </message>
    <message>
        <source>One vessel by two clicks</source>
        <translation>Ein Gefäß mit zwei Klicks</translation>
    </message>
    <message>
        <source>Trace vessels</source>
        <translation>Gefäße erfassen</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Erfassen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Shortest branch</source>
        <translation>Kürzester Ast</translation>
    </message>
    <message>
        <source>Branches that leave their parent&apos;s wall by less are removed.</source>
        <translation>Äste, die weniger aus der Wand ihres Stammes ragen, entfallen.</translation>
    </message>
    <message>
        <source>Thinnest branch</source>
        <translation>Dünnster Ast</translation>
    </message>
    <message>
        <source>Branches whose mean radius is smaller are removed.</source>
        <translation>Äste mit kleinerem mittlerem Radius entfallen.</translation>
    </message>
    <message>
        <source>Keep loops</source>
        <translation>Schleifen behalten</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Stücke</translation>
    </message>
    <message>
        <source>Without seeds. As usual: all pieces of a mask, of a scan the great vessel&apos;s. All of a scan: those of every great vessel.</source>
        <translation>Ohne Startpunkte. Wie üblich: alle Stücke einer Maske, im Scan das des großen Gefäßes. Alle im Scan: die aller großen Gefäße.</translation>
    </message>
    <message>
        <source>As usual</source>
        <translation>Wie üblich</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>The largest</source>
        <translation>Das größte</translation>
    </message>
    <message>
        <source>Vessels that run in a circle stay closed, else each is opened where it is thinnest.</source>
        <translation>Gefäße, die im Kreis laufen, bleiben geschlossen; sonst wird jeder Kreis an der dünnsten Stelle geöffnet.</translation>
    </message>
    <message>
        <source>Ends the tracing; the vessels stay as they were.</source>
        <translation>Beendet das Erfassen; die Gefäße bleiben, wie sie waren.</translation>
    </message>
    <message>
        <source>Tracing …</source>
        <translation>Erfassung …</translation>
    </message>
    <message>
        <source>Click in a slice to place a point; Esc ends.</source>
        <translation>In eine Schicht klicken setzt einen Punkt; Esc beendet.</translation>
    </message>
    <message>
        <source>The traced vessels replace the tree; undo brings it back.</source>
        <translation>Die erfassten Gefäße ersetzen den Gefäßbaum; Rückgängig bringt ihn zurück.</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Add seed</source>
        <translation>Startpunkt setzen</translation>
    </message>
    <message>
        <source>Moves the slices to the vessel that was not traced.</source>
        <translation>Führt die Schichten zu dem nicht erkannten Gefäß.</translation>
    </message>
    <message>
        <source>Places a seed in this vessel, and one in the traced vessel beside it.</source>
        <translation>Setzt einen Startpunkt in dieses Gefäß und einen in das erkannte daneben.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::TreeView</name>
    <message>
        <source>No vessels yet: drop some here, open them (%1), or trace a scan in its slices (%2).</source>
        <translation>Noch keine Gefäße: hier ablegen, öffnen (%1) oder in den Schichten eines Scans erfassen (%2).</translation>
    </message>
    <message>
        <source>3-D view of vessel tree, X-ray source and detector</source>
        <translation>3-D-Ansicht von Gefäßbaum, Röntgenfokus und Detektor</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::TrialBar</name>
    <message>
        <source>Abandon</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Ends the trial; the log says that it was abandoned.</source>
        <translation>Beendet den Versuch; das Protokoll nennt ihn abgebrochen.</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Blind trial of %1: lay the vessels onto the image. Numbers come back when you are done.</source>
        <translation>Blindversuch von %1: die Gefäße auf das Bild legen. Die Zahlen erscheinen danach wieder.</translation>
    </message>
    <message>
        <source>Logs time and pose, and brings the numbers back.</source>
        <translation>Protokolliert Zeit und Lage und zeigt die Zahlen wieder.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ViewFrame</name>
    <message>
        <source>In a window of its own</source>
        <translation>In einem eigenen Fenster</translation>
    </message>
    <message>
        <source>Bring it back</source>
        <translation>Zurückholen</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ViewPane</name>
    <message>
        <source>Frames of this view</source>
        <translation>Bilder dieser Ansicht</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ViewStrip</name>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>All views beside each other, or the shown one alone</source>
        <translation>Alle Ansichten nebeneinander oder die gezeigte allein</translation>
    </message>
    <message>
        <source>Cross-hair</source>
        <translation>Fadenkreuz</translation>
    </message>
    <message>
        <source>What is under the pointer in one view is a line in the others, and a point on the vessels</source>
        <translation>Was in einer Ansicht unter dem Zeiger liegt, ist in den anderen eine Linie, und ein Punkt auf den Gefäßen</translation>
    </message>
    <message>
        <source>Views of the case</source>
        <translation>Ansichten des Falls</translation>
    </message>
    <message>
        <source>Add a view</source>
        <translation>Ansicht hinzufügen</translation>
    </message>
    <message>
        <source>Another angiogram of the same vessels (Ctrl+Shift+V)</source>
        <translation>Ein weiteres Angiogramm derselben Gefäße (Strg+Umschalt+V)</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::VtkView</name>
    <message>
        <source>The 3-D view needs OpenGL 3.2, which this display does not offer. Everything else works. Try LIBGL_ALWAYS_SOFTWARE=1, or install libgl1-mesa-dri.</source>
        <translation>Die 3-D-Ansicht braucht OpenGL 3.2, das diese Anzeige nicht bietet. Alles andere geht. LIBGL_ALWAYS_SOFTWARE=1 versuchen oder libgl1-mesa-dri installieren.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::WelcomePage</name>
    <message>
        <source>Lay a vessel tree onto its angiogram</source>
        <translation>Einen Gefäßbaum auf sein Angiogramm legen</translation>
    </message>
    <message>
        <source>Open the sample case</source>
        <translation>Beispielfall öffnen</translation>
    </message>
    <message>
        <source>Drop a case here, or vessels together with an angiogram.</source>
        <translation>Hier einen Fall ablegen, oder Gefäße mit einem Angiogramm.</translation>
    </message>
    <message>
        <source>Vessels: CT as DICOM folder, NIfTI, NRRD or MetaImage, masks, centrelines (VTP, VTK, CSV, SWC).  Angiograms: DICOM XA, PNG, TIFF.</source>
        <translation>Gefäße: CT als DICOM-Ordner, NIfTI, NRRD oder MetaImage, Masken, Mittellinien (VTP, VTK, CSV, SWC).  Angiogramme: DICOM XA, PNG, TIFF.</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Open folder or disc …</source>
        <translation>Ordner oder CD öffnen …</translation>
    </message>
    <message>
        <source>Lists the patients, studies and series of a folder, a CD or a DICOMDIR.</source>
        <translation>Listet Patienten, Studien und Serien eines Ordners, einer CD oder eines DICOMDIR.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::WindowActions</name>
    <message>
        <source>Open recent</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>In the whole window</source>
        <translation>Im ganzen Fenster</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::WindowBar</name>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Own window</source>
        <translation>Eigenes Fenster</translation>
    </message>
    <message>
        <source>Back to the angiogram</source>
        <translation>Zurück zum Angiogramm</translation>
    </message>
    <message>
        <source>The slices in a window of their own, and back (F9)</source>
        <translation>Die Schichten in eigenem Fenster, und zurück (F9)</translation>
    </message>
    <message>
        <source>W %1 L %2 HU</source>
        <translation>W %1 L %2 HE</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>From the values of this scan; right drag in a slice changes it by hand.</source>
        <translation>Aus den Werten dieses CT; rechts ziehen in einer Schicht ändert von Hand.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::WindowPreset</name>
    <message>
        <source>CTA</source>
        <translation>CTA</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>Weichteile</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Lunge</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MessageHistory</name>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Nothing has been told yet.</source>
        <translation>Noch keine Meldungen.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::MeasureWords</name>
    <message>
        <source>Frame %1.</source>
        <translation>Bild %1.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>%1 in the scan</source>
        <translation>%1 im Scan</translation>
    </message>
    <message>
        <source>%1, %2 %3 mm.</source>
        <translation>%1, %2 %3 mm.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::MeasureController</name>
    <message>
        <source>Measure length</source>
        <translation>Länge messen</translation>
    </message>
    <message>
        <source>Measure angle</source>
        <translation>Winkel messen</translation>
    </message>
    <message>
        <source>Measure area</source>
        <translation>Fläche messen</translation>
    </message>
    <message>
        <source>Move point of measurement</source>
        <translation>Messpunkt verschieben</translation>
    </message>
    <message>
        <source>Rename measurement</source>
        <translation>Messung umbenennen</translation>
    </message>
    <message>
        <source>Remove measurement</source>
        <translation>Messung entfernen</translation>
    </message>
    <message>
        <source>Measure in another plane</source>
        <translation>In anderer Ebene messen</translation>
    </message>
    <message>
        <source>Type scale of the image</source>
        <translation>Maßstab des Bildes eingeben</translation>
    </message>
    <message>
        <source>Open an angiogram or a scan first.</source>
        <translation>Zuerst ein Angiogramm oder einen Scan öffnen.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MeasurePanel</name>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Table …</source>
        <translation>Tabelle …</translation>
    </message>
    <message>
        <source>Where it is measured</source>
        <translation>Wo gemessen wird</translation>
    </message>
    <message>
        <source>Lengths at the depth of the vessels, on the detector, or in pixels.</source>
        <translation>Längen in der Tiefe der Gefäße, auf dem Detektor oder in Pixeln.</translation>
    </message>
    <message>
        <source>Remove the chosen measurements: Delete</source>
        <translation>Gewählte Messungen entfernen: Entf</translation>
    </message>
    <message>
        <source>Writes all measurements with their basis as a CSV table.</source>
        <translation>Schreibt alle Messungen mit ihrer Grundlage als CSV-Tabelle.</translation>
    </message>
    <message>
        <source>at the vessels</source>
        <translation>an den Gefäßen</translation>
    </message>
    <message>
        <source>at the detector</source>
        <translation>am Detektor</translation>
    </message>
    <message>
        <source>in pixels</source>
        <translation>in Pixeln</translation>
    </message>
    <message>
        <source>by a typed scale</source>
        <translation>nach eingegebenem Maßstab</translation>
    </message>
    <message>
        <source> mm per pixel</source>
        <translation> mm pro Pixel</translation>
    </message>
    <message>
        <source>scale not typed</source>
        <translation>kein Maßstab eingegeben</translation>
    </message>
    <message>
        <source>Scale of the image</source>
        <translation>Maßstab des Bildes</translation>
    </message>
    <message>
        <source>What a pixel measures in the patient, where it is known from elsewhere.</source>
        <translation>Was ein Pixel im Patienten misst, wo es anderswoher bekannt ist.</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Measurements in image and slices</source>
        <translation>Messungen in Bild und Schichten</translation>
    </message>
    <message>
        <source>%1 measured</source>
        <translation>%1 gemessen</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MeasureTool</name>
    <message>
        <source>Length: drag, or click both ends · points can be moved</source>
        <translation>Länge: ziehen oder beide Enden anklicken · Punkte lassen sich verschieben</translation>
    </message>
    <message>
        <source>Angle: click an end, the vertex, the other end · points can be moved</source>
        <translation>Winkel: ein Ende, den Scheitel, das andere Ende anklicken · Punkte lassen sich verschieben</translation>
    </message>
    <message>
        <source>Area: click around it; double click or Enter closes · points can be moved</source>
        <translation>Fläche: ringsum klicken; Doppelklick oder Eingabe schließt · Punkte lassen sich verschieben</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ProfileController</name>
    <message>
        <source>Choose one branch, in the list or in a view.</source>
        <translation>Einen Ast wählen, in der Liste oder in einer Ansicht.</translation>
    </message>
    <message>
        <source>Open the vessels first.</source>
        <translation>Erst die Gefäße öffnen.</translation>
    </message>
    <message>
        <source>Export measures of the branches</source>
        <translation>Maße der Äste exportieren</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Export profile</source>
        <translation>Profil exportieren</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ProfilePanel</name>
    <message>
        <source>%1 % at %2 mm (%3 of %4 mm, %5 mm long)</source>
        <translation>%1 % bei %2 mm (%3 von %4 mm, %5 mm lang)</translation>
    </message>
    <message>
        <source>Along the branch</source>
        <translation>Entlang des Astes</translation>
    </message>
    <message>
        <source>All branches …</source>
        <translation>Alle Äste …</translation>
    </message>
    <message>
        <source>Profile …</source>
        <translation>Profil …</translation>
    </message>
    <message>
        <source>Writes length, diameters, narrowing and bends of all branches as a CSV table.</source>
        <translation>Schreibt Länge, Durchmesser, Verengung und Biegungen aller Äste als CSV-Tabelle.</translation>
    </message>
    <message>
        <source>Writes diameter and curvature along this branch as a CSV table.</source>
        <translation>Schreibt Durchmesser und Krümmung entlang dieses Astes als CSV-Tabelle.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Mean diameter</source>
        <translation>Mittlerer Durchmesser</translation>
    </message>
    <message>
        <source>Least diameter</source>
        <translation>Kleinster Durchmesser</translation>
    </message>
    <message>
        <source>Narrowest place</source>
        <translation>Engste Stelle</translation>
    </message>
    <message>
        <source>Tortuosity</source>
        <translation>Tortuosität</translation>
    </message>
    <message>
        <source>Sharpest bend</source>
        <translation>Stärkste Biegung</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>gerade</translation>
    </message>
    <message>
        <source>radius %1 mm</source>
        <translation>Radius %1 mm</translation>
    </message>
    <message>
        <source>Diameters are twice the radii of the tree; the narrowest place is told against the rest of the branch.</source>
        <translation>Durchmesser sind die doppelten Radien des Gefäßbaums; die engste Stelle gilt gegen den Rest des Astes.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ProfilePlot</name>
    <message>
        <source>Diameter and curvature along the branch</source>
        <translation>Durchmesser und Krümmung entlang des Astes</translation>
    </message>
    <message>
        <source>⌀ %1 mm</source>
        <translation>⌀ %1 mm</translation>
    </message>
    <message>
        <source>bend %1/mm</source>
        <translation>Krümmung %1/mm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>at %1 mm</source>
        <translation>bei %1 mm</translation>
    </message>
    <message>
        <source>reference %1 mm</source>
        <translation>Referenz %1 mm</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PlayBar</name>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Stops at the frame that is shown. Esc goes back to the one before.</source>
        <translation>Hält bei dem Bild, das zu sehen ist. Esc kehrt zum vorigen zurück.</translation>
    </message>
    <message>
        <source>Plays the run</source>
        <translation>Spielt die Serie ab</translation>
    </message>
    <message>
        <source>At the end from the start again</source>
        <translation>Am Ende von vorn</translation>
    </message>
    <message>
        <source>Back and forth</source>
        <translation>Hin und her</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>%1 · %2/s</source>
        <translation>%1 · %2/s</translation>
    </message>
    <message>
        <source>The header does not say how fast the run was taken: 1× takes %1 frames a second</source>
        <translation>Die Kopfdaten sagen nicht, wie schnell die Serie aufgenommen wurde: 1× nimmt %1 Bilder je Sekunde an</translation>
    </message>
    <message>
        <source>1×: as fast as the run was taken, %1 frames a second</source>
        <translation>1×: so schnell, wie die Serie aufgenommen wurde, %1 Bilder je Sekunde</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MarkPanel</name>
    <message>
        <source>Check point</source>
        <translation>Prüfpunkt</translation>
    </message>
    <message>
        <source>Ostium ring</source>
        <translation>Ostiumring</translation>
    </message>
    <message>
        <source>Seen here</source>
        <translation>Hier zu sehen</translation>
    </message>
    <message>
        <source>Arrow</source>
        <translation>Pfeil</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Check points and marks</source>
        <translation>Prüfpunkte und Marken</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Table …</source>
        <translation>Tabelle …</translation>
    </message>
    <message>
        <source>Remove the chosen marks: Delete</source>
        <translation>Gewählte Marken entfernen: Entf</translation>
    </message>
    <message>
        <source>Writes all check points and rings with their errors as a CSV table.</source>
        <translation>Schreibt alle Prüfpunkte und Ringe mit ihren Fehlern als CSV-Tabelle.</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Marken</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MarkTool</name>
    <message>
        <source>Check point: click the vessels, here, in 3-D or in a slice · points can be moved</source>
        <translation>Prüfpunkt: auf die Gefäße klicken, hier, in 3-D oder in einer Schicht · Punkte lassen sich verschieben</translation>
    </message>
    <message>
        <source>Ostium ring: click the vessels, here, in 3-D or in a slice · rings can be moved</source>
        <translation>Ostiumring: auf die Gefäße klicken, hier, in 3-D oder in einer Schicht · Ringe lassen sich verschieben</translation>
    </message>
    <message>
        <source>Seen here: click where the chosen check point is seen, or drag it there</source>
        <translation>Hier zu sehen: dorthin klicken, wo der gewählte Prüfpunkt zu sehen ist, oder ihn dorthin ziehen</translation>
    </message>
    <message>
        <source>Arrow: drag from its tail to its tip, then type · ends can be moved</source>
        <translation>Pfeil: vom Ende zur Spitze ziehen, dann schreiben · Enden lassen sich verschieben</translation>
    </message>
    <message>
        <source>Text: click where it begins, then type · texts can be moved</source>
        <translation>Text: klicken, wo er beginnt, dann schreiben · Texte lassen sich verschieben</translation>
    </message>
    <message>
        <source>Text on the image</source>
        <translation>Text auf dem Bild</translation>
    </message>
    <message>
        <source>Text, then Enter</source>
        <translation>Text, dann Enter</translation>
    </message>
</context>
<context>
    <name>angiopose::app::MarkController</name>
    <message>
        <source>Open the vessels first.</source>
        <translation>Zuerst die Gefäße öffnen.</translation>
    </message>
    <message>
        <source>Open an angiogram first.</source>
        <translation>Zuerst ein Angiogramm öffnen.</translation>
    </message>
    <message>
        <source>Set check point</source>
        <translation>Prüfpunkt setzen</translation>
    </message>
    <message>
        <source>Set ostium ring</source>
        <translation>Ostiumring setzen</translation>
    </message>
    <message>
        <source>Set a check point on the vessels first.</source>
        <translation>Zuerst einen Prüfpunkt auf die Gefäße setzen.</translation>
    </message>
    <message>
        <source>Say where a check point is seen</source>
        <translation>Zeigen, wo ein Prüfpunkt zu sehen ist</translation>
    </message>
    <message>
        <source>Draw arrow</source>
        <translation>Pfeil zeichnen</translation>
    </message>
    <message>
        <source>Write text</source>
        <translation>Text schreiben</translation>
    </message>
    <message>
        <source>Move mark</source>
        <translation>Marke verschieben</translation>
    </message>
    <message>
        <source>Rename mark</source>
        <translation>Marke umbenennen</translation>
    </message>
    <message>
        <source>Remove mark</source>
        <translation>Marke entfernen</translation>
    </message>
    <message>
        <source>Places on the vessels with a name, and how far the pose puts them beside where they are seen; arrows and texts for pictures.</source>
        <translation>Benannte Stellen auf den Gefäßen und wie weit die Lage sie neben das setzt, wo sie zu sehen sind; Pfeile und Texte für Bilder.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::MarkWords</name>
    <message>
        <source>View %1:</source>
        <translation>Ansicht %1:</translation>
    </message>
    <message>
        <source>arrow</source>
        <translation>Pfeil</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>On frame %1 of this view, in every picture of it.</source>
        <translation>Auf Bild %1 dieser Ansicht, in jedem Bild davon.</translation>
    </message>
    <message>
        <source>Ostium %1</source>
        <translation>Ostium %1</translation>
    </message>
    <message>
        <source>Check point %1</source>
        <translation>Prüfpunkt %1</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PathController</name>
    <message>
        <source>Trace one vessel</source>
        <translation>Ein Gefäß erfassen</translation>
    </message>
    <message>
        <source>Traced: one vessel of %1 mm.</source>
        <translation>Erfasst: ein Gefäß von %1 mm.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PathTool</name>
    <message>
        <source>One vessel: click where it ends · Esc begins anew</source>
        <translation>Ein Gefäß: klicken, wo es endet · Esc beginnt neu</translation>
    </message>
    <message>
        <source>One vessel: click where it begins, then where it ends</source>
        <translation>Ein Gefäß: klicken, wo es beginnt, dann, wo es endet</translation>
    </message>
</context>
<context>
    <name>angiopose::app::MaskController</name>
    <message>
        <source>Stopped: the vessels are as they were</source>
        <translation>Angehalten: die Gefäße sind wie zuvor</translation>
    </message>
    <message>
        <source>Tracing the mask … %1 %</source>
        <translation>Maske wird erfasst … %1 %</translation>
    </message>
    <message>
        <source>Open a scan or a label image first.</source>
        <translation>Zuerst einen Scan oder ein Labelbild öffnen.</translation>
    </message>
    <message>
        <source>A registration is running. Stop it to edit.</source>
        <translation>Eine Registrierung läuft. Zum Bearbeiten anhalten.</translation>
    </message>
    <message>
        <source>Paint into the mask</source>
        <translation>In die Maske malen</translation>
    </message>
    <message>
        <source>Erase from the mask</source>
        <translation>In der Maske radieren</translation>
    </message>
    <message>
        <source>Nothing of the mask lies there.</source>
        <translation>Dort liegt nichts von der Maske.</translation>
    </message>
    <message>
        <source>Cut the mask</source>
        <translation>Maske schneiden</translation>
    </message>
    <message>
        <source>Tracing the mask …</source>
        <translation>Maske wird erfasst …</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Trace the edited mask</source>
        <translation>Bearbeitete Maske erfassen</translation>
    </message>
    <message>
        <source>Traced: 1 branch.</source>
        <translation>Erfasst: 1 Ast.</translation>
    </message>
    <message>
        <source>Traced: %1 branches.</source>
        <translation>Erfasst: %1 Äste.</translation>
    </message>
    <message>
        <source>Saved without the latest changes of the mask: trace the mask, then save again.</source>
        <translation>Ohne die letzten Änderungen der Maske gespeichert: Maske erfassen, dann noch einmal speichern.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MaskBrushTool</name>
    <message>
        <source>Paint: drag, Ctrl erases</source>
        <translation>Malen: ziehen, Strg radiert</translation>
    </message>
    <message>
        <source>Erase: drag, Ctrl paints</source>
        <translation>Radieren: ziehen, Strg malt</translation>
    </message>
    <message>
        <source>Shift+wheel, + and − change the brush</source>
        <translation>Umschalt+Rad, + und − ändern den Pinsel</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MaskCutTool</name>
    <message>
        <source>Scissors: draw around what goes · Shift keeps what lies inside</source>
        <translation>Schere: umfahren, was entfällt · Umschalt behält, was innen liegt</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MaskPanel</name>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Scissors</source>
        <translation>Schere</translation>
    </message>
    <message>
        <source>Ball, through the slices beside</source>
        <translation>Kugel, durch Nachbarschichten</translation>
    </message>
    <message>
        <source>Paint only above the threshold</source>
        <translation>Nur über der Schwelle malen</translation>
    </message>
    <message>
        <source>Trace the mask</source>
        <translation>Maske erfassen</translation>
    </message>
    <message>
        <source>Save mask …</source>
        <translation>Maske sichern …</translation>
    </message>
    <message>
        <source>Lumen mask</source>
        <translation>Gefäßmaske</translation>
    </message>
    <message>
        <source>Makes the vessels anew from the mask as it is.</source>
        <translation>Bildet die Gefäße neu aus der Maske, wie sie ist.</translation>
    </message>
    <message>
        <source>Writes the mask as a label image.</source>
        <translation>Schreibt die Maske als Labelbild.</translation>
    </message>
    <message>
        <source>this slice alone</source>
        <translation>nur diese Schicht</translation>
    </message>
    <message>
        <source>slices beside it</source>
        <translation>Nachbarschichten</translation>
    </message>
    <message>
        <source>whole depth</source>
        <translation>ganze Tiefe</translation>
    </message>
    <message>
        <source>Mask over the slices</source>
        <translation>Maske über den Schichten</translation>
    </message>
    <message>
        <source>How strong the mask is shown over the slices.</source>
        <translation>Wie kräftig die Maske über den Schichten liegt.</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>Radius des Pinsels</translation>
    </message>
    <message>
        <source>Brush radius</source>
        <translation>Pinselradius</translation>
    </message>
    <message>
        <source>How deep scissors cut</source>
        <translation>Wie tief die Schere schneidet</translation>
    </message>
    <message>
        <source>Depth on both sides of the slice</source>
        <translation>Tiefe beiderseits der Schicht</translation>
    </message>
    <message>
        <source>Tracing the mask …</source>
        <translation>Maske wird erfasst …</translation>
    </message>
    <message>
        <source>1 change of the mask is not in the vessels yet: trace the mask.</source>
        <translation>1 Änderung der Maske fehlt den Gefäßen noch: Maske erfassen.</translation>
    </message>
    <message>
        <source>%1 changes of the mask are not in the vessels yet: trace the mask.</source>
        <translation>%1 Änderungen der Maske fehlen den Gefäßen noch: Maske erfassen.</translation>
    </message>
    <message>
        <source>The vessels come from a mask edited by hand.</source>
        <translation>Die Gefäße stammen aus einer von Hand bearbeiteten Maske.</translation>
    </message>
    <message>
        <source>Paint and cut, then trace the mask. Each stroke can be undone.</source>
        <translation>Malen und schneiden, dann die Maske erfassen. Jeder Strich lässt sich rückgängig machen.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SliceMeasureTool</name>
    <message>
        <source>Length: drag, or click both ends · points can be moved</source>
        <translation>Länge: ziehen oder beide Enden anklicken · Punkte lassen sich verschieben</translation>
    </message>
    <message>
        <source>Angle: click an end, the vertex, the other end · points can be moved</source>
        <translation>Winkel: ein Ende, den Scheitel, das andere Ende anklicken · Punkte lassen sich verschieben</translation>
    </message>
    <message>
        <source>Area: click around it; double click or Enter closes · points can be moved</source>
        <translation>Fläche: ringsum klicken; Doppelklick oder Eingabe schließt · Punkte lassen sich verschieben</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ScanController</name>
    <message>
        <source>labels</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>vessels</source>
        <translation>Gefäße</translation>
    </message>
    <message>
        <source>vessels and bone</source>
        <translation>Gefäße und Knochen</translation>
    </message>
    <message>
        <source>vessels and tissue</source>
        <translation>Gefäße und Gewebe</translation>
    </message>
    <message>
        <source>Scan: %1</source>
        <translation>Scan: %1</translation>
    </message>
    <message>
        <source>Scan: off</source>
        <translation>Scan: aus</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ColumnRail</name>
    <message>
        <source>Unfold the column: %1</source>
        <translation>Spalte aufklappen: %1</translation>
    </message>
    <message>
        <source>Unfold: %1</source>
        <translation>Aufklappen: %1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::FoldButton</name>
    <message>
        <source>Fold the column: %1</source>
        <translation>Spalte einklappen: %1</translation>
    </message>
    <message>
        <source>Fold: %1</source>
        <translation>Einklappen: %1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ScanBar</name>
    <message>
        <source>How the scan is shown behind the vessels</source>
        <translation>Wie der Scan hinter den Gefäßen gezeigt wird</translation>
    </message>
    <message>
        <source>Opacity of the scan</source>
        <translation>Deckkraft des Scans</translation>
    </message>
</context>
<context>
    <name>angiopose::app::RecentController</name>
    <message>
        <source>Clear the list</source>
        <translation>Liste leeren</translation>
    </message>
</context>
<context>
    <name>angiopose::app::StudyController</name>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Could not open the folder</source>
        <translation>Der Ordner ließ sich nicht öffnen</translation>
    </message>
    <message>
        <source>Looking through %1 …</source>
        <translation>%1 wird durchgesehen …</translation>
    </message>
    <message>
        <source>Stopped after %1 of %2 files.</source>
        <translation>Nach %1 von %2 Dateien angehalten.</translation>
    </message>
    <message>
        <source>%1 files read.</source>
        <translation>Gelesene Dateien: %1.</translation>
    </message>
    <message>
        <source>The folder holds more than could be listed: choose the folder of one study.</source>
        <translation>Der Ordner enthält mehr, als sich auflisten ließ: bitte den Ordner einer Studie wählen.</translation>
    </message>
    <message>
        <source>The DICOMDIR is of no use (%1): the files themselves were read.</source>
        <translation>Das DICOMDIR ist nicht zu gebrauchen (%1): die Dateien selbst wurden gelesen.</translation>
    </message>
    <message>
        <source>Files that the DICOMDIR lists and that are missing: %1.</source>
        <translation>Dateien, die das DICOMDIR nennt und die fehlen: %1.</translation>
    </message>
    <message>
        <source>The DICOMDIR lists %1 series; 1 more file lies beside it.</source>
        <translation>Das DICOMDIR nennt %1 Serien; daneben liegt 1 weitere Datei.</translation>
    </message>
    <message>
        <source>The DICOMDIR lists %1 series; %2 more files lie beside it.</source>
        <translation>Das DICOMDIR nennt %1 Serien; daneben liegen %2 weitere Dateien.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::StudyRows</name>
    <message>
        <source>Patient %1 (identity hidden)</source>
        <translation>Patient %1 (Identität verborgen)</translation>
    </message>
    <message>
        <source>Without name</source>
        <translation>Ohne Namen</translation>
    </message>
    <message>
        <source>ID %1</source>
        <translation>ID %1</translation>
    </message>
    <message>
        <source>born %1</source>
        <translation>geboren %1</translation>
    </message>
    <message>
        <source>accession %1</source>
        <translation>Auftrag %1</translation>
    </message>
    <message>
        <source>Study without date or description</source>
        <translation>Studie ohne Datum und Beschreibung</translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 Bilder/s</translation>
    </message>
    <message>
        <source>Files that the DICOMDIR lists and that are missing: %1.</source>
        <translation>Dateien, die das DICOMDIR nennt und die fehlen: %1.</translation>
    </message>
    <message>
        <source>Not all files were read: which part of the series this is is known then.</source>
        <translation>Nicht alle Dateien wurden gelesen: Welcher Teil der Serie dies ist, steht erst dann fest.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::RecentList</name>
    <message>
        <source>No recent case has this in its name or folder.</source>
        <translation>Kein Fall der Liste hat das in Namen oder Ordner.</translation>
    </message>
    <message>
        <source>Small pictures</source>
        <translation>Kleine Bilder</translation>
    </message>
    <message>
        <source>Clear the list</source>
        <translation>Liste leeren</translation>
    </message>
    <message>
        <source>Search recent cases</source>
        <translation>Letzte Fälle durchsuchen</translation>
    </message>
    <message>
        <source>Keeps a small picture of each recent case in the program&apos;s cache folder.</source>
        <translation>Behält ein kleines Bild jedes Falls der Liste im Cache-Ordner des Programms.</translation>
    </message>
    <message>
        <source>Forgets these cases and removes their pictures, pinned ones stay; so do the files.</source>
        <translation>Vergisst diese Fälle und entfernt ihre Bilder; angeheftete bleiben, die Dateien auch.</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (fehlt)</translation>
    </message>
    <message>
        <source>%1 (inputs missing)</source>
        <translation>%1 (Eingaben fehlen)</translation>
    </message>
    <message>
        <source>Pinned: stays at the top of the list</source>
        <translation>Angeheftet: bleibt oben in der Liste</translation>
    </message>
    <message>
        <source>Pin to the top of the list</source>
        <translation>Oben in der Liste anheften</translation>
    </message>
    <message>
        <source>Pin %1</source>
        <translation>%1 anheften</translation>
    </message>
    <message>
        <source>Remove from the list; the file stays</source>
        <translation>Aus der Liste nehmen; die Datei bleibt</translation>
    </message>
    <message>
        <source>Remove %1 from the list</source>
        <translation>%1 aus der Liste nehmen</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::StudyBrowser</name>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Read them too</source>
        <translation>Auch lesen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Studies in %1</source>
        <translation>Studien in %1</translation>
    </message>
    <message>
        <source>Search by name, ID or description</source>
        <translation>Nach Name, ID oder Beschreibung suchen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Damaged files</source>
        <translation>Beschädigte Dateien</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>%1 of %2 files</source>
        <translation>%1 von %2 Dateien</translation>
    </message>
    <message>
        <source>%1 files found</source>
        <translation>Gefundene Dateien: %1</translation>
    </message>
    <message>
        <source>Damaged files: %1</source>
        <translation>Beschädigte Dateien: %1</translation>
    </message>
    <message>
        <source>Vessels: %1</source>
        <translation>Gefäße: %1</translation>
    </message>
    <message>
        <source>Views: %1</source>
        <translation>Ansichten: %1</translation>
    </message>
    <message>
        <source>Tick the scan with the vessels and the runs, or double-click one.</source>
        <translation>Die Aufnahme mit den Gefäßen und die Läufe ankreuzen, oder eine Zeile doppelt anklicken.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::StudyList</name>
    <message>
        <source>Patients, studies and series</source>
        <translation>Patienten, Studien und Serien</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalität</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Slices or rate</source>
        <translation>Abstand, Rate</translation>
    </message>
    <message>
        <source>Body part</source>
        <translation>Körperteil</translation>
    </message>
</context>
<context>
    <name>angiopose::app::MovieController</name>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>Could not export</source>
        <translation>Export nicht möglich</translation>
    </message>
    <message>
        <source>Writing the movie: %1 %</source>
        <translation>Der Film wird geschrieben: %1 %</translation>
    </message>
    <message>
        <source>Open vessels and an angiogram first.</source>
        <translation>Öffnen Sie zuerst Gefäße und ein Angiogramm.</translation>
    </message>
    <message>
        <source>Something else is under way. Let it end first.</source>
        <translation>Etwas anderes läuft gerade. Warten Sie, bis es endet.</translation>
    </message>
    <message>
        <source>Export movie</source>
        <translation>Film exportieren</translation>
    </message>
    <message>
        <source>GIF movies (*.gif)</source>
        <translation>GIF-Filme (*.gif)</translation>
    </message>
    <message>
        <source>MP4 movies (*.mp4)</source>
        <translation>MP4-Filme (*.mp4)</translation>
    </message>
    <message>
        <source>Writing the movie …</source>
        <translation>Der Film wird geschrieben …</translation>
    </message>
    <message>
        <source>Frames %1 to %2, back and forth</source>
        <translation>Bilder %1 bis %2, hin und zurück</translation>
    </message>
    <message>
        <source>Frames %1 to %2</source>
        <translation>Bilder %1 bis %2</translation>
    </message>
    <message>
        <source>the pose of this frame in all of them</source>
        <translation>in allen die Lage dieses Bildes</translation>
    </message>
    <message>
        <source>each with its followed pose</source>
        <translation>jedes mit seiner verfolgten Lage</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ReportController</name>
    <message>
        <source>There is nothing to report yet. Open vessels and an angiogram first.</source>
        <translation>Noch nichts zu berichten. Zuerst Gefäße und ein Angiogramm öffnen.</translation>
    </message>
    <message>
        <source>Report template</source>
        <translation>Berichtsvorlage</translation>
    </message>
    <message>
        <source>Templates (*.html *.htm)</source>
        <translation>Vorlagen (*.html *.htm)</translation>
    </message>
    <message>
        <source>Save report template</source>
        <translation>Berichtsvorlage speichern</translation>
    </message>
    <message>
        <source>Templates (*.html)</source>
        <translation>Vorlagen (*.html)</translation>
    </message>
    <message>
        <source>Export report</source>
        <translation>Bericht exportieren</translation>
    </message>
    <message>
        <source>Reports (*.pdf *.html)</source>
        <translation>Berichte (*.pdf *.html)</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MovieDialog</name>
    <message>
        <source>pictures a second</source>
        <translation>Bilder je Sekunde</translation>
    </message>
    <message>
        <source>Residual colours with their scale</source>
        <translation>Abweichungsfarben mit Skala</translation>
    </message>
    <message>
        <source>Patient identity in the pictures</source>
        <translation>Identität des Patienten in den Bildern</translation>
    </message>
    <message>
        <source>Texts in English</source>
        <translation>Texte auf Englisch</translation>
    </message>
    <message>
        <source>Export …</source>
        <translation>Exportieren …</translation>
    </message>
    <message>
        <source>Export movie</source>
        <translation>Film exportieren</translation>
    </message>
    <message>
        <source>MP4, for players and slides</source>
        <translation>MP4, für Abspielprogramme und Folien</translation>
    </message>
    <message>
        <source>GIF, for pages; starts again by itself</source>
        <translation>GIF, für Seiten; beginnt von selbst von vorn</translation>
    </message>
    <message>
        <source>Every picture says “Not for clinical use”, whose pose it shows, and whether that is trusted.</source>
        <translation>Jedes Bild sagt „Nicht für den klinischen Einsatz“, wessen Lage es zeigt und ob ihr zu trauen ist.</translation>
    </message>
    <message>
        <source>The overlay through the run</source>
        <translation>Die Überlagerung durch die Serie</translation>
    </message>
    <message>
        <source>How the registration converged</source>
        <translation>Wie die Registrierung zum Ziel kam</translation>
    </message>
    <message>
        <source>The vessels alone, turning once</source>
        <translation>Die Gefäße allein, einmal gedreht</translation>
    </message>
    <message>
        <source>Movie</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>%1 pictures, %2 s, %3 × %4 px</source>
        <translation>%1 Bilder, %2 s, %3 × %4 px</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ReportDialog</name>
    <message>
        <source>Built-in one</source>
        <translation>Eingebaute</translation>
    </message>
    <message>
        <source>Patient identity on the report</source>
        <translation>Name des Patienten im Bericht</translation>
    </message>
    <message>
        <source>Export report</source>
        <translation>Bericht exportieren</translation>
    </message>
    <message>
        <source>Reports are passed on. Without identity they name nobody.</source>
        <translation>Berichte werden weitergegeben. Ohne Identität nennen sie niemanden.</translation>
    </message>
    <message>
        <source>A template is a page of HTML with your letterhead and logo. Save the built-in one and change the copy: it tells how.</source>
        <translation>Eine Vorlage ist eine HTML-Seite mit Ihrem Briefkopf und Logo. Die eingebaute speichern und die Kopie ändern: Sie sagt, wie.</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>Save a copy …</source>
        <translation>Kopie speichern …</translation>
    </message>
    <message>
        <source>The built-in template, to be changed</source>
        <translation>Die eingebaute Vorlage, um sie zu ändern</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Export …</source>
        <translation>Exportieren …</translation>
    </message>
    <message>
        <source>built in</source>
        <translation>eingebaut</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::DicomDialog</name>
    <message>
        <source>Picture of the overlay (Secondary Capture)</source>
        <translation>Bild der Überlagerung (Secondary Capture)</translation>
    </message>
    <message>
        <source>Pictures of the run (Secondary Capture)</source>
        <translation>Bilder der Serie (Secondary Capture)</translation>
    </message>
    <message>
        <source>Report (PDF)</source>
        <translation>Bericht (PDF)</translation>
    </message>
    <message>
        <source>Vessels as lines on the stored image (Presentation State)</source>
        <translation>Gefäße als Linien auf dem gespeicherten Bild (Presentation State)</translation>
    </message>
    <message>
        <source>Pose (Spatial Registration)</source>
        <translation>Lage (Spatial Registration)</translation>
    </message>
    <message>
        <source>Vessels in the scan (Segmentation)</source>
        <translation>Gefäße im Scan (Segmentation)</translation>
    </message>
    <message>
        <source>Measurements (Structured Report)</source>
        <translation>Messungen (Structured Report)</translation>
    </message>
    <message>
        <source>Patient identity in pictures and report</source>
        <translation>Name des Patienten in Bildern und Bericht</translation>
    </message>
    <message>
        <source>Export …</source>
        <translation>Exportieren …</translation>
    </message>
    <message>
        <source>Export DICOM objects</source>
        <translation>DICOM-Objekte exportieren</translation>
    </message>
    <message>
        <source>A Spatial Registration is a rigid matrix: it cannot hold the perspective camera, which is written beside it as camera.json.</source>
        <translation>Eine Spatial Registration ist eine starre Matrix: Die perspektivische Kamera kann sie nicht enthalten; diese wird als camera.json daneben geschrieben.</translation>
    </message>
    <message>
        <source>Every object names the patient in its header, as its image does, whatever its pictures show. Each is a new instance in the study of its image.</source>
        <translation>Jedes Objekt nennt im Kopf den Patienten wie sein Bild, was auch immer seine Bilder zeigen. Jedes ist eine neue Instanz in der Studie seines Bildes.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Choose archive …</source>
        <translation>Archiv wählen …</translation>
    </message>
    <message>
        <source>Send to archive</source>
        <translation>An Archiv senden</translation>
    </message>
    <message>
        <source>A Spatial Registration is a rigid matrix: it cannot hold the perspective camera, which stands in its private elements. The file camera.json is not sent.</source>
        <translation>Eine Spatial Registration ist eine starre Matrix: Sie kann die perspektivische Kamera nicht enthalten, die in ihren privaten Elementen steht. Die Datei camera.json wird nicht gesendet.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::DicomController</name>
    <message>
        <source>There is nothing to export yet. Open a vessel tree and an angiogram first.</source>
        <translation>Es gibt noch nichts zu exportieren. Zuerst einen Gefäßbaum und ein Angiogramm öffnen.</translation>
    </message>
    <message>
        <source>Folder for the DICOM objects</source>
        <translation>Ordner für die DICOM-Objekte</translation>
    </message>
    <message>
        <source>There is nothing to send yet. Open a vessel tree and an angiogram first.</source>
        <translation>Es gibt noch nichts zu senden. Öffnen Sie zuerst einen Gefäßbaum und ein Angiogramm.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PackController</name>
    <message>
        <source>There is nothing to pack yet. Open a vessel tree and an angiogram first.</source>
        <translation>Noch gibt es nichts zu packen. Zuerst einen Gefäßbaum und ein Angiogramm öffnen.</translation>
    </message>
    <message>
        <source>Pack case for others</source>
        <translation>Fall für andere packen</translation>
    </message>
    <message>
        <source>Archives (*.zip)</source>
        <translation>Archive (*.zip)</translation>
    </message>
    <message>
        <source>A case is being packed already. Let that end, or stop it.</source>
        <translation>Es wird schon ein Fall gepackt. Abwarten oder stoppen.</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Packing …</source>
        <translation>Packe …</translation>
    </message>
    <message>
        <source>Packing: %1 %</source>
        <translation>Packe: %1 %</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PackDialog</name>
    <message>
        <source>Without identity</source>
        <translation>Ohne Identität</translation>
    </message>
    <message>
        <source>Dates shifted instead of removed</source>
        <translation>Daten verschoben statt entfernt</translation>
    </message>
    <message>
        <source>Black out letters in the pictures</source>
        <translation>Buchstaben in den Bildern schwärzen</translation>
    </message>
    <message>
        <source>Pack case for others</source>
        <translation>Fall für andere packen</translation>
    </message>
    <message>
        <source>made up</source>
        <translation>erfunden</translation>
    </message>
    <message>
        <source>Name instead</source>
        <translation>Name stattdessen</translation>
    </message>
    <message>
        <source>One archive with the case, its inputs and its results. Without identity: no names, IDs, dates, private elements and notes; UIDs are replaced. Names of branches stay. Look at every picture before you hand it on.</source>
        <translation>Ein Archiv mit dem Fall, seinen Eingaben und Ergebnissen. Ohne Identität: keine Namen, IDs, Daten, privaten Elemente und Notizen; UIDs sind andere. Namen von Ästen bleiben. Vor dem Weitergeben jedes Bild ansehen.</translation>
    </message>
    <message>
        <source>Pack …</source>
        <translation>Packen …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveCache</name>
    <message>
        <source>empty</source>
        <translation>leer</translation>
    </message>
    <message>
        <source>The cache is empty. Objects dropped: %1.</source>
        <translation>Der Zwischenspeicher ist leer. Verworfene Objekte: %1.</translation>
    </message>
    <message>
        <source>Keep less than is there?</source>
        <translation>Weniger behalten, als da ist?</translation>
    </message>
    <message>
        <source>The cache holds %1. What was not used for the longest time is dropped until %2 are left.</source>
        <translation>Der Zwischenspeicher enthält %1. Am längsten Unbenutztes wird verworfen, bis %2 übrig sind.</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Empty the cache?</source>
        <translation>Zwischenspeicher leeren?</translation>
    </message>
    <message>
        <source>All that was retrieved is dropped. Cases whose images lie there ask for them when they are opened; “Pack case for others” keeps case and images together.</source>
        <translation>Alles Abgerufene wird verworfen. Fälle, deren Bilder dort liegen, fragen beim Öffnen danach; „Fall für andere packen“ hält Fall und Bilder zusammen.</translation>
    </message>
    <message>
        <source>Empty</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Emptying the cache …</source>
        <translation>Zwischenspeicher wird geleert …</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveController</name>
    <message>
        <source>what arrived on port %1</source>
        <translation>was an Port %1 ankam</translation>
    </message>
    <message>
        <source>Objects that arrived: %1</source>
        <translation>Angekommene Objekte: %1</translation>
    </message>
    <message>
        <source>Nothing arrived yet</source>
        <translation>Noch nichts angekommen</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveEcho</name>
    <message>
        <source>Stopped.</source>
        <translation>Angehalten.</translation>
    </message>
    <message>
        <source>Asking %1 …</source>
        <translation>%1 wird gefragt …</translation>
    </message>
    <message>
        <source>%1 answers, and lets this program in.</source>
        <translation>%1 antwortet und lässt dieses Programm ein.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveFinder</name>
    <message>
        <source>Stopped.</source>
        <translation>Angehalten.</translation>
    </message>
    <message>
        <source>Search, choose studies or series, then retrieve them.</source>
        <translation>Suchen, Studien oder Serien wählen, dann abrufen.</translation>
    </message>
    <message>
        <source>“%1” is no date. Write year, month and day: 2024-01-31.</source>
        <translation>„%1“ ist kein Datum. Schreiben Sie Jahr, Monat und Tag: 2024-01-31.</translation>
    </message>
    <message>
        <source>Searching in %1 …</source>
        <translation>%1 wird durchsucht …</translation>
    </message>
    <message>
        <source>%1 holds no such study. Ask for less: a shorter name, more days, any modality.</source>
        <translation>%1 enthält keine solche Studie. Verlangen Sie weniger: einen kürzeren Namen, mehr Tage, jede Modalität.</translation>
    </message>
    <message>
        <source>Search to see what %1 holds.</source>
        <translation>Suchen Sie, um zu sehen, was %1 enthält.</translation>
    </message>
    <message>
        <source>1 study found.</source>
        <translation>1 Studie gefunden.</translation>
    </message>
    <message>
        <source>%1 studies found.</source>
        <translation>%1 Studien gefunden.</translation>
    </message>
    <message>
        <source>Choose studies, or unfold one for its series; several with Ctrl.</source>
        <translation>Studien wählen oder eine für ihre Serien aufklappen; mehrere mit Strg.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveNodes</name>
    <message>
        <source>There is an archive of this name already. Choose another name.</source>
        <translation>Ein Archiv dieses Namens gibt es schon. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Remove %1 from the list?</source>
        <translation>%1 aus der Liste entfernen?</translation>
    </message>
    <message>
        <source>The archive itself and what was retrieved from it stay.</source>
        <translation>Das Archiv selbst und was daraus abgerufen wurde bleiben.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveRetrieval</name>
    <message>
        <source>Asking %1 …</source>
        <translation>%1 wird gefragt …</translation>
    </message>
    <message>
        <source>Stopping …</source>
        <translation>Wird angehalten …</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Angehalten.</translation>
    </message>
    <message>
        <source>%1 of %2 objects, %3</source>
        <translation>%1 von %2 Objekten, %3</translation>
    </message>
    <message>
        <source>Study %1 of %2: %3</source>
        <translation>Studie %1 von %2: %3</translation>
    </message>
    <message>
        <source>%1 of %2 objects are here.</source>
        <translation>%1 von %2 Objekten sind hier.</translation>
    </message>
    <message>
        <source>Retrieve again to get the others.</source>
        <translation>Rufen Sie noch einmal ab, um die übrigen zu bekommen.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveSender</name>
    <message>
        <source>Stopping …</source>
        <translation>Wird angehalten …</translation>
    </message>
    <message>
        <source>Making the objects …</source>
        <translation>Objekte werden erzeugt …</translation>
    </message>
    <message>
        <source>Sent: %1 of %2 objects, %3</source>
        <translation>Gesendet: %1 von %2 Objekten, %3</translation>
    </message>
    <message>
        <source>%1 has all objects: %2 (%3).</source>
        <translation>%1 hat alle Objekte: %2 (%3).</translation>
    </message>
    <message>
        <source>%1 of %2 objects arrived.</source>
        <translation>%1 von %2 Objekten sind angekommen.</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Angehalten.</translation>
    </message>
    <message>
        <source>Send again for the others.</source>
        <translation>Senden Sie noch einmal für die übrigen.</translation>
    </message>
    <message>
        <source>Stopped. Nothing was sent.</source>
        <translation>Angehalten. Nichts wurde gesendet.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveWords</name>
    <message>
        <source>Without name</source>
        <translation>Ohne Namen</translation>
    </message>
    <message>
        <source>Patient %1 (identity hidden)</source>
        <translation>Patient %1 (Identität verborgen)</translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>Faults beside this one: %1.</source>
        <translation>Fehler außer diesem: %1.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ArchiveDialog</name>
    <message>
        <source>Open what came</source>
        <translation>Angekommenes öffnen</translation>
    </message>
    <message>
        <source>Retrieve</source>
        <translation>Abrufen</translation>
    </message>
    <message>
        <source>Open from archive</source>
        <translation>Aus Archiv öffnen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Choose from the objects that arrived</source>
        <translation>Aus den angekommenen Objekten wählen</translation>
    </message>
    <message>
        <source>Bring the chosen studies and series here, then choose which are vessels and which views</source>
        <translation>Die gewählten Studien und Serien herholen, dann wählen, was Gefäße und was Ansichten sind</translation>
    </message>
    <message>
        <source>No archive is known yet. Add one: who runs it tells you host, port and AE title.</source>
        <translation>Noch ist kein Archiv bekannt. Fügen Sie eines hinzu: Wer es betreibt, nennt Ihnen Host, Port und AE-Titel.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::CacheLine</name>
    <message>
        <source>Empty …</source>
        <translation>Leeren …</translation>
    </message>
    <message>
        <source>Most that the cache keeps</source>
        <translation>So viel behält der Zwischenspeicher höchstens</translation>
    </message>
    <message>
        <source>What was not used for the longest time is dropped first</source>
        <translation>Am längsten Unbenutztes wird zuerst verworfen</translation>
    </message>
    <message>
        <source>Drop all that was retrieved</source>
        <translation>Alles Abgerufene verwerfen</translation>
    </message>
    <message>
        <source>of at most</source>
        <translation>von höchstens</translation>
    </message>
    <message>
        <source>Cache: %1</source>
        <translation>Zwischenspeicher: %1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MatchList</name>
    <message>
        <source>Studies and series in the archive</source>
        <translation>Studien und Serien im Archiv</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalität</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Looking …</source>
        <translation>Wird gesucht …</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::NodeBar</name>
    <message>
        <source>Test connection</source>
        <translation>Verbindung testen</translation>
    </message>
    <message>
        <source>Add …</source>
        <translation>Hinzufügen …</translation>
    </message>
    <message>
        <source>Edit …</source>
        <translation>Bearbeiten …</translation>
    </message>
    <message>
        <source>Remove …</source>
        <translation>Entfernen …</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archiv</translation>
    </message>
    <message>
        <source>No archive yet</source>
        <translation>Noch kein Archiv</translation>
    </message>
    <message>
        <source>Ask whether the archive answers and lets us in</source>
        <translation>Fragen, ob das Archiv antwortet und uns einlässt</translation>
    </message>
    <message>
        <source>Add an archive to the list; the command line uses the same list</source>
        <translation>Ein Archiv zur Liste hinzufügen; die Befehlszeile benutzt dieselbe Liste</translation>
    </message>
    <message>
        <source>Host, port, titles, security</source>
        <translation>Host, Port, Titel, Sicherheit</translation>
    </message>
    <message>
        <source>Take the archive from the list</source>
        <translation>Das Archiv aus der Liste nehmen</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::NodeDialog</name>
    <message>
        <source>File with the authorization</source>
        <translation>Datei mit der Berechtigung</translation>
    </message>
    <message>
        <source>Encrypted (TLS)</source>
        <translation>Verschlüsselt (TLS)</translation>
    </message>
    <message>
        <source>Certificates of authorities (PEM)</source>
        <translation>Zertifikate der Aussteller (PEM)</translation>
    </message>
    <message>
        <source>Our certificate (PEM)</source>
        <translation>Unser Zertifikat (PEM)</translation>
    </message>
    <message>
        <source>Key of our certificate (PEM)</source>
        <translation>Schlüssel unseres Zertifikats (PEM)</translation>
    </message>
    <message>
        <source>Its certificate must be one of the host</source>
        <translation>Sein Zertifikat muss das des Hosts sein</translation>
    </message>
    <message>
        <source>Security, DICOMweb and more</source>
        <translation>Sicherheit, DICOMweb und mehr</translation>
    </message>
    <message>
        <source>Test connection</source>
        <translation>Verbindung testen</translation>
    </message>
    <message>
        <source>Add archive</source>
        <translation>Archiv hinzufügen</translation>
    </message>
    <message>
        <source>Edit archive</source>
        <translation>Archiv bearbeiten</translation>
    </message>
    <message>
        <source>Ask who runs the archive for these, and have our AE title entered there.</source>
        <translation>Fragen Sie, wer das Archiv betreibt, danach, und lassen Sie unseren AE-Titel dort eintragen.</translation>
    </message>
    <message>
        <source>PACS of radiology</source>
        <translation>PACS der Radiologie</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>What you call it</source>
        <translation>Wie Sie es nennen</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Host</translation>
    </message>
    <message>
        <source>Name or address of its computer; empty where it is asked by DICOMweb only</source>
        <translation>Name oder Adresse seines Rechners; leer, wo es nur über DICOMweb gefragt wird</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>104 or 11112 as a rule</source>
        <translation>In der Regel 104 oder 11112</translation>
    </message>
    <message>
        <source>Its AE title</source>
        <translation>Sein AE-Titel</translation>
    </message>
    <message>
        <source>By which the archive wants to be called</source>
        <translation>Unter dem das Archiv angesprochen werden will</translation>
    </message>
    <message>
        <source>Our AE title</source>
        <translation>Unser AE-Titel</translation>
    </message>
    <message>
        <source>By which the archive knows this program</source>
        <translation>Unter dem das Archiv dieses Programm kennt</translation>
    </message>
    <message>
        <source>Authorities</source>
        <translation>Aussteller</translation>
    </message>
    <message>
        <source>PEM file; empty: those that the system trusts</source>
        <translation>PEM-Datei; leer: die, denen das System vertraut</translation>
    </message>
    <message>
        <source>Our certificate</source>
        <translation>Unser Zertifikat</translation>
    </message>
    <message>
        <source>PEM file; empty: none</source>
        <translation>PEM-Datei; leer: keines</translation>
    </message>
    <message>
        <source>Its key</source>
        <translation>Sein Schlüssel</translation>
    </message>
    <message>
        <source>PEM file; only its path is stored</source>
        <translation>PEM-Datei; nur ihr Pfad wird gespeichert</translation>
    </message>
    <message>
        <source>DICOMweb address</source>
        <translation>DICOMweb-Adresse</translation>
    </message>
    <message>
        <source>Used where no host is given</source>
        <translation>Benutzt, wo kein Host angegeben ist</translation>
    </message>
    <message>
        <source>Authorization</source>
        <translation>Berechtigung</translation>
    </message>
    <message>
        <source>File whose first line is sent as the header Authorization; only its path is stored</source>
        <translation>Datei, deren erste Zeile als Header Authorization gesendet wird; nur ihr Pfad wird gespeichert</translation>
    </message>
    <message>
        <source>Port for C-MOVE</source>
        <translation>Port für C-MOVE</translation>
    </message>
    <message>
        <source>Only where the archive does not offer C-GET: it sends to this port of ours. 0: not used</source>
        <translation>Nur wo das Archiv kein C-GET anbietet: Es sendet an diesen Port von uns. 0: unbenutzt</translation>
    </message>
    <message>
        <source>Time for an answer</source>
        <translation>Zeit für eine Antwort</translation>
    </message>
    <message>
        <source>Afterwards the archive counts as dead</source>
        <translation>Danach gilt das Archiv als tot</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PathField</name>
    <message>
        <source>Choose a file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>Choose a file: %1</source>
        <translation>Datei wählen: %1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ReceiveLine</name>
    <message>
        <source>Receive on port</source>
        <translation>Empfangen an Port</translation>
    </message>
    <message>
        <source>Look at them</source>
        <translation>Ansehen</translation>
    </message>
    <message>
        <source>Take what modalities and archives push to this computer, until switched off or the window closes</source>
        <translation>Nehmen, was Modalitäten und Archive an diesen Rechner schicken, bis es ausgeschaltet wird oder das Fenster schließt</translation>
    </message>
    <message>
        <source>Port to receive on</source>
        <translation>Port zum Empfangen</translation>
    </message>
    <message>
        <source>AE title to receive as</source>
        <translation>AE-Titel zum Empfangen</translation>
    </message>
    <message>
        <source>Callers must use this AE title</source>
        <translation>Anrufer müssen diesen AE-Titel benutzen</translation>
    </message>
    <message>
        <source>Choose from what came</source>
        <translation>Aus dem Angekommenen wählen</translation>
    </message>
    <message>
        <source>as AE title</source>
        <translation>als AE-Titel</translation>
    </message>
    <message>
        <source>Security …</source>
        <translation>Sicherheit …</translation>
    </message>
    <message>
        <source>Who may call this port, and encryption (TLS)</source>
        <translation>Wer diesen Port anrufen darf, und Verschlüsselung (TLS)</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SearchFields</name>
    <message>
        <source>Meier, or *mei*</source>
        <translation>Meier, oder *mei*</translation>
    </message>
    <message>
        <source>Beginning of the name; * and ? stand for any letters</source>
        <translation>Anfang des Namens; * und ? stehen für beliebige Zeichen</translation>
    </message>
    <message>
        <source>The patient&apos;s ID; * and ? stand for any letters</source>
        <translation>Die ID des Patienten; * und ? stehen für beliebige Zeichen</translation>
    </message>
    <message>
        <source>2024-01-31</source>
        <translation>2024-01-31</translation>
    </message>
    <message>
        <source>Studies of this day and later; empty: from the beginning</source>
        <translation>Studien von diesem Tag an; leer: von Anfang an</translation>
    </message>
    <message>
        <source>Studies of this day and earlier; empty: until today</source>
        <translation>Studien bis zu diesem Tag; leer: bis heute</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Jede</translation>
    </message>
    <message>
        <source>XA: angiograms, CT: scans</source>
        <translation>XA: Angiogramme, CT: Schichtbilder</translation>
    </message>
    <message>
        <source>List the studies of the archive to which all of this applies</source>
        <translation>Die Studien des Archivs auflisten, auf die alles zutrifft</translation>
    </message>
    <message>
        <source>Patient&apos;s name</source>
        <translation>Name des Patienten</translation>
    </message>
    <message>
        <source>Patient ID</source>
        <translation>Patienten-ID</translation>
    </message>
    <message>
        <source>Study date from</source>
        <translation>Studiendatum von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalität</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SendDialog</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Senden</translation>
    </message>
    <message>
        <source>Send to archive</source>
        <translation>An Archiv senden</translation>
    </message>
    <message>
        <source>The objects are made once. Sending them again after a fault sends the same ones, so that none is in the archive twice.</source>
        <translation>Die Objekte werden einmal erzeugt. Wird nach einem Fehler noch einmal gesendet, gehen dieselben, damit keines zweimal im Archiv liegt.</translation>
    </message>
    <message>
        <source>No archive is known yet. Add one: who runs it tells you host, port and AE title.</source>
        <translation>Noch ist kein Archiv bekannt. Fügen Sie eines hinzu: Wer es betreibt, nennt Ihnen Host, Port und AE-Titel.</translation>
    </message>
    <message>
        <source>The objects go to %1 when you send them.</source>
        <translation>Die Objekte gehen an %1, wenn Sie sie senden.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::TransferLine</name>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>End it; what is whole is kept</source>
        <translation>Beenden; was ganz da ist, bleibt</translation>
    </message>
</context>
<context>
    <name>angiopose::app::DeidentifyController</name>
    <message>
        <source>Taking identity out: %1 %</source>
        <translation>Identität wird entfernt: %1 %</translation>
    </message>
    <message>
        <source>Files are being written already. Let that end, or stop it.</source>
        <translation>Es werden schon Dateien geschrieben. Abwarten oder stoppen.</translation>
    </message>
    <message>
        <source>Files to de-identify</source>
        <translation>Dateien ohne Identität schreiben</translation>
    </message>
    <message>
        <source>Folder to de-identify</source>
        <translation>Ordner ohne Identität schreiben</translation>
    </message>
    <message>
        <source>Folder to write to</source>
        <translation>Ordner, in den geschrieben wird</translation>
    </message>
    <message>
        <source>Taking identity out …</source>
        <translation>Identität wird entfernt …</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Written without identity: %1, in %2.</source>
        <translation>Ohne Identität geschrieben: %1, in %2.</translation>
    </message>
    <message>
        <source>%1 files were written without identity, %2 were not, for the reasons below. What was written lies in %3.</source>
        <translation>%1 Dateien wurden ohne Identität geschrieben, %2 nicht; die Gründe stehen unten. Das Geschriebene liegt in %3.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PrivacyController</name>
    <message>
        <source>No list and no pictures of recent cases, no names in the title, no folders remembered.</source>
        <translation>Keine Liste und keine Bilder letzter Fälle, keine Namen im Titel, keine gemerkten Ordner.</translation>
    </message>
    <message>
        <source>Turn private mode on?</source>
        <translation>Privaten Modus einschalten?</translation>
    </message>
    <message>
        <source>The list of recent cases, pinned ones too, their pictures and the folders and names remembered so far are forgotten for good. Nothing of the kind is kept until private mode is turned off. Automatic copies of unsaved work are still made, and removed when a case is closed.</source>
        <translation>Die Liste der letzten Fälle, auch der angehefteten, ihre Bilder und die bisher gemerkten Ordner und Namen werden endgültig vergessen. Nichts dergleichen wird aufgehoben, bis der private Modus ausgeschaltet wird. Automatische Kopien ungesicherter Arbeit werden weiter angelegt und beim Schließen eines Falls entfernt.</translation>
    </message>
    <message>
        <source>Turn on</source>
        <translation>Einschalten</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>angiopose::app::AuditController</name>
    <message>
        <source>One line for everything that is opened, saved and exported: when, by whom, with the SHA-256 of the files.</source>
        <translation>Eine Zeile für alles, was geöffnet, gespeichert und exportiert wird: wann, von wem, mit der SHA-256 der Dateien.</translation>
    </message>
    <message>
        <source>Written to %1</source>
        <translation>Geschrieben in %1</translation>
    </message>
    <message>
        <source>Keep an audit file</source>
        <translation>Audit-Datei führen</translation>
    </message>
    <message>
        <source>Audit files (*.jsonl)</source>
        <translation>Audit-Dateien (*.jsonl)</translation>
    </message>
</context>
<context>
    <name>angiopose::app::SupportController</name>
    <message>
        <source>Save support bundle</source>
        <translation>Supportpaket speichern</translation>
    </message>
    <message>
        <source>Archives (*.zip)</source>
        <translation>Archive (*.zip)</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::FaultBar</name>
    <message>
        <source>Save support bundle …</source>
        <translation>Supportpaket speichern …</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>AngioPose ended by a fault last time. A note of where in the program, with nothing of the case in it, lies in %1.</source>
        <translation>AngioPose wurde zuletzt durch einen Fehler beendet. Eine Notiz, wo im Programm das war, ohne etwas vom Fall, liegt in %1.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SupportDialog</name>
    <message>
        <source>Save support bundle</source>
        <translation>Supportpaket speichern</translation>
    </message>
    <message>
        <source>These texts go into the archive, and nothing else: no image, no vessels. Names, numbers, dates and paths that are known of the cases of this session and of this computer were taken out. Read them before you hand them on.</source>
        <translation>Diese Texte kommen in das Archiv und sonst nichts: kein Bild, keine Gefäße. Namen, Nummern, Daten und Pfade, die von den Fällen dieser Sitzung und von diesem Computer bekannt sind, wurden entfernt. Lesen Sie sie, bevor Sie sie weitergeben.</translation>
    </message>
    <message>
        <source>Texts of the bundle</source>
        <translation>Texte des Pakets</translation>
    </message>
    <message>
        <source>The text as it is written</source>
        <translation>Der Text, wie er geschrieben wird</translation>
    </message>
    <message>
        <source>Save …</source>
        <translation>Speichern …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::DeidentifyDialog</name>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Dates shifted instead of removed</source>
        <translation>Daten verschoben statt entfernt</translation>
    </message>
    <message>
        <source>Black out letters in the pictures</source>
        <translation>Buchstaben in den Bildern schwärzen</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>De-identify files</source>
        <translation>Dateien ohne Identität</translation>
    </message>
    <message>
        <source>DICOM images and objects, PNG, JPEG and TIFF are written anew without names, IDs, dates, private elements and texts; UIDs are replaced. Other files are refused, and which is said. Look at every picture before you hand it on.</source>
        <translation>DICOM-Bilder und -Objekte, PNG, JPEG und TIFF werden neu geschrieben, ohne Namen, Nummern, Daten, private Elemente und Texte; UIDs werden ersetzt. Andere Dateien werden abgelehnt und genannt. Sehen Sie jedes Bild an, bevor Sie es weitergeben.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Files and folders</source>
        <translation>Dateien und Ordner</translation>
    </message>
    <message>
        <source>Add files …</source>
        <translation>Dateien hinzufügen …</translation>
    </message>
    <message>
        <source>Add folder …</source>
        <translation>Ordner hinzufügen …</translation>
    </message>
    <message>
        <source>made up</source>
        <translation>erfunden</translation>
    </message>
    <message>
        <source>a new or empty folder</source>
        <translation>ein neuer oder leerer Ordner</translation>
    </message>
    <message>
        <source>Folder to write to</source>
        <translation>Ordner, in den geschrieben wird</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Auswählen …</translation>
    </message>
    <message>
        <source>Name instead</source>
        <translation>Name stattdessen</translation>
    </message>
    <message>
        <source>Write to</source>
        <translation>Schreiben nach</translation>
    </message>
</context>
</TS>
