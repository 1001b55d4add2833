<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>angiopose::app::AuxiliaryController</name>
    <message>
        <source>No auxiliary branches selected: the method AngioPose weights all branches equally. If auxiliary branches are selected, they determine the pose components that they constrain; the other branches determine the remaining components.</source>
        <translation>Keine Hilfsäste gewählt: Die Methode AngioPose gewichtet alle Äste gleich. Sind Hilfsäste gewählt, bestimmen sie die Lagekomponenten, die sie festlegen; die übrigen Äste bestimmen die restlichen Komponenten.</translation>
    </message>
    <message>
        <source>%1 In the method AngioPose, these branches determine the pose components that they constrain; the other branches determine the remaining components. The result also reports the fit of all branches. If confidence is low, AngioPose also tries poses found from these branches alone.</source>
        <translation>%1 In der Methode AngioPose bestimmen diese Äste die Lagekomponenten, die sie festlegen; die übrigen Äste bestimmen die restlichen Komponenten. Das Ergebnis nennt auch die Anpassung aller Äste. Bei geringer Konfidenz prüft AngioPose auch Lagen, die allein aus diesen Ästen gefunden wurden.</translation>
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
        <source>horizontal</source>
        <translation>horizontal</translation>
    </message>
    <message>
        <source>vertical</source>
        <translation>vertikal</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>No branch lies mostly inside the lasso.</source>
        <translation>Kein Ast liegt überwiegend im Lasso.</translation>
    </message>
    <message>
        <source>This tree has no generation data.</source>
        <translation>Dieser Gefäßbaum enthält keine Generationen.</translation>
    </message>
    <message>
        <source>No branch reaches this radius.</source>
        <translation>Kein Ast erreicht diesen Radius.</translation>
    </message>
    <message>
        <source>No auxiliary branches selected: the method uses the %1 nodes of the tree as auxiliary points.</source>
        <translation>Keine Hilfsäste gewählt: Die Methode verwendet die %1 Knoten des Gefäßbaums als Hilfspunkte.</translation>
    </message>
    <message>
        <source>Auxiliary: %1 (%2 mm, %3 % of the tree).</source>
        <translation>Hilfsäste: %1 (%2 mm, %3 % des Gefäßbaums).</translation>
    </message>
    <message>
        <source>%1 The current method ignores this selection and uses all branches.</source>
        <translation>%1 Die aktuelle Methode beachtet diese Auswahl nicht und verwendet alle Äste.</translation>
    </message>
    <message>
        <source>%1 The method option “Auxiliary points” takes precedence.</source>
        <translation>%1 Die Methodenoption „Hilfspunkte“ hat Vorrang.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::BlindTrialController</name>
    <message>
        <source>A blind trial requires vessels, an angiogram and an initial pose. No registration may be running.</source>
        <translation>Ein Blindversuch erfordert Gefäße, ein Angiogramm und eine Startlage. Es darf keine Registrierung laufen.</translation>
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
        <source>Save blind trial</source>
        <translation>Blindversuch speichern</translation>
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
        <source>At least one branch must remain.</source>
        <translation>Mindestens ein Ast muss übrig bleiben.</translation>
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
        <source>No branch is completely visible. Zoom out or pan the image.</source>
        <translation>Kein Ast ist vollständig sichtbar. Verkleinern oder verschieben Sie das Bild.</translation>
    </message>
    <message>
        <source>This tree has no radii.</source>
        <translation>Dieser Gefäßbaum enthält keine Radien.</translation>
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
        <source>A registration is running. Stop it before editing.</source>
        <translation>Eine Registrierung läuft. Halten Sie sie vor dem Bearbeiten an.</translation>
    </message>
    <message>
        <source>Could not trace the vessels</source>
        <translation>Gefäße konnten nicht erfasst werden</translation>
    </message>
    <message>
        <source>Support bundle saved: %1</source>
        <translation>Supportpaket gespeichert: %1</translation>
    </message>
    <message>
        <source>Could not save the support bundle</source>
        <translation>Supportpaket konnte nicht gespeichert werden</translation>
    </message>
</context>
<context>
    <name>angiopose::app::CaseReport</name>
    <message>
        <source>Registered</source>
        <translation>Registriert</translation>
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
        <source>Coverage of traced vessels</source>
        <translation>Abdeckung der erkannten Gefäße</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>none: this is the initial pose</source>
        <translation>keine: dies ist die Startlage</translation>
    </message>
    <message>
        <source>Registered in</source>
        <translation>Registriert in</translation>
    </message>
    <message>
        <source>frame %1; image and values from frame %2</source>
        <translation>Bild %1; Ansicht und Werte aus Bild %2</translation>
    </message>
    <message>
        <source>pose set manually</source>
        <translation>Lage manuell gesetzt</translation>
    </message>
    <message>
        <source>edited manually</source>
        <translation>manuell bearbeitet</translation>
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
        <source>Worst %1 of %2 branches</source>
        <translation>Die schlechtesten %1 von %2 Ästen</translation>
    </message>
    <message>
        <source>Branches, worst first</source>
        <translation>Äste, schlechtester zuerst</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometrie</translation>
    </message>
    <message>
        <source>Pose (patient to camera), mm</source>
        <translation>Lage (Patient → Kamera), mm</translation>
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
        <source>Created</source>
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
        <source>, narrowest point %1 mm (−%2 %)</source>
        <translation>, engste Stelle %1 mm (−%2 %)</translation>
    </message>
    <message>
        <source>Target points and rings</source>
        <translation>Zielpunkte und Ringe</translation>
    </message>
    <message>
        <source>traced from a manually edited lumen mask</source>
        <translation>aus einer manuell bearbeiteten Gefäßmaske erfasst</translation>
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
        <source>Before: initial pose</source>
        <translation>Vorher: Startlage</translation>
    </message>
    <message>
        <source>After: registered</source>
        <translation>Nachher: registriert</translation>
    </message>
    <message>
        <source>After: pose set manually</source>
        <translation>Nachher: Lage manuell gesetzt</translation>
    </message>
    <message>
        <source>Colors: distance to the vessels traced in the image</source>
        <translation>Farben: Abstand zu den im Bild erkannten Gefäßen</translation>
    </message>
    <message>
        <source>farther</source>
        <translation>weiter entfernt</translation>
    </message>
    <message>
        <source>Reliable</source>
        <translation>Verlässlich</translation>
    </message>
    <message>
        <source>Not reliable</source>
        <translation>Nicht verlässlich</translation>
    </message>
    <message>
        <source>This pose may be wrong. Do not use it without verification.</source>
        <translation>Diese Lage kann falsch sein. Verwenden Sie sie nicht ungeprüft.</translation>
    </message>
    <message>
        <source>All checks passed. This is not proof: inspect the overlay.</source>
        <translation>Alle Prüfungen bestanden. Das ist kein Beweis: Prüfen Sie die Überlagerung.</translation>
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
        <source>Stop it and close? Unsaved changes to this case will be lost.</source>
        <translation>Anhalten und schließen? Ungespeicherte Änderungen an diesem Fall gehen verloren.</translation>
    </message>
    <message>
        <source>Save before closing?</source>
        <translation>Vor dem Schließen speichern?</translation>
    </message>
    <message>
        <source>“%1” has unsaved changes.</source>
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
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>“%1” has no angiogram yet. Only its vessels can be saved, as centerlines.</source>
        <translation>„%1“ hat noch kein Angiogramm. Nur die Gefäße lassen sich speichern, als Mittellinien.</translation>
    </message>
    <message>
        <source>Save vessels and close</source>
        <translation>Gefäße speichern und schließen</translation>
    </message>
    <message>
        <source>Close without saving?</source>
        <translation>Ohne Speichern schließen?</translation>
    </message>
    <message>
        <source>“%1” has no vessels yet, so there is no case to save. Unsaved work will be lost.</source>
        <translation>„%1“ hat noch keine Gefäße, daher gibt es keinen Fall zu speichern. Ungespeicherte Arbeit geht verloren.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::CurveController</name>
    <message>
        <source>At least one curve must remain as the registration target.</source>
        <translation>Mindestens eine Kurve muss als Ziel der Registrierung bleiben.</translation>
    </message>
    <message>
        <source>Keep suspect curve</source>
        <translation>Fragliche Kurve behalten</translation>
    </message>
    <message>
        <source>The edited curves of frame %1 were replaced. Undo restores them.</source>
        <translation>Die bearbeiteten Kurven von Bild %1 wurden ersetzt. „Rückgängig“ stellt sie wieder her.</translation>
    </message>
    <message>
        <source>Trace this frame again?</source>
        <translation>Dieses Bild neu erfassen?</translation>
    </message>
    <message>
        <source>Its edited or imported curves will be replaced. Undo restores them.</source>
        <translation>Bearbeitete oder importierte Kurven werden ersetzt. „Rückgängig“ stellt sie wieder her.</translation>
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
        <source>If only a guidewire is visible, use the method “Guidewire or catheter”, which uses every curve.</source>
        <translation>Wenn nur ein Führungsdraht sichtbar ist, verwenden Sie die Methode „Führungsdraht oder Katheter“; sie nutzt jede Kurve.</translation>
    </message>
    <message>
        <source>Mark curve as device</source>
        <translation>Kurve als Instrument markieren</translation>
    </message>
    <message>
        <source>Mark curve as vessel</source>
        <translation>Kurve als Gefäß markieren</translation>
    </message>
    <message>
        <source>Track device</source>
        <translation>Instrument verfolgen</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ExportController</name>
    <message>
        <source>3D Slicer points (*.fcsv *.mrk.json)</source>
        <translation>3D-Slicer-Punkte (*.fcsv *.mrk.json)</translation>
    </message>
    <message>
        <source>Poses with camera (*.txt *.yml *.xml)</source>
        <translation>Lagen mit Kamera (*.txt *.yml *.xml)</translation>
    </message>
    <message>
        <source>Vector graphics (*.svg)</source>
        <translation>Vektorgrafiken (*.svg)</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>PDF-Dokumente (*.pdf)</translation>
    </message>
    <message>
        <source>There is nothing to export yet. Open a vessel tree and an angiogram first.</source>
        <translation>Es gibt noch nichts zu exportieren. Öffnen Sie zuerst einen Gefäßbaum und ein Angiogramm.</translation>
    </message>
    <message>
        <source>Export overlay</source>
        <translation>Überlagerung exportieren</translation>
    </message>
    <message>
        <source>PNG images (*.png)</source>
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
        <source>Displacement of each point (*.csv)</source>
        <translation>Verschiebung jedes Punkts (*.csv)</translation>
    </message>
    <message>
        <source>Deformed centerlines (*.vtp)</source>
        <translation>Verformte Mittellinien (*.vtp)</translation>
    </message>
    <message>
        <source>Export deformed vessels</source>
        <translation>Verformte Gefäße exportieren</translation>
    </message>
    <message>
        <source>There are no deformed vessels for this pose. Register first (R).</source>
        <translation>Zu dieser Lage gibt es keine verformten Gefäße. Registrieren Sie zuerst (R).</translation>
    </message>
    <message>
        <source>Export traced vessels</source>
        <translation>Erkannte Gefäße exportieren</translation>
    </message>
    <message>
        <source>2-D centerlines (*.csv)</source>
        <translation>2-D-Mittellinien (*.csv)</translation>
    </message>
    <message>
        <source>There are no vessels yet. Open a centerline, or trace a scan.</source>
        <translation>Es gibt noch keine Gefäße. Öffnen Sie eine Mittellinie oder erfassen Sie die Gefäße eines Scans.</translation>
    </message>
    <message>
        <source>Export vessel tree</source>
        <translation>Gefäßbaum exportieren</translation>
    </message>
    <message>
        <source>Centerlines (*.vtp *.csv *.swc *.mrk.json)</source>
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
        <source>No target points or rings have been set yet.</source>
        <translation>Es sind noch keine Zielpunkte oder Ringe gesetzt.</translation>
    </message>
    <message>
        <source>Export target points</source>
        <translation>Zielpunkte exportieren</translation>
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
    <name>angiopose::app::TrackingController</name>
    <message>
        <source>Tracking the vessels through the run: %1 %</source>
        <translation>Gefäße werden durch die Serie verfolgt: %1 %</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Could not track the vessels</source>
        <translation>Gefäße konnten nicht verfolgt werden</translation>
    </message>
    <message>
        <source>Another task is running. Wait for it to finish.</source>
        <translation>Eine andere Aufgabe läuft. Warten Sie, bis sie beendet ist.</translation>
    </message>
    <message>
        <source>Open vessels and an angiogram first.</source>
        <translation>Öffnen Sie zuerst Gefäße und ein Angiogramm.</translation>
    </message>
    <message>
        <source>Tracking the vessels through the run…</source>
        <translation>Gefäße werden durch die Serie verfolgt…</translation>
    </message>
    <message>
        <source>Track vessels through the run</source>
        <translation>Gefäße durch die Serie verfolgen</translation>
    </message>
    <message>
        <source>The vessels were moved during tracking. Track them again.</source>
        <translation>Die Gefäße wurden während der Verfolgung bewegt. Verfolgen Sie sie erneut.</translation>
    </message>
    <message>
        <source>breathing: period %1 s, %2 mm peak to peak</source>
        <translation>Atmung: Periode %1 s, %2 mm Spitze–Spitze</translation>
    </message>
    <message>
        <source>heartbeat: period %1 s, %2 mm peak to peak</source>
        <translation>Herzschlag: Periode %1 s, %2 mm Spitze–Spitze</translation>
    </message>
    <message>
        <source>Tracked through %1 frames; scroll through the frames or play them</source>
        <translation>Durch %1 Bilder verfolgt: blättern oder abspielen</translation>
    </message>
    <message>
        <source>Tracked through %1 frames; in %2 of them, the vessels are not sufficiently visible</source>
        <translation>Durch %1 Bilder verfolgt; in %2 davon sind die Gefäße nicht deutlich genug sichtbar</translation>
    </message>
    <message>
        <source>Export tracked poses</source>
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
        <source>Registers a 3-D vessel tree to a 2-D angiogram without correspondences.

Not for clinical use: AngioPose is research software, not a medical device.

Apache License 2.0. Built on Qt, VTK, ITK, OpenCV, NLopt, Eigen and nanoflann.</source>
        <translation>Registriert einen 3-D-Gefäßbaum auf ein 2-D-Angiogramm, ohne Korrespondenzen.

Nicht für den klinischen Einsatz: AngioPose ist Forschungssoftware, kein Medizinprodukt.

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
        <source>Drop a case, or vessels and an angiogram, anywhere in the window. “Open the sample case” requires no data of your own.</source>
        <translation>Legen Sie einen Fall oder Gefäße und ein Angiogramm irgendwo im Fenster ab. „Beispielfall öffnen“ benötigt keine eigenen Daten.</translation>
    </message>
    <message>
        <source>Steps to a result</source>
        <translation>Schritte zum Ergebnis</translation>
    </message>
    <message>
        <source>Each step shows a check mark when complete; otherwise, its tooltip lists what is missing. The steps can be clicked in any order.</source>
        <translation>Jeder erledigte Schritt zeigt ein Häkchen; sonst nennt sein Tooltip, was fehlt. Die Schritte lassen sich in beliebiger Reihenfolge anklicken.</translation>
    </message>
    <message>
        <source>The vessel tree</source>
        <translation>Der Gefäßbaum</translation>
    </message>
    <message>
        <source>Lists the branches with their lengths and residuals. Press A to add a branch to the auxiliary branches, X to exclude it.</source>
        <translation>Listet die Äste mit Länge und Residuum. A nimmt einen Ast in die Hilfsäste auf, X schließt ihn aus.</translation>
    </message>
    <message>
        <source>The angiogram</source>
        <translation>Das Angiogramm</translation>
    </message>
    <message>
        <source>The projected tree is overlaid on the angiogram and colored by its distance to the traced vessels. Wheel: scroll through the frames. N: move the tree with the arrow keys or the mouse. H: hide the tree.</source>
        <translation>Der projizierte Gefäßbaum überlagert das Angiogramm, gefärbt nach dem Abstand zu den erfassten Gefäßen. Rad: Bilder blättern. N: Gefäßbaum mit Pfeiltasten oder Maus verschieben. H: verbergen.</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>Registrieren</translation>
    </message>
    <message>
        <source>R finds the pose. Stop keeps the best pose found so far; Ctrl+Z restores the pose from before the registration.</source>
        <translation>R findet die Lage. Anhalten behält die bisher beste Lage; Strg+Z stellt die Lage vor der Registrierung wieder her.</translation>
    </message>
    <message>
        <source>Is the result reliable?</source>
        <translation>Ist das Ergebnis verlässlich?</translation>
    </message>
    <message>
        <source>Shows distances in mm and notes on what cannot be determined from this image. Shift+F1 shows examples of good and bad fits.</source>
        <translation>Zeigt Abstände in mm und Hinweise darauf, was sich aus diesem Bild nicht bestimmen lässt. Umschalt+F1 zeigt Beispiele guter und schlechter Registrierungen.</translation>
    </message>
    <message>
        <source>Getting help</source>
        <translation>Hilfe finden</translation>
    </message>
    <message>
        <source>F1 explains the item under the mouse pointer; ? lists all shortcuts and lets you change them. This tour is also available from the Help menu.</source>
        <translation>F1 erklärt das Element unter dem Mauszeiger, ? zeigt und ändert alle Tastenkürzel. Dieser Rundgang steht im Menü „Hilfe“.</translation>
    </message>
    <message>
        <source>The angiogram is rendered with VTK (OpenGL).</source>
        <translation>Das Angiogramm wird von VTK (OpenGL) gerendert.</translation>
    </message>
    <message>
        <source>The angiogram is rendered on the CPU.</source>
        <translation>Das Angiogramm wird von der CPU gerendert.</translation>
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
        <source>The inputs belong to different patients</source>
        <translation>Die Eingaben gehören zu verschiedenen Patienten</translation>
    </message>
    <message>
        <source>The inputs do not match</source>
        <translation>Die Eingaben passen nicht zusammen</translation>
    </message>
    <message>
        <source>Identity hidden (Shift+P shows it)</source>
        <translation>Identität verborgen (Umschalt+P zeigt sie)</translation>
    </message>
    <message>
        <source>scan</source>
        <translation>Scan</translation>
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
        <source>Centerlines (*.vtp *.vtk *.csv *.swc *.json)</source>
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
    <name>angiopose::app::EvaluationController</name>
    <message>
        <source>nothing to assess yet</source>
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
        <source>point outside the vessels</source>
        <translation>Punkt außerhalb der Gefäße</translation>
    </message>
    <message>
        <source>Fewer than four pairs: pose components that the pairs do not determine remain unchanged.</source>
        <translation>Weniger als vier Paare: Lagekomponenten, die sie nicht bestimmen, bleiben unverändert.</translation>
    </message>
    <message>
        <source>Residual of the pairs: %1 px. With click errors of 2 px: rotation ±%2°, depth ±%3 mm.</source>
        <translation>Residuum der Paare: %1 px. Bei Klickfehlern von 2 px: Drehung ±%2°, Tiefe ±%3 mm.</translation>
    </message>
    <message>
        <source>Move landmark %1</source>
        <translation>Landmarke %1 verschieben</translation>
    </message>
    <message>
        <source>Open the vessels first.</source>
        <translation>Öffnen Sie zuerst die Gefäße.</translation>
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
        <source>Register from landmarks</source>
        <translation>Nach Landmarken registrieren</translation>
    </message>
</context>
<context>
    <name>angiopose::app::LinkedCrosshair</name>
    <message>
        <source>The crosshair is linked across side-by-side views (%1).</source>
        <translation>Das Fadenkreuz ist in nebeneinander gezeigten Ansichten verknüpft (%1).</translation>
    </message>
</context>
<context>
    <name>angiopose::app::OverlayStyleController</name>
    <message>
        <source>Depth cueing</source>
        <translation>Tiefenabstufung</translation>
    </message>
    <message>
        <source>Depth cueing off</source>
        <translation>Tiefenabstufung aus</translation>
    </message>
    <message>
        <source>Vessels as centerlines</source>
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
        <source>Swipe: the overlay ends at the mouse pointer</source>
        <translation>Wischen: Die Überlagerung endet am Mauszeiger</translation>
    </message>
    <message>
        <source>Lens: hides the overlay around the mouse pointer</source>
        <translation>Lupe: blendet die Überlagerung um den Mauszeiger aus</translation>
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
        <translation>Noch keine Residuen</translation>
    </message>
    <message>
        <source>Worst %1 of %2: median %3 mm · W next · 1 fit view</source>
        <translation>Schlechtester %1 von %2: Median %3 mm · W weiter · 1 einpassen</translation>
    </message>
    <message>
        <source>View from the source: only the display is mirrored</source>
        <translation>Ansicht vom Fokus: nur die Darstellung ist gespiegelt</translation>
    </message>
    <message>
        <source>View from the detector</source>
        <translation>Ansicht vom Detektor</translation>
    </message>
    <message>
        <source>Vessels as DRR of the scan</source>
        <translation>Gefäße als DRR des Scans</translation>
    </message>
    <message>
        <source>Vessels as DRR of the tube model</source>
        <translation>Gefäße als DRR des Röhrenmodells</translation>
    </message>
</context>
<context>
    <name>angiopose::app::Notifications</name>
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
        <translation>Kontrastierung im Zeitverlauf</translation>
    </message>
</context>
<context>
    <name>angiopose::app::OpenController</name>
    <message>
        <source>The pose belongs to an image of %1 × %2 px, but the angiogram is %3 × %4 px. Open the pose that belongs to this angiogram.</source>
        <translation>Die Lage gehört zu einem Bild von %1 × %2 px, das Angiogramm hat jedoch %3 × %4 px. Öffnen Sie die Lage, die zu diesem Angiogramm gehört.</translation>
    </message>
    <message>
        <source>The camera stored with the pose is mirrored relative to the angiogram: one is viewed from the detector, the other from the source. Mirror the image, or change the viewing side in the geometry panel.</source>
        <translation>Die mit der Lage gespeicherte Kamera ist gegenüber dem Angiogramm gespiegelt: Eines ist vom Detektor, das andere vom Fokus aus gesehen. Spiegeln Sie das Bild, oder ändern Sie die Betrachtungsseite im Geometriefeld.</translation>
    </message>
    <message>
        <source>The pose was registered with different vessels.</source>
        <translation>Die Lage wurde mit anderen Gefäßen registriert.</translation>
    </message>
    <message>
        <source>The pose was registered to a different angiogram.</source>
        <translation>Die Lage wurde zu einem anderen Angiogramm registriert.</translation>
    </message>
    <message>
        <source>A pose can be opened only in a case. Open vessels and an angiogram first, then the pose.</source>
        <translation>Eine Lage lässt sich nur in einem Fall öffnen. Öffnen Sie zuerst Gefäße und ein Angiogramm, dann die Lage.</translation>
    </message>
    <message>
        <source>At this pose, the vessels lie behind the X-ray source. The pose may belong to another patient, or it may map camera coordinates to patient coordinates; in the latter case, invert the pose.</source>
        <translation>In dieser Lage liegen die Gefäße hinter dem Röntgenfokus. Die Lage gehört vielleicht zu einem anderen Patienten, oder sie bildet Kamera- auf Patientenkoordinaten ab: Dann kehren Sie die Lage um.</translation>
    </message>
    <message>
        <source>The camera stored with the pose is now in use. You can revert this in the geometry panel.</source>
        <translation>Die mit der Lage gespeicherte Kamera wird jetzt verwendet. Im Geometriefeld lässt sich das zurücknehmen.</translation>
    </message>
    <message>
        <source>Open pose %1</source>
        <translation>Lage %1 öffnen</translation>
    </message>
    <message>
        <source>Points can be opened only in a case with vessels. Open the vessels first, then the points.</source>
        <translation>Punkte lassen sich nur in einem Fall mit Gefäßen öffnen. Öffnen Sie zuerst die Gefäße, dann die Punkte.</translation>
    </message>
    <message>
        <source>Target points added: %1.</source>
        <translation>Zielpunkte hinzugefügt: %1.</translation>
    </message>
    <message>
        <source>None of the target points is near the vessels. The points may belong to another patient or use a different coordinate system.</source>
        <translation>Keiner der Zielpunkte liegt nahe den Gefäßen. Die Punkte gehören vielleicht zu einem anderen Patienten oder verwenden ein anderes Koordinatensystem.</translation>
    </message>
    <message>
        <source>Open points %1</source>
        <translation>Punkte %1 öffnen</translation>
    </message>
    <message>
        <source>Pose from %1 applied.</source>
        <translation>Lage aus %1 übernommen.</translation>
    </message>
    <message>
        <source>A registration is running. Stop it before opening another file.</source>
        <translation>Eine Registrierung läuft. Halten Sie sie an, bevor Sie eine andere Datei öffnen.</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>%1 wird gelesen…</translation>
    </message>
    <message>
        <source>A registration was started in the meantime. Open the file again after the registration has finished.</source>
        <translation>Inzwischen wurde eine Registrierung gestartet. Öffnen Sie die Datei nach deren Ende erneut.</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>A blind trial is in progress. End it before opening another file.</source>
        <translation>Ein Blindversuch läuft. Beenden Sie ihn, bevor Sie eine andere Datei öffnen.</translation>
    </message>
    <message>
        <source>A blind trial was started in the meantime. Open the file again after the trial has finished.</source>
        <translation>Inzwischen wurde ein Blindversuch gestartet. Öffnen Sie die Datei nach dessen Ende erneut.</translation>
    </message>
    <message>
        <source>Add view %1</source>
        <translation>Ansicht %1 hinzufügen</translation>
    </message>
    <message>
        <source>View added. To show it, click its entry in the strip above the image.</source>
        <translation>Ansicht hinzugefügt: Klicken Sie sie in der Leiste über dem Bild an, um sie zu zeigen.</translation>
    </message>
    <message>
        <source>Additional runs can be added as views only if the case has vessels. Open the vessels first, then the runs again.</source>
        <translation>Weitere Serien lassen sich nur als Ansichten hinzufügen, wenn der Fall Gefäße hat. Öffnen Sie zuerst die Gefäße, dann die Serien erneut.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::OpenDialogs</name>
    <message>
        <source>Which camera should be used?</source>
        <translation>Welche Kamera soll verwendet werden?</translation>
    </message>
    <message>
        <source>“%1” contains a camera that differs from that of the case. The pose is valid only with the camera that was used for its registration.</source>
        <translation>„%1“ enthält eine andere Kamera als der Fall. Die Lage gilt nur mit der Kamera, mit der sie registriert wurde.</translation>
    </message>
    <message>
        <source>Use pose and camera</source>
        <translation>Lage und Kamera verwenden</translation>
    </message>
    <message>
        <source>Use pose only</source>
        <translation>Nur die Lage verwenden</translation>
    </message>
    <message>
        <source>Different patient?</source>
        <translation>Anderer Patient?</translation>
    </message>
    <message>
        <source>If you open “%1” anyway, every image and report of the case will carry a warning, and no registration in this case will be rated reliable. If only the pseudonyms differ, open it as the same patient.</source>
        <translation>Wenn Sie „%1“ trotzdem öffnen, trägt jedes Bild und jeder Bericht des Falls einen Warnhinweis, und keine Registrierung in diesem Fall wird als verlässlich eingestuft. Unterscheiden sich nur Pseudonyme, öffnen Sie es als denselben Patienten.</translation>
    </message>
    <message>
        <source>Do not open</source>
        <translation>Nicht öffnen</translation>
    </message>
    <message>
        <source>Open anyway</source>
        <translation>Trotzdem öffnen</translation>
    </message>
    <message>
        <source>Open as same patient</source>
        <translation>Als denselben Patienten öffnen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open DICOM folder/CD</source>
        <translation>DICOM-Ordner/CD öffnen</translation>
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
        <source>The case already has an angiogram. Add “%1” as a second view for joint registration, or replace the current angiogram?</source>
        <translation>Der Fall hat bereits ein Angiogramm. „%1“ als zweite Ansicht zur gemeinsamen Registrierung hinzufügen oder das aktuelle Angiogramm ersetzen?</translation>
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
        <source>Show the scan with the current vessels?</source>
        <translation>Scan mit den aktuellen Gefäßen zeigen?</translation>
    </message>
    <message>
        <source>The vessels of the case come from a file. Show the slices of “%1” with these vessels, or replace them with vessels traced in this scan?</source>
        <translation>Die Gefäße des Falls stammen aus einer Datei. Die Schichten von „%1“ mit diesen Gefäßen zeigen oder sie durch in diesem Scan erfasste Gefäße ersetzen?</translation>
    </message>
    <message>
        <source>Show with the vessels</source>
        <translation>Mit den Gefäßen zeigen</translation>
    </message>
    <message>
        <source>Trace this scan</source>
        <translation>Diesen Scan erfassen</translation>
    </message>
    <message>
        <source>Creating the sample case…</source>
        <translation>Beispielfall wird erzeugt…</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Could not create the sample case</source>
        <translation>Der Beispielfall konnte nicht erzeugt werden</translation>
    </message>
    <message>
        <source>Save the open case first?</source>
        <translation>Den offenen Fall zuerst speichern?</translation>
    </message>
    <message>
        <source>“%1” has unsaved changes.</source>
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
        <source>Keep current case</source>
        <translation>Beim aktuellen Fall bleiben</translation>
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
        <source>“%1” does not specify the unit of its coordinates. If the unit were millimeters, the vessels would be unusually small or large. Your choice is stored in the case.</source>
        <translation>„%1“ nennt keine Einheit der Koordinaten. In Millimetern wären die Gefäße ungewöhnlich klein oder groß. Ihre Wahl wird im Fall gespeichert.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Which unit does the file use?</source>
        <translation>Welche Einheit verwendet die Datei?</translation>
    </message>
    <message>
        <source>Discard unsaved work?</source>
        <translation>Ungespeicherte Arbeit verwerfen?</translation>
    </message>
    <message>
        <source>“%1” has no vessels yet, so there is no case to save. Unsaved work will be lost.</source>
        <translation>„%1“ hat noch keine Gefäße, daher gibt es keinen Fall zu speichern. Ungespeicherte Arbeit geht verloren.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::OpenNotes</name>
    <message>
        <source>The vessels lie outside this scan: it may be a different scan or use a different coordinate system.</source>
        <translation>Die Gefäße liegen außerhalb dieses Scans: Es kann ein anderer Scan sein, oder er verwendet ein anderes Koordinatensystem.</translation>
    </message>
    <message>
        <source>No vessels have been traced in the scan yet. Place a seed or set the threshold in the slices (%1), then trace.</source>
        <translation>Im Scan sind noch keine Gefäße erfasst. Setzen Sie in den Schichten (%1) einen Startpunkt oder die Schwelle, und erfassen Sie dann die Gefäße.</translation>
    </message>
    <message>
        <source>File unit: %1 mm, as selected.</source>
        <translation>Einheit der Datei: %1 mm, wie gewählt.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ScreenshotController</name>
    <message>
        <source>Screenshot copied to the clipboard</source>
        <translation>Screenshot in die Zwischenablage kopiert</translation>
    </message>
    <message>
        <source>Save screenshot</source>
        <translation>Screenshot speichern</translation>
    </message>
    <message>
        <source>PNG images (*.png)</source>
        <translation>PNG-Bilder (*.png)</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>Could not save the image</source>
        <translation>Das Bild konnte nicht gespeichert werden</translation>
    </message>
    <message>
        <source>Could not write %1. Choose another folder.</source>
        <translation>%1 konnte nicht geschrieben werden. Wählen Sie einen anderen Ordner.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PivotController</name>
    <message>
        <source>Set rotation center</source>
        <translation>Drehzentrum setzen</translation>
    </message>
    <message>
        <source>The vessels now rotate about the selected point.</source>
        <translation>Die Gefäße drehen sich jetzt um den gewählten Punkt.</translation>
    </message>
    <message>
        <source>Reset rotation center</source>
        <translation>Drehzentrum zurücksetzen</translation>
    </message>
    <message>
        <source>The vessels rotate about their centroid again.</source>
        <translation>Die Gefäße drehen sich wieder um ihren Schwerpunkt.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PlotExport</name>
    <message>
        <source>Copy image</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Export as SVG…</source>
        <translation>Als SVG exportieren…</translation>
    </message>
    <message>
        <source>Export as PNG…</source>
        <translation>Als PNG exportieren…</translation>
    </message>
    <message>
        <source>Export plot</source>
        <translation>Diagramm exportieren</translation>
    </message>
    <message>
        <source>Vector graphics (*.svg)</source>
        <translation>Vektorgrafiken (*.svg)</translation>
    </message>
    <message>
        <source>PNG images (*.png)</source>
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
        <source>There is no pose to nudge yet. Open vessels and an angiogram and complete the geometry first.</source>
        <translation>Es gibt noch keine Lage zum Justieren. Öffnen Sie zuerst Gefäße und Angiogramm, und vervollständigen Sie die Geometrie.</translation>
    </message>
    <message>
        <source>“%1” is locked.</source>
        <translation>„%1“ ist gesperrt.</translation>
    </message>
    <message>
        <source>Reset to initial pose</source>
        <translation>Auf Startlage zurücksetzen</translation>
    </message>
    <message>
        <source>A registration is running. Stop it first.</source>
        <translation>Eine Registrierung läuft. Halten Sie sie zuerst an.</translation>
    </message>
    <message>
        <source>Change locks</source>
        <translation>Sperren ändern</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PoseGestures</name>
    <message>
        <source>Nudge mode: arrow keys move, dragging moves or rolls, N exits</source>
        <translation>Justiermodus: Pfeiltasten verschieben, Ziehen verschiebt oder rollt, N beendet</translation>
    </message>
    <message>
        <source>Nudge mode off</source>
        <translation>Justiermodus aus</translation>
    </message>
    <message>
        <source>Copied: patient-to-camera matrix, 4 × 4, mm</source>
        <translation>Kopiert: Matrix Patient → Kamera, 4 × 4, mm</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PoseTableController</name>
    <message>
        <source>There are no poses to compare yet.</source>
        <translation>Es gibt noch keine Lagen zu vergleichen.</translation>
    </message>
    <message>
        <source>Current pose</source>
        <translation>Aktuelle Lage</translation>
    </message>
    <message>
        <source>The vessels of this frame are still being traced.</source>
        <translation>Die Gefäße dieses Bildes werden noch erkannt.</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>Wird gestartet…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Run several methods</source>
        <translation>Mehrere Methoden ausführen</translation>
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
        <source>Open a vessel centerline first.</source>
        <translation>Öffnen Sie zuerst eine Gefäß-Mittellinie.</translation>
    </message>
    <message>
        <source>Open an angiogram first.</source>
        <translation>Öffnen Sie zuerst ein Angiogramm.</translation>
    </message>
    <message>
        <source>Register (%1)</source>
        <translation>Registrieren (%1)</translation>
    </message>
    <message>
        <source>In a blind trial, align the vessels manually.</source>
        <translation>In einem Blindversuch richten Sie die Gefäße manuell aus.</translation>
    </message>
    <message>
        <source>Register all views</source>
        <translation>Alle Ansichten registrieren</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ReplayController</name>
    <message>
        <source>Alternative path %1 of %2, probability %3 % · %4 to accept</source>
        <translation>Alternativer Weg %1 von %2, Wahrscheinlichkeit %3 % · %4 zum Übernehmen</translation>
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
        <source>horizontal</source>
        <translation>horizontal</translation>
    </message>
    <message>
        <source>vertical</source>
        <translation>vertikal</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>There is no registration to replay. Register first (R).</source>
        <translation>Es gibt keine Registrierung zum Wiedergeben. Registrieren Sie zuerst (R).</translation>
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
        <source>The registration found no other solution.</source>
        <translation>Die Registrierung fand keine andere Lösung.</translation>
    </message>
    <message>
        <source>There is no registration yet. Register first (R).</source>
        <translation>Es gibt noch keine Registrierung. Registrieren Sie zuerst (R).</translation>
    </message>
    <message>
        <source>Registered solution</source>
        <translation>Registrierte Lösung</translation>
    </message>
    <message>
        <source>Show the other solutions first (J).</source>
        <translation>Zeigen Sie zuerst die anderen Lösungen (J).</translation>
    </message>
    <message>
        <source>Accept solution %1</source>
        <translation>Lösung %1 übernehmen</translation>
    </message>
    <message>
        <source>Alternative solution %1 of %2, score %3 · %4 to accept</source>
        <translation>Andere Lösung %1 von %2, Güte %3 · %4 zum Übernehmen</translation>
    </message>
    <message>
        <source>Because of image noise alone, poses within ±%1 mm (2 σ, mainly %2) cannot be distinguished</source>
        <translation>Allein wegen des Bildrauschens sind Lagen innerhalb von ±%1 mm (2 σ, vor allem %2) nicht unterscheidbar</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ReviewController</name>
    <message>
        <source>Choose another frame</source>
        <translation>Anderes Bild wählen</translation>
    </message>
    <message>
        <source>Before: initial pose</source>
        <translation>Vorher: Startlage</translation>
    </message>
    <message>
        <source>There are no deformed vessels for this pose</source>
        <translation>Zu dieser Lage gibt es keine verformten Gefäße</translation>
    </message>
    <message>
        <source>Colors: distance to the traced vessels</source>
        <translation>Farben: Abstand zu den erkannten Gefäßen</translation>
    </message>
    <message>
        <source>Colors: displacement of the deformed vessels</source>
        <translation>Farben: Verschiebung der verformten Gefäße</translation>
    </message>
    <message>
        <source>Vessels: rigid pose</source>
        <translation>Gefäße: starre Lage</translation>
    </message>
    <message>
        <source>Vessels: deformed</source>
        <translation>Gefäße: verformt</translation>
    </message>
    <message>
        <source>After: current pose</source>
        <translation>Nachher: aktuelle Lage</translation>
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
        <source>Tracing the vessels of this frame…</source>
        <translation>Gefäße dieses Bildes werden erkannt…</translation>
    </message>
    <message>
        <source>Could not start the registration</source>
        <translation>Die Registrierung konnte nicht gestartet werden</translation>
    </message>
    <message>
        <source>Registering: %1 · %2 % · %3 px</source>
        <translation>Registrierung: %1 · %2 % · %3 px</translation>
    </message>
    <message>
        <source>Stopped, NOT RELIABLE: the best pose so far is kept; Undo restores the previous pose</source>
        <translation>Angehalten, NICHT VERLÄSSLICH: Die bisher beste Lage bleibt; „Rückgängig“ stellt die vorherige wieder her</translation>
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
        <source>A blind trial is in progress. End it before saving.</source>
        <translation>Ein Blindversuch läuft. Beenden Sie ihn vor dem Speichern.</translation>
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
        <source>A case requires vessels and an angiogram. Without an angiogram, only the vessels can be saved, as centerlines. To create a case later, open these vessels together with an angiogram.</source>
        <translation>Ein Fall benötigt Gefäße und ein Angiogramm. Ohne Angiogramm lassen sich nur die Gefäße speichern, als Mittellinien. Öffnen Sie diese später zusammen mit einem Angiogramm, um einen Fall anzulegen.</translation>
    </message>
    <message>
        <source>Save vessels…</source>
        <translation>Gefäße speichern…</translation>
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
        <source>Vessels saved as centerlines</source>
        <translation>Gefäße als Mittellinien gespeichert</translation>
    </message>
    <message>
        <source>Changed elsewhere</source>
        <translation>Anderswo geändert</translation>
    </message>
    <message>
        <source>“%1” was saved by another window or program after it was opened here. Overwriting discards the changes saved there; reloading discards the changes made here.</source>
        <translation>„%1“ wurde von einem anderen Fenster oder Programm gespeichert, nachdem der Fall hier geöffnet wurde. Überschreiben verwirft die dort gespeicherten Änderungen; Neuladen verwirft die hier vorgenommenen.</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
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
        <source>Case bundle saved: %1</source>
        <translation>Fallpaket gespeichert: %1</translation>
    </message>
    <message>
        <source>Could not save the case bundle</source>
        <translation>Das Fallpaket konnte nicht gespeichert werden</translation>
    </message>
    <message>
        <source>DICOM objects written: %1</source>
        <translation>DICOM-Objekte geschrieben: %1</translation>
    </message>
    <message>
        <source>Could not start another AngioPose process. Start AngioPose from the system menu.</source>
        <translation>Ein weiterer AngioPose-Prozess konnte nicht gestartet werden. Starten Sie ihn aus dem Menü des Systems.</translation>
    </message>
    <message>
        <source>Could not open another window</source>
        <translation>Es konnte kein weiteres Fenster geöffnet werden</translation>
    </message>
    <message>
        <source>Not for clinical use</source>
        <translation>Nicht für den klinischen Einsatz</translation>
    </message>
    <message>
        <source>AngioPose is research software, not a medical device: do not use it for diagnosis, treatment or navigation. Results can be wrong; a single projection cannot fully determine depth.</source>
        <translation>AngioPose ist Forschungssoftware, kein Medizinprodukt: Verwenden Sie es nicht für Diagnose, Behandlung oder Navigation. Ergebnisse können falsch sein; eine einzelne Projektion kann die Tiefe nicht vollständig bestimmen.</translation>
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
        <source>Saving…</source>
        <translation>Wird gespeichert…</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Gespeichert</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>Wird geschrieben…</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>Could not export</source>
        <translation>Export nicht möglich</translation>
    </message>
    <message>
        <source>Autosave failed; AngioPose retries every minute. %1</source>
        <translation>Die automatische Sicherung ist fehlgeschlagen; AngioPose versucht es jede Minute erneut. %1</translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>Angehalten; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Some files were skipped</source>
        <translation>Einige Dateien wurden übersprungen</translation>
    </message>
    <message>
        <source>Could not de-identify the files</source>
        <translation>Die Dateien konnten nicht de-identifiziert werden</translation>
    </message>
    <message>
        <source>The audit log is incomplete</source>
        <translation>Das Audit-Protokoll ist unvollständig</translation>
    </message>
</context>
<context>
    <name>angiopose::app::SideBySideController</name>
    <message>
        <source>Other views are hidden during a blind trial because they would reveal the true pose.</source>
        <translation>Während eines Blindversuchs sind andere Ansichten verborgen, weil sie die wahre Lage verraten würden.</translation>
    </message>
    <message>
        <source>Open an angiogram first. Another view can then be shown next to it.</source>
        <translation>Öffnen Sie zuerst ein Angiogramm. Eine weitere Ansicht lässt sich dann daneben zeigen.</translation>
    </message>
    <message>
        <source>This case has only one view. Add another angiogram of the same vessels (%1) to show both side by side.</source>
        <translation>Dieser Fall hat nur eine Ansicht. Fügen Sie ein weiteres Angiogramm derselben Gefäße hinzu (%1), um beide nebeneinander zu zeigen.</translation>
    </message>
    <message>
        <source>no geometry</source>
        <translation>keine Geometrie</translation>
    </message>
    <message>
        <source>linked</source>
        <translation>gekoppelt</translation>
    </message>
    <message>
        <source>independent pose</source>
        <translation>unabhängige Lage</translation>
    </message>
    <message>
        <source>The vessels in this view move together with those in the active view.</source>
        <translation>Die Gefäße in dieser Ansicht bewegen sich zusammen mit denen der aktiven Ansicht.</translation>
    </message>
    <message>
        <source>The views are not registered jointly: moving the vessels in the active view does not move them in this view.</source>
        <translation>Die Ansichten werden nicht gemeinsam registriert: Werden die Gefäße in der aktiven Ansicht bewegt, bleiben sie hier stehen.</translation>
    </message>
    <message>
        <source>Click here, or double-click the image, to make this the active view.</source>
        <translation>Klicken Sie hier oder doppelklicken Sie ins Bild, um diese Ansicht zur aktiven zu machen.</translation>
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
        <source>There is no pose to save yet.</source>
        <translation>Es gibt noch keine Lage zum Speichern.</translation>
    </message>
    <message>
        <source>Save snapshot %1</source>
        <translation>Snapshot %1 speichern</translation>
    </message>
    <message>
        <source>Saved as “%1” · Y to compare</source>
        <translation>Gespeichert als „%1“ · Y zum Vergleichen</translation>
    </message>
    <message>
        <source>“%1”: median %2 mm · Esc to return</source>
        <translation>„%1“: Median %2 mm · Esc: zurück</translation>
    </message>
    <message>
        <source>“%1” · Esc to return</source>
        <translation>„%1“ · Esc: zurück</translation>
    </message>
    <message>
        <source>There is nothing to compare with yet: press K to save a snapshot; each registration (R) also adds one.</source>
        <translation>Es gibt noch nichts zum Vergleichen: K speichert einen Snapshot, und jede Registrierung (R) fügt einen hinzu.</translation>
    </message>
    <message>
        <source>A: current pose</source>
        <translation>A: aktuelle Lage</translation>
    </message>
    <message>
        <source>Restore %1</source>
        <translation>%1 wiederherstellen</translation>
    </message>
    <message>
        <source>Edit snapshot</source>
        <translation>Snapshot bearbeiten</translation>
    </message>
    <message>
        <source>Delete snapshot</source>
        <translation>Snapshot löschen</translation>
    </message>
    <message>
        <source>Delete %1 snapshots</source>
        <translation>%1 Snapshots löschen</translation>
    </message>
</context>
<context>
    <name>angiopose::app::SolutionController</name>
    <message>
        <source>%1 %: %2</source>
        <translation>%1 %: %2</translation>
    </message>
    <message>
        <source>%1 Press Enter to accept it.</source>
        <translation>%1 Mit der Eingabetaste übernehmen.</translation>
    </message>
    <message>
        <source>Branches %1: probability %2 %; %3 % of the guidewire follows these branches, at a distance of %4 mm from their centerlines.</source>
        <translation>Äste %1: Wahrscheinlichkeit %2 %; %3 % des Führungsdrahts folgen ihnen, %4 mm neben ihren Mittellinien.</translation>
    </message>
    <message>
        <source>result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Registered solution</source>
        <translation>Registrierte Lösung</translation>
    </message>
    <message>
        <source>%1 mm, %2°</source>
        <translation>%1 mm, %2°</translation>
    </message>
    <message>
        <source>Alternative solution %1, score %2: differs from the registered solution by %3 mm in plane, %4 mm in depth and %5° in rotation. Press Enter to accept it.</source>
        <translation>Andere Lösung %1, Güte %2: weicht von der registrierten um %3 mm in der Bildebene, %4 mm in der Tiefe und %5° in der Drehung ab. Mit der Eingabetaste übernehmen.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::InitialPoseController</name>
    <message>
        <source>Initial pose from angles</source>
        <translation>Startlage aus Winkeln</translation>
    </message>
    <message>
        <source>Initial pose from the angles, with the isocenter placed in the vessels</source>
        <translation>Startlage aus den Winkeln, Isozentrum in den Gefäßen</translation>
    </message>
    <message>
        <source>Open vessels and an angiogram and complete the geometry first.</source>
        <translation>Öffnen Sie zuerst Gefäße und Angiogramm, und vervollständigen Sie die Geometrie.</translation>
    </message>
    <message>
        <source>Manual initial pose</source>
        <translation>Manuelle Startlage</translation>
    </message>
    <message>
        <source>The current pose is now the initial pose</source>
        <translation>Die aktuelle Lage ist jetzt die Startlage</translation>
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
        <translation>Öffnen Sie ein Angiogramm: DICOM XA, PNG oder TIFF.</translation>
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
        <source>tracing…</source>
        <translation>Erkennung…</translation>
    </message>
    <message>
        <source>imported centerline</source>
        <translation>importierte Mittellinie</translation>
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
        <source>inconsistent</source>
        <translation>widersprüchlich</translation>
    </message>
    <message>
        <source>partly assumed</source>
        <translation>teils angenommen</translation>
    </message>
    <message>
        <source>Some values are assumed. Enter the actual values if you know them.</source>
        <translation>Einige Werte sind angenommen. Geben Sie sie ein, wenn sie bekannt sind.</translation>
    </message>
    <message>
        <source>pixel spacing entered</source>
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
        <source>running…</source>
        <translation>läuft…</translation>
    </message>
    <message>
        <source>moved manually</source>
        <translation>manuell verschoben</translation>
    </message>
    <message>
        <source>tracked</source>
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
        <source>different frame</source>
        <translation>anderes Bild</translation>
    </message>
    <message>
        <source>This pose was registered in frame %1. Press R to register in the displayed frame.</source>
        <translation>Diese Lage wurde in Bild %1 registriert. Drücken Sie R, um im angezeigten Bild zu registrieren.</translation>
    </message>
    <message>
        <source>%1 mm median</source>
        <translation>Median %1 mm</translation>
    </message>
    <message>
        <source>exported</source>
        <translation>exportiert</translation>
    </message>
    <message>
        <source>Open a CT angiogram, a segmentation, a surface or a centerline.</source>
        <translation>Öffnen Sie eine CT-Angiographie, Segmentierung, Oberfläche oder Mittellinie.</translation>
    </message>
    <message>
        <source>%1 components</source>
        <translation>%1 Komponenten</translation>
    </message>
    <message>
        <source>The vessel tree is not connected. The note below the branch list explains how to join the components of the tree.</source>
        <translation>Der Gefäßbaum ist nicht zusammenhängend. Der Hinweis unter der Astliste erklärt, wie sich seine Komponenten verbinden lassen.</translation>
    </message>
    <message>
        <source>different patient?</source>
        <translation>anderer Patient?</translation>
    </message>
    <message>
        <source>frame %1, edited</source>
        <translation>Bild %1, bearbeitet</translation>
    </message>
    <message>
        <source>The header contains no pixel spacing: %1. Enter the pixel spacing, or press Enter in the field to confirm the value.</source>
        <translation>Der Header enthält keine Pixelgröße: %1. Geben Sie sie ein, oder bestätigen Sie den Wert im Feld mit der Eingabetaste.</translation>
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
        <source>No vessels were traced in the scan. Place a seed or set the threshold in the panel next to the slices.</source>
        <translation>Im Scan wurden keine Gefäße erfasst. Setzen Sie neben den Schichten einen Startpunkt oder die Schwelle.</translation>
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
        <source>Peak-opacification image</source>
        <translation>Min-IP der ganzen Serie</translation>
    </message>
    <message>
        <source>Single frames</source>
        <translation>Einzelbilder</translation>
    </message>
    <message>
        <source>Choose mask frames</source>
        <translation>Maskenbilder wählen</translation>
    </message>
    <message>
        <source>A registration is running. Stop it before editing.</source>
        <translation>Eine Registrierung läuft. Halten Sie sie vor dem Bearbeiten an.</translation>
    </message>
    <message>
        <source>Open an angiogram first.</source>
        <translation>Öffnen Sie zuerst ein Angiogramm.</translation>
    </message>
    <message>
        <source>Pixel shift</source>
        <translation>Pixelshift</translation>
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
        <source>Tracing the vessels of the scan… %1 %</source>
        <translation>Gefäße des Scans werden erfasst … %1 %</translation>
    </message>
    <message>
        <source>Stopped: the vessels are unchanged</source>
        <translation>Angehalten: Die Gefäße sind unverändert</translation>
    </message>
    <message>
        <source>These vessels were not traced from an image. To trace vessels, open a scan, a segmentation or a surface.</source>
        <translation>Diese Gefäße wurden nicht aus einem Bild erfasst. Öffnen Sie zum Erfassen einen Scan, eine Segmentierung oder eine Oberfläche.</translation>
    </message>
    <message>
        <source>A registration is running. Stop it first.</source>
        <translation>Eine Registrierung läuft. Halten Sie sie zuerst an.</translation>
    </message>
    <message>
        <source>Tracing the vessels of the scan…</source>
        <translation>Gefäße des Scans werden erfasst…</translation>
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
        <source>No label is selected. Select the labels that contain vessels.</source>
        <translation>Kein Label ist ausgewählt. Wählen Sie die Labels, die Gefäße enthalten.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::TreeActions</name>
    <message>
        <source>Select one branch: click it in the list or in a view.</source>
        <translation>Wählen Sie einen Ast: Klicken Sie ihn in der Liste oder in einer Ansicht an.</translation>
    </message>
    <message>
        <source>%1 components, too far apart to join</source>
        <translation>%1 Komponenten, zu weit auseinander zum Verbinden</translation>
    </message>
    <message>
        <source>Place seed here</source>
        <translation>Startpunkt hier setzen</translation>
    </message>
    <message>
        <source>Avoid this point</source>
        <translation>Diesen Punkt meiden</translation>
    </message>
    <message>
        <source>%1 components · gap %2 mm: %3 – %4</source>
        <translation>%1 Komponenten · Lücke %2 mm: %3 – %4</translation>
    </message>
    <message>
        <source>Rotate vessels about this point</source>
        <translation>Gefäße um diesen Punkt drehen</translation>
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
        <translation>Wählen Sie einen Ast: Klicken Sie ihn in der Liste oder in einer Ansicht an.</translation>
    </message>
    <message>
        <source>At least one branch must remain.</source>
        <translation>Mindestens ein Ast muss übrig bleiben.</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>Delete %1 and descendants</source>
        <translation>%1 und nachgeordnete Äste löschen</translation>
    </message>
    <message>
        <source>First click the position of the cut, in a slice or on the branch in the 3-D view.</source>
        <translation>Klicken Sie zuerst die Trennstelle an, in einer Schicht oder am Ast in der 3-D-Ansicht.</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>%1 trennen</translation>
    </message>
    <message>
        <source>Select two branches to join (Ctrl+click adds the second).</source>
        <translation>Wählen Sie zwei zu verbindende Äste (Strg+Klick fügt den zweiten hinzu).</translation>
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
        <source>Set root at %1</source>
        <translation>Wurzel an %1 setzen</translation>
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
        <source>No terminal branch is below these limits.</source>
        <translation>Kein Endast liegt unter diesen Grenzwerten.</translation>
    </message>
    <message>
        <source>Prune 1 branch</source>
        <translation>1 Ast entfernen</translation>
    </message>
    <message>
        <source>Prune %1 branches</source>
        <translation>%1 Äste entfernen</translation>
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
        <translation>Diese Ansicht benennen…</translation>
    </message>
    <message>
        <source>Name this view</source>
        <translation>Diese Ansicht benennen</translation>
    </message>
    <message>
        <source>Name of view %1 (leave empty to use its angles)</source>
        <translation>Name der Ansicht %1 (leer: ihre Winkel)</translation>
    </message>
    <message>
        <source>Rename view</source>
        <translation>Ansicht umbenennen</translation>
    </message>
    <message>
        <source>Remove this view</source>
        <translation>Diese Ansicht entfernen</translation>
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
        <source>%1. Click to show this view; Delete removes the active view.</source>
        <translation>%1. Klicken, um sie zu zeigen; Entf entfernt die aktive Ansicht.</translation>
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
        <source>No other view can be shown instead.</source>
        <translation>Keine andere Ansicht kann an ihrer Stelle gezeigt werden.</translation>
    </message>
    <message>
        <source>Remove view</source>
        <translation>Ansicht entfernen</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ViewSync</name>
    <message>
        <source>Single frame</source>
        <translation>Einzelbild</translation>
    </message>
    <message>
        <source>initial pose</source>
        <translation>Startlage</translation>
    </message>
    <message>
        <source>a registration step</source>
        <translation>ein Schritt der Registrierung</translation>
    </message>
    <message>
        <source>a pose within image noise</source>
        <translation>eine Lage innerhalb des Bildrauschens</translation>
    </message>
    <message>
        <source>another solution</source>
        <translation>eine andere Lösung</translation>
    </message>
    <message>
        <source>a snapshot</source>
        <translation>ein Snapshot</translation>
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
        <source>Opacification by frame · frame %1 of %2 · peak: %3</source>
        <translation>Kontrastierung je Bild · Bild %1 von %2 · Maximum: %3</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>Rank of the path by probability: 1 is the most probable path.</source>
        <translation>Rang des Wegs nach Wahrscheinlichkeit: 1 ist der wahrscheinlichste Weg.</translation>
    </message>
    <message>
        <source>Adds the prior selected above to the attraction term.</source>
        <translation>Addiert den oben gewählten Prior zum Anziehungsterm.</translation>
    </message>
    <message>
        <source>Kernel-weighted PnP that alternates between a few auxiliary points and all points (Song, Ghaffari).</source>
        <translation>Alterniert kerngewichtetes PnP zwischen wenigen Hilfspunkten und allen Punkten (Song, Ghaffari).</translation>
    </message>
    <message>
        <source>Alternating search</source>
        <translation>Alternierende Suche</translation>
    </message>
    <message>
        <source>Alternation</source>
        <translation>Alternierung</translation>
    </message>
    <message>
        <source>Annealed particles around the initial pose, or a sweep over the out-of-plane angles.</source>
        <translation>Abkühlende Partikel um die Startlage, oder ein Durchlauf der Winkel aus der Bildebene.</translation>
    </message>
    <message>
        <source>Seed of the random number generator; the same seed reproduces the result.</source>
        <translation>Startwert der Zufallszahlen; derselbe Wert reproduziert das Ergebnis.</translation>
    </message>
    <message>
        <source>Attracted to</source>
        <translation>Angezogen von</translation>
    </message>
    <message>
        <source>Auxiliary points</source>
        <translation>Hilfspunkte</translation>
    </message>
    <message>
        <source>Best-first search over sequences of matched branches, with one pose per sequence (based on Zhu; reimplementation with our own parameters).</source>
        <translation>Best-first-Suche über Folgen zugeordneter Äste, mit je einer Lage pro Folge (nach Zhu; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Image intensity along the projected vessels at the scale of each vessel, optimized by an evolution strategy (Jomier 2006; reimplementation with our own parameters).</source>
        <translation>Bildintensität längs der projizierten Gefäße auf der Skala jedes Gefäßes, optimiert mit einer Evolutionsstrategie (Jomier 2006; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Auxiliary branches (nodes if none are selected), nodes, the widest branches (up to one third of the total length), or random points.</source>
        <translation>Hilfsäste (Knoten, wenn keine gewählt sind), Knoten, die weitesten Äste (bis zu einem Drittel der Gesamtlänge) oder zufällige Punkte.</translation>
    </message>
    <message>
        <source>Coarse search, then robust point-to-line refinement about the tree&apos;s centroid; also estimates the pose uncertainty.</source>
        <translation>Grobe Suche, dann robuste Punkt-Linien-Verfeinerung um den Schwerpunkt; schätzt auch die Unsicherheit der Lage.</translation>
    </message>
    <message>
        <source>Covariance matrix adaptation (CMA-ES), or a (1+1) evolution strategy.</source>
        <translation>Kovarianzmatrix-Adaptation (CMA-ES) oder eine (1+1)-Evolutionsstrategie.</translation>
    </message>
    <message>
        <source>Levenberg–Marquardt on the Huber loss with updated correspondences, or L-BFGS on the squared distances.</source>
        <translation>Levenberg–Marquardt auf dem Huber-Verlust mit aktualisierten Zuordnungen oder L-BFGS auf den Abstandsquadraten.</translation>
    </message>
    <message>
        <source>Direction kernel</source>
        <translation>Richtungskern</translation>
    </message>
    <message>
        <source>Use directions</source>
        <translation>Richtungen verwenden</translation>
    </message>
    <message>
        <source>Spacing of the points on the traced vessels.</source>
        <translation>Punktabstand auf den erkannten Gefäßen.</translation>
    </message>
    <message>
        <source>Spacing of the tree points used for matching; a smaller spacing takes longer to compute.</source>
        <translation>Abstand der zugeordneten Baumpunkte; ein kleinerer Abstand erfordert mehr Rechenzeit.</translation>
    </message>
    <message>
        <source>Distance beyond which a point has little weight in the final stage; image noise can increase this distance.</source>
        <translation>Abstand, ab dem ein Punkt in der Endphase kaum noch Gewicht hat; Bildrauschen kann ihn vergrößern.</translation>
    </message>
    <message>
        <source>Distance beyond which the influence of a point no longer increases.</source>
        <translation>Abstand, ab dem der Einfluss eines Punkts nicht mehr zunimmt.</translation>
    </message>
    <message>
        <source>Edge scale</source>
        <translation>Kantenskala</translation>
    </message>
    <message>
        <source>Edge search along the vessel wall normals; RANSAC with gradient matching selects the pose (Markelj 2008; reimplementation with our own parameters).</source>
        <translation>Kanten längs der Normalen der Gefäßwände; RANSAC mit Gradientenvergleich wählt die Lage (Markelj 2008; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Max. evaluations</source>
        <translation>Max. Auswertungen</translation>
    </message>
    <message>
        <source>Even spacing</source>
        <translation>Gleiche Abstände</translation>
    </message>
    <message>
        <source>Factor by which the kernel width is multiplied in each step after the first thirty.</source>
        <translation>Faktor, mit dem die Kernbreite nach den ersten dreißig Schritten in jedem Schritt multipliziert wird.</translation>
    </message>
    <message>
        <source>Final scale</source>
        <translation>Endskala</translation>
    </message>
    <message>
        <source>Initial kernel width</source>
        <translation>Anfängliche Kernbreite</translation>
    </message>
    <message>
        <source>Initial range</source>
        <translation>Anfängliche Reichweite</translation>
    </message>
    <message>
        <source>Initial matching range</source>
        <translation>Anfängliche Zuordnungsreichweite</translation>
    </message>
    <message>
        <source>Max. flow steps</source>
        <translation>Max. Flussschritte</translation>
    </message>
    <message>
        <source>Gradient ascent on the mean kernel value between the tree and the traced vessels, or on the image intensity (Aylward 2003; reimplementation with our own parameters).</source>
        <translation>Gradientenaufstieg des mittleren Kernwerts zwischen Gefäßbaum und erkannten Gefäßen oder der Bildintensität (Aylward 2003; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Gradient flow of the inner product of the tree and the traced vessels, both represented as functions in the image (Ghaffari 2019; reimplementation with our own parameters).</source>
        <translation>Gradientenfluss des inneren Produkts von Gefäßbaum und erkannten Gefäßen als Funktionen im Bild (Ghaffari 2019; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Maximum number of gradient steps at each of the three kernel widths.</source>
        <translation>Höchstzahl der Gradientenschritte bei jeder der drei Kernbreiten.</translation>
    </message>
    <message>
        <source>Required similarity of directions; smaller values are stricter.</source>
        <translation>Geforderte Ähnlichkeit der Richtungen; kleinere Werte sind strenger.</translation>
    </message>
    <message>
        <source>Maximum distance between a bifurcation or endpoint of the tree and its match in the image.</source>
        <translation>Höchstabstand zwischen einer Verzweigung oder einem Ende des Baums und der Zuordnung im Bild.</translation>
    </message>
    <message>
        <source>Search range of the in-plane shift.</source>
        <translation>Suchbereich der Verschiebung in der Bildebene.</translation>
    </message>
    <message>
        <source>Initial search distance for edges along the normals of the vessel walls.</source>
        <translation>Anfängliche Suchweite für Kanten längs der Normalen der Gefäßwände.</translation>
    </message>
    <message>
        <source>Initial maximum distance between a branch and the traced vessel matched to it.</source>
        <translation>Anfänglicher Höchstabstand zwischen Ästen und den zugehörigen erkannten Gefäßen.</translation>
    </message>
    <message>
        <source>Margin of the mask around the projected vessels.</source>
        <translation>Rand der Maske um die projizierten Gefäße.</translation>
    </message>
    <message>
        <source>Search range of the LAO/RAO and CRA/CAU angles.</source>
        <translation>Suchbereich in LAO/RAO und CRA/CAU.</translation>
    </message>
    <message>
        <source>Search range of the in-plane rotation.</source>
        <translation>Suchbereich der Drehung in der Bildebene.</translation>
    </message>
    <message>
        <source>Number of auxiliary points if these are chosen at random.</source>
        <translation>Anzahl der Hilfspunkte, wenn sie zufällig sind.</translation>
    </message>
    <message>
        <source>Weighting of the initial-pose prior relative to the image.</source>
        <translation>Gewichtung des Startlage-Priors gegenüber dem Bild.</translation>
    </message>
    <message>
        <source>Nearest-neighbor search: the k-d tree and the grid are exact; the distance map is accurate to within three pixels.</source>
        <translation>Suche der nächsten Nachbarn: k-d-Baum und Gitter sind exakt, die Abstandskarte ist auf drei Pixel genau.</translation>
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
        <source>Max. ICP iterations</source>
        <translation>Max. ICP-Iterationen</translation>
    </message>
    <message>
        <source>Image point spacing</source>
        <translation>Punktabstand im Bild</translation>
    </message>
    <message>
        <source>Image points that attract each tree point: the nearest, the five nearest, or all within three kernel widths.</source>
        <translation>Bildpunkte, die jeden Baumpunkt anziehen: der nächste, die fünf nächsten, oder alle innerhalb von drei Kernbreiten.</translation>
    </message>
    <message>
        <source>Max. iterations</source>
        <translation>Max. Iterationen</translation>
    </message>
    <message>
        <source>Keeps the extent of the projected tree equal to that of the traced vessels; lower the weight if many branches are missing from the image.</source>
        <translation>Hält die Ausdehnung des projizierten Baums gleich der der erkannten Gefäße; verringern Sie den Wert, wenn viele Äste im Bild fehlen.</translation>
    </message>
    <message>
        <source>Prevents the projected tree from shrinking; lower the weight if many branches are missing from the image.</source>
        <translation>Hindert den projizierten Baum am Schrumpfen; verringern Sie den Wert, wenn viele Äste im Bild fehlen.</translation>
    </message>
    <message>
        <source>Kernel decay</source>
        <translation>Kernabnahme</translation>
    </message>
    <message>
        <source>Initial kernel width: the largest distance, or its square as printed in the original paper.</source>
        <translation>Anfängliche Kernbreite: der größte Abstand, oder dessen Quadrat wie im Artikel.</translation>
    </message>
    <message>
        <source>Kernel-weighted iterative PnP on all points (Song, Ghaffari).</source>
        <translation>Kerngewichtetes iteratives PnP auf allen Punkten (Song, Ghaffari).</translation>
    </message>
    <message>
        <source>L2 distance between oriented Gaussian mixtures of the tree and the traced vessels (Baka 2014; reimplementation with our own parameters).</source>
        <translation>L2-Abstand gerichteter Gauß-Mischungen von Gefäßbaum und erkannten Gefäßen (Baka 2014; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Final kernel width</source>
        <translation>Endgültige Kernbreite</translation>
    </message>
    <message>
        <source>Last pose ± (depth)</source>
        <translation>Letzte Lage ± (Tiefe)</translation>
    </message>
    <message>
        <source>Last pose ± (rotation)</source>
        <translation>Letzte Lage ± (Drehung)</translation>
    </message>
    <message>
        <source>Last pose ± (shift)</source>
        <translation>Letzte Lage ± (Verschiebung)</translation>
    </message>
    <message>
        <source>Minimization of the Huber loss of the distances to the nearest traced vessel (Rivest-Hénault 2012; reimplementation with our own parameters).</source>
        <translation>Minimaler Huber-Verlust der Abstände zum nächsten erkannten Gefäß (Rivest-Hénault 2012; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Least squares on branches matched by graph matching, followed by length-preserving vessel motion (Groher 2009; reimplementation with our own parameters).</source>
        <translation>Kleinste Quadrate auf Ästen, die durch Graph-Matching zugeordnet sind, danach längenerhaltende Gefäßbewegung (Groher 2009; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Iterative closest point (ICP) registration with OpenCV&apos;s SQPnP solver.</source>
        <translation>Iterative-Closest-Point-Verfahren mit dem Löser SQPnP von OpenCV.</translation>
    </message>
    <message>
        <source>Allow vessel motion</source>
        <translation>Gefäßbewegung zulassen</translation>
    </message>
    <message>
        <source>Alternates between the auxiliary and the full problem.</source>
        <translation>Alterniert zwischen Hilfsproblem und vollem Problem.</translation>
    </message>
    <message>
        <source>Alternates between the auxiliary points and all points.</source>
        <translation>Alterniert zwischen den Hilfspunkten und allen Punkten.</translation>
    </message>
    <message>
        <source>Maximum number of rounds of line searches along all six directions.</source>
        <translation>Höchstzahl der Runden der Liniensuche in allen sechs Richtungen.</translation>
    </message>
    <message>
        <source>Searches the neighborhood of the initial pose before refinement.</source>
        <translation>Sucht vor der Verfeinerung um die Startlage.</translation>
    </message>
    <message>
        <source>Particle filter with resampling by likelihood, or a sweep over the out-of-plane angles (based on Tian 2022; reimplementation with our own parameters).</source>
        <translation>Partikelfilter mit Resampling nach Likelihood oder ein Durchlauf der Winkel aus der Bildebene (nach Tian 2022; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Mask margin</source>
        <translation>Maskenrand</translation>
    </message>
    <message>
        <source>Maximum number of rounds of matching and pose selection.</source>
        <translation>Höchstzahl der Runden aus Zuordnung und Lagewahl.</translation>
    </message>
    <message>
        <source>Maximum number of rounds of matching and solving.</source>
        <translation>Höchstzahl der Runden aus Zuordnung und Lösung.</translation>
    </message>
    <message>
        <source>Maximum number of rounds of branch matching and pose fitting.</source>
        <translation>Höchstzahl der Runden aus Astzuordnung und Lageanpassung.</translation>
    </message>
    <message>
        <source>After the rigid fit, moves the branches to their matches while preserving branch lengths, and reports the displacement; the pose does not change.</source>
        <translation>Bewegt die Äste nach der starren Anpassung längenerhaltend auf ihre Zuordnungen und meldet die Verschiebung; die Lage ändert sich nicht.</translation>
    </message>
    <message>
        <source>NICP within the alternating search (Song, Ghaffari; reimplementation with our own parameters).</source>
        <translation>NICP in der alternierenden Suche (Song, Ghaffari; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Narrows the kernel after every five steps, or when no new point comes within its range.</source>
        <translation>Verengt den Kern nach jeweils fünf Schritten, oder wenn kein neuer Punkt in seine Reichweite kommt.</translation>
    </message>
    <message>
        <source>Nearest-point search</source>
        <translation>Suche nächster Punkte</translation>
    </message>
    <message>
        <source>Neighbors</source>
        <translation>Nachbarn</translation>
    </message>
    <message>
        <source>Off-axis ±</source>
        <translation>Neben der Achse ±</translation>
    </message>
    <message>
        <source>For images that show only a guidewire or catheter: finds its path through the tree and a pose near that of the last full registration.</source>
        <translation>Für Bilder, die nur einen Führungsdraht oder Katheter zeigen: findet seinen Weg im Gefäßbaum und die Lage nahe der letzten vollständigen Registrierung.</translation>
    </message>
    <message>
        <source>Particles</source>
        <translation>Partikel</translation>
    </message>
    <message>
        <source>Compared pixels</source>
        <translation>Verglichene Pixel</translation>
    </message>
    <message>
        <source>Points attract each other more strongly where the vessels run in similar directions.</source>
        <translation>Punkte ziehen einander umso stärker an, je ähnlicher die Gefäßrichtungen dort sind.</translation>
    </message>
    <message>
        <source>Population</source>
        <translation>Population</translation>
    </message>
    <message>
        <source>Number of poses per round, each computed from three random correspondences.</source>
        <translation>Anzahl der Lagen je Runde, jede aus drei zufälligen Korrespondenzen.</translation>
    </message>
    <message>
        <source>Number of poses retained per round.</source>
        <translation>Anzahl der je Runde behaltenen Lagen.</translation>
    </message>
    <message>
        <source>Maximum total number of poses tested.</source>
        <translation>Höchstzahl der insgesamt geprüften Lagen.</translation>
    </message>
    <message>
        <source>Number of poses tested per generation.</source>
        <translation>Anzahl der je Generation geprüften Lagen.</translation>
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
        <source>Initial-pose prior</source>
        <translation>Prior der Startlage</translation>
    </message>
    <message>
        <source>Maximum number of DRRs computed.</source>
        <translation>Höchstzahl der berechneten DRRs.</translation>
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
        <source>Rank correlation of the image with DRRs of the CTA or of vessel tubes, optimized by the Nelder–Mead method (Steininger 2012; reimplementation with our own parameters).</source>
        <translation>Rangkorrelation des Bildes mit DRRs der CTA oder von Röhren, Nelder–Mead (Steininger 2012; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Initial range of the attraction.</source>
        <translation>Anfängliche Reichweite der Anziehung.</translation>
    </message>
    <message>
        <source>Final range of the attraction.</source>
        <translation>Endgültige Reichweite der Anziehung.</translation>
    </message>
    <message>
        <source>Max. node distance</source>
        <translation>Max. Knotenabstand</translation>
    </message>
    <message>
        <source>Rigid only, or rigid followed by an affine stage whose rigid component is adopted if it fits better.</source>
        <translation>Nur starr, oder gefolgt von einer affinen Stufe, deren starrer Teil bleibt, wenn er besser passt.</translation>
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
        <source>Max. rounds</source>
        <translation>Max. Runden</translation>
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
        <source>Roll search range</source>
        <translation>Suchbereich Rollen</translation>
    </message>
    <message>
        <source>Tilt search range</source>
        <translation>Suchbereich Kippung</translation>
    </message>
    <message>
        <source>Self term</source>
        <translation>Selbstterm</translation>
    </message>
    <message>
        <source>Maximum number of matched-branch sequences tested.</source>
        <translation>Höchstzahl der geprüften Folgen zugeordneter Äste.</translation>
    </message>
    <message>
        <source>Fraction of the mask used for the rank correlation; at least 2000 pixels are used.</source>
        <translation>Für die Rangkorrelation verwendeter Anteil der Maske; mindestens 2000 Pixel.</translation>
    </message>
    <message>
        <source>Smoothing scale of the image gradients.</source>
        <translation>Glättungsskala der Bildgradienten.</translation>
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
        <source>Resamples the points at even spacing before matching; if off, the points are used unchanged.</source>
        <translation>Verteilt die Punkte vor dem Zuordnen gleichmäßig; ausgeschaltet bleiben die Punkte unverändert.</translation>
    </message>
    <message>
        <source>Standard deviation of the in-plane position in the last full registration.</source>
        <translation>Standardabweichung der Position in der Bildebene bei der letzten vollständigen Registrierung.</translation>
    </message>
    <message>
        <source>Standard deviation of the depth in the last full registration.</source>
        <translation>Standardabweichung der Tiefe bei der letzten vollständigen Registrierung.</translation>
    </message>
    <message>
        <source>Standard deviation of the angles in the last full registration.</source>
        <translation>Standardabweichung der Winkel bei der letzten vollständigen Registrierung.</translation>
    </message>
    <message>
        <source>Standard deviation of the in-plane position of the initial pose.</source>
        <translation>Standardabweichung der Position der Startlage in der Bildebene.</translation>
    </message>
    <message>
        <source>Standard deviation of the depth of the initial pose.</source>
        <translation>Standardabweichung der Tiefe der Startlage.</translation>
    </message>
    <message>
        <source>Standard deviation of the angles of the initial pose; constrains the components that the image cannot determine.</source>
        <translation>Standardabweichung der Winkel der Startlage; legt die Komponenten fest, die das Bild nicht bestimmen kann.</translation>
    </message>
    <message>
        <source>Standard deviation of the distance of the guidewire from the centerline, in addition to its free play within the lumen.</source>
        <translation>Standardabweichung des Abstands zwischen Führungsdraht und Mittellinie, zusätzlich zum Spiel innerhalb des Lumens.</translation>
    </message>
    <message>
        <source>Initial depth ±</source>
        <translation>Starttiefe ±</translation>
    </message>
    <message>
        <source>Maximum number of steps along the flow, summed over all kernel widths.</source>
        <translation>Höchstzahl der Schritte längs des Flusses, über alle Kernbreiten summiert.</translation>
    </message>
    <message>
        <source>Path rank</source>
        <translation>Rang des Wegs</translation>
    </message>
    <message>
        <source>Auxiliary branch weight</source>
        <translation>Gewicht der Hilfsäste</translation>
    </message>
    <message>
        <source>Weight of the auxiliary branches relative to the fit of all branches; with a weight of 1, they are not fitted separately.</source>
        <translation>Gewicht der Hilfsäste gegenüber der Anpassung aller Äste; bei 1 werden sie nicht gesondert angepasst.</translation>
    </message>
    <message>
        <source>Geometry uncertainty</source>
        <translation>Unsicherheit der Geometrie</translation>
    </message>
    <message>
        <source>Uncertainty of the focal length and the principal point: typical of their source, as specified below, or none.</source>
        <translation>Unsicherheit von Brennweite und Hauptpunkt: typisch für ihre Herkunft, wie unten angegeben, oder keine.</translation>
    </message>
    <message>
        <source>Focal length ±</source>
        <translation>Brennweite ±</translation>
    </message>
    <message>
        <source>Standard deviation of the focal length; applies if the geometry uncertainty is set to “given”.</source>
        <translation>Standardabweichung der Brennweite; gilt, wenn die Unsicherheit der Geometrie auf „gegeben“ gesetzt ist.</translation>
    </message>
    <message>
        <source>Principal point ±</source>
        <translation>Hauptpunkt ±</translation>
    </message>
    <message>
        <source>Standard deviation of each principal-point coordinate; applies if the geometry uncertainty is set to “given”.</source>
        <translation>Standardabweichung jeder Koordinate des Hauptpunkts; gilt, wenn die Unsicherheit der Geometrie auf „gegeben“ gesetzt ist.</translation>
    </message>
    <message>
        <source>Estimate geometry</source>
        <translation>Geometrie schätzen</translation>
    </message>
    <message>
        <source>If the images clearly contradict the focal length or the principal point, adopts the values that best fit the images and registers again.</source>
        <translation>Wenn die Bilder Brennweite oder Hauptpunkt klar widersprechen, werden die daraus ermittelten Werte übernommen und erneut registriert.</translation>
    </message>
    <message>
        <source>Mirrored or rotated images</source>
        <translation>Gespiegelte oder gedrehte Bilder</translation>
    </message>
    <message>
        <source>If confidence is low, reports whether the image appears mirrored or rotated.</source>
        <translation>Meldet bei geringer Konfidenz, ob das Bild gespiegelt oder gedreht erscheint.</translation>
    </message>
    <message>
        <source>Deformation</source>
        <translation>Deformation</translation>
    </message>
    <message>
        <source>Whether to deform the vessels to match the image after rigid registration: never; automatically, if the fit suggests a deformation (AngioPose method, no degrees of freedom locked); or always.</source>
        <translation>Verformt die Gefäße nach der starren Registrierung auf das Bild: nie; automatisch, wenn die Anpassung auf eine Verformung hindeutet (Methode AngioPose, keine Freiheitsgrade gesperrt); oder immer.</translation>
    </message>
    <message>
        <source>Initial rotation ±</source>
        <translation>Startdrehung ±</translation>
    </message>
    <message>
        <source>Initial scale</source>
        <translation>Startskala</translation>
    </message>
    <message>
        <source>Initial shift ±</source>
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
        <source>Weight of the initial-pose prior.</source>
        <translation>Gewicht des Startlage-Priors.</translation>
    </message>
    <message>
        <source>Maximum number of refinement steps.</source>
        <translation>Höchstzahl der Verfeinerungsschritte.</translation>
    </message>
    <message>
        <source>Number of rounds; the spread of the particles decreases by one quarter in each round.</source>
        <translation>Anzahl der Runden; die Streuung der Partikel nimmt in jeder Runde um ein Viertel ab.</translation>
    </message>
    <message>
        <source>The traced vessels, or the image intensity at the scale of each vessel.</source>
        <translation>Die erkannten Gefäße oder die Bildintensität auf der Skala jedes Gefäßes.</translation>
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
        <source>Rotates about the X-ray source before all other steps.</source>
        <translation>Dreht vor allen anderen Schritten um den Fokus.</translation>
    </message>
    <message>
        <source>Scaling of the gradient step: balanced between rotation and translation, or unscaled in radians and millimeters, which yields hardly any translation.</source>
        <translation>Skalierung des Gradientenschritts: Drehung und Verschiebung ausgewogen, oder unskaliert in Bogenmaß und Millimetern, was kaum verschiebt.</translation>
    </message>
    <message>
        <source>Matching of vessel walls to image gradients by Powell&apos;s method (Mitrović 2013; reimplementation with our own parameters).</source>
        <translation>Gefäßwände gegen Bildgradienten, Powell-Verfahren (Mitrović 2013; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Initial width of the Gaussians in the mixture.</source>
        <translation>Anfängliche Breite der Gauß-Mischungen.</translation>
    </message>
    <message>
        <source>Final width of the Gaussians in the mixture.</source>
        <translation>Endgültige Breite der Gauß-Mischungen.</translation>
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
        <translation>Deformation</translation>
    </message>
    <message>
        <source>stopped by the user</source>
        <translation>vom Benutzer angehalten</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>Hilfsäste</translation>
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
        <source>C-arm angles for %1</source>
        <translation>C-Bogen-Winkel für %1</translation>
    </message>
    <message>
        <source>No branch</source>
        <translation>Kein Ast</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::AngleDialog</name>
    <message>
        <source>Origin only (±10 mm)</source>
        <translation>Nur am Abgang (±10 mm)</translation>
    </message>
    <message>
        <source>C-arm angles</source>
        <translation>C-Bogen-Winkel</translation>
    </message>
    <message>
        <source>Blue: visible at full length and without overlap. Amber: foreshortened or overlapped.</source>
        <translation>Blau: in voller Länge und ohne Überlagerung sichtbar. Orange: verkürzt oder überlagert.</translation>
    </message>
    <message>
        <source>Gantry position of this image.</source>
        <translation>C-Bogen-Stellung dieses Bildes.</translation>
    </message>
    <message>
        <source>Gantry limits</source>
        <translation>C-Bogen-Grenzen</translation>
    </message>
    <message>
        <source>Current: %1</source>
        <translation>Aktuell: %1</translation>
    </message>
    <message>
        <source>%1: foreshortening %2 %, overlap %3 %</source>
        <translation>%1: Verkürzung %2 %, Überlagerung %3 %</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::AngleMapPlot</name>
    <message>
        <source>Gantry angle map</source>
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
        <source>Simulated view at these angles</source>
        <translation>Simulierte Ansicht bei diesen Winkeln</translation>
    </message>
</context>
<context>
    <name>messages</name>
    <message>
        <source>The camera or the pose contains a value that is not a finite number. Export both again.</source>
        <comment>projection.not-finite</comment>
        <translation>Kamera oder Lage enthalten einen Wert, der keine endliche Zahl ist. Exportieren Sie sie neu.</translation>
    </message>
    <message>
        <source>The left 3 × 3 block of the projection matrix is singular, so this is not an X-ray camera. Export the matrix again.</source>
        <comment>projection.degenerate</comment>
        <translation>Der linke 3 × 3-Block der Projektionsmatrix ist singulär; dies ist also keine Röntgenkamera. Exportieren Sie sie neu.</translation>
    </message>
    <message>
        <source>The camera has skewed pixels (skew %1). Provide a camera without skew, or resample the image.</source>
        <comment>projection.skewed</comment>
        <translation>Die Kamera hat gescherte Pixel (Scherung %1). Geben Sie eine Kamera ohne Scherung an, oder tasten Sie das Bild neu ab.</translation>
    </message>
    <message>
        <source>K may contain only the focal lengths and the principal point: fx 0 cx, 0 fy cy, 0 0 1. Check that it is not transposed.</source>
        <comment>projection.intrinsics</comment>
        <translation>K darf nur Brennweiten und Hauptpunkt enthalten: fx 0 cx, 0 fy cy, 0 0 1. Prüfen Sie, ob sie transponiert ist.</translation>
    </message>
    <message>
        <source>R is not a rotation (it contains scale or shear). Provide a rigid pose in mm.</source>
        <comment>projection.no-rotation</comment>
        <translation>R ist keine Drehung (enthält Skalierung oder Scherung). Geben Sie eine starre Lage in mm an.</translation>
    </message>
    <message>
        <source>the file contains no camera with a pose. Provide P (3 × 4); or K (3 × 3), R (3 × 3, or rvec) and t (3).</source>
        <comment>exchange.no-pose</comment>
        <translation>die Datei enthält keine Kamera mit Lage. Geben Sie P (3 × 4) an, oder K (3 × 3), R (3 × 3 oder rvec) und t (3).</translation>
    </message>
    <message>
        <source>the file contains %1 numbers. P = K [R t] requires 12 numbers (three rows of four); a cameraFromPatient pose requires 16 (four rows of four).</source>
        <comment>exchange.numbers</comment>
        <translation>die Datei enthält %1 Zahlen. P = K [R t] hat 12 (drei Zeilen zu vier), eine Lage cameraFromPatient hat 16.</translation>
    </message>
    <message>
        <source>the camera has lens distortion (distortion coefficients). Undistort the image, then specify a camera without distortion.</source>
        <comment>exchange.distorted</comment>
        <translation>die Kamera hat eine Verzeichnung (Verzeichnungskoeffizienten). Entzerren Sie das Bild, und geben Sie dann eine Kamera ohne Verzeichnung an.</translation>
    </message>
    <message>
        <source>a pose in this format requires a camera. Specify a case, or a pose that includes a camera.</source>
        <comment>exchange.no-camera</comment>
        <translation>eine Lage in diesem Format braucht eine Kamera. Geben Sie einen Fall an, oder eine Lage mit Kamera.</translation>
    </message>
    <message>
        <source>a camera with a pose can be saved as .json, .txt, .yml, .yaml or .xml. Change the extension.</source>
        <comment>exchange.extension</comment>
        <translation>eine Kamera mit Lage lässt sich als .json, .txt, .yml, .yaml oder .xml speichern. Ändern Sie die Endung.</translation>
    </message>
    <message>
        <source>this is a PyTorch file, which can execute code when it is read. Save its pose as JSON first (FORMATS §3.4).</source>
        <comment>exchange.pickle</comment>
        <translation>dies ist eine PyTorch-Datei, die beim Lesen Code ausführen kann. Speichern Sie ihre Lage zuerst als JSON (FORMATS §3.4).</translation>
    </message>
    <message>
        <source>this is not a DiffDRR view: %1 is missing or invalid. FORMATS §3.4 lists the keys.</source>
        <comment>exchange.diffdrr-keys</comment>
        <translation>dies ist keine DiffDRR-Ansicht: %1 fehlt oder ist ungültig. FORMATS §3.4 listet die Schlüssel auf.</translation>
    </message>
    <message>
        <source>the file contains no fiducials. Export the points of a markups node.</source>
        <comment>fiducials.none</comment>
        <translation>die Datei enthält keine Fiducials. Exportieren Sie die Punkte eines Markups-Knotens.</translation>
    </message>
    <message>
        <source>line %1 contains no point (id,x,y,z,…). Export the points again.</source>
        <comment>fiducials.line</comment>
        <translation>Zeile %1 enthält keinen Punkt (id,x,y,z,…). Exportieren Sie die Punkte neu.</translation>
    </message>
    <message>
        <source>the coordinate system is %1, not LPS or RAS. Export the points in patient coordinates.</source>
        <comment>fiducials.system</comment>
        <translation>das Koordinatensystem ist %1, nicht LPS oder RAS. Exportieren Sie die Punkte in Patientenkoordinaten.</translation>
    </message>
    <message>
        <source>points can be saved as .fcsv or .mrk.json. Change the extension.</source>
        <comment>fiducials.extension</comment>
        <translation>Punkte lassen sich als .fcsv oder .mrk.json speichern. Ändern Sie die Endung.</translation>
    </message>
    <message>
        <source>%1 contains a pose or points. Open the case to which the file belongs first, then open this file separately.</source>
        <comment>open.pose-alone</comment>
        <translation>%1 enthält eine Lage oder Punkte. Öffnen Sie zuerst den zugehörigen Fall, dann diese Datei allein.</translation>
    </message>
    <message>
        <source>The pose was determined with a different camera from that of the case. The vessels are drawn with the camera stored with the pose.</source>
        <comment>pose.other-camera</comment>
        <translation>Die Lage wurde mit einer anderen Kamera bestimmt als der des Falls. Die Gefäße werden mit der bei der Lage gespeicherten Kamera gezeichnet.</translation>
    </message>
    <message>
        <source>The pose belongs to an image of %1 × %2 px, but the angiogram is %3 × %4 px. Choose the pose that belongs to this angiogram.</source>
        <comment>pose.other-image</comment>
        <translation>Die Lage gehört zu einem Bild von %1 × %2 px, das Angiogramm hat aber %3 × %4 px. Wählen Sie die zu diesem Angiogramm gehörende Lage.</translation>
    </message>
    <message>
        <source>the case has no landmarks, target points or ostium rings. Add some in the window first.</source>
        <comment>convert.no-points</comment>
        <translation>der Fall hat keine Landmarken, Zielpunkte oder Ostiumringe. Setzen Sie zuerst welche im Fenster.</translation>
    </message>
    <message>
        <source>For this pose, the detector is assumed to be at negative z without an extrinsic matrix, as in xReg X-ray data. Use --camera if the image is mirrored.</source>
        <comment>convert.xreg-guessed</comment>
        <translation>Für die Lage wird ein Detektor bei negativem z ohne extrinsische Matrix angenommen, wie in xReg-Röntgendaten. Geben Sie --camera an, wenn das Bild gespiegelt ist.</translation>
    </message>
    <message>
        <source>the operating system provides no random numbers, so pseudonyms cannot be kept secret.</source>
        <comment>deidentify.no-random-key</comment>
        <translation>das Betriebssystem liefert keine Zufallszahlen; Pseudonyme lassen sich daher nicht geheim halten.</translation>
    </message>
    <message>
        <source>The image contains burned-in text, for example at column %1, row %2. Review the text, or mask it.</source>
        <comment>deidentify.letters-stay</comment>
        <translation>Das Bild enthält eingebrannten Text, zum Beispiel bei Spalte %1, Zeile %2. Prüfen oder maskieren Sie ihn.</translation>
    </message>
    <message>
        <source>Burned-in text was masked (%1 % of the image area). Check that no text remains.</source>
        <comment>deidentify.letters-blacked-out</comment>
        <translation>Eingebrannter Text wurde maskiert (%1 % der Bildfläche). Prüfen Sie, dass nichts übrig ist.</translation>
    </message>
    <message>
        <source>According to the header, patient information is burned into the image, but no text was detected. Review every frame.</source>
        <comment>deidentify.letters-declared</comment>
        <translation>Laut Header sind Patientendaten in das Bild eingebrannt, doch es wurde kein Text gefunden. Prüfen Sie jedes Einzelbild.</translation>
    </message>
    <message>
        <source>Colors were converted to gray levels, as displayed in the program.</source>
        <comment>deidentify.colour-dropped</comment>
        <translation>Farben wurden in Graustufen umgewandelt, wie im Programm dargestellt.</translation>
    </message>
    <message>
        <source>Damaged frames were saved as far as they could be decoded: %1 of %2.</source>
        <comment>deidentify.frames-damaged</comment>
        <translation>Beschädigte Einzelbilder wurden gespeichert, soweit sie zu decodieren waren: %1 von %2.</translation>
    </message>
    <message>
        <source>Files without an image were skipped: %1 of %2.</source>
        <comment>deidentify.files-left-out</comment>
        <translation>Dateien ohne Bild wurden übersprungen: %1 von %2.</translation>
    </message>
    <message>
        <source>the segments use an encoding that cannot be written. Convert the file to .nii.gz or .nrrd; these formats store no label names.</source>
        <comment>deidentify.segmentation</comment>
        <translation>die Segmente verwenden eine Codierung, die sich nicht schreiben lässt. Wandeln Sie die Datei in .nii.gz oder .nrrd um; diese Formate speichern keine Label-Namen.</translation>
    </message>
    <message>
        <source>the compressed 32-bit pixels cannot be re-encoded. Convert the file to .nii.gz or .nrrd.</source>
        <comment>deidentify.pixels-too-wide</comment>
        <translation>die komprimierten 32-Bit-Pixel lassen sich nicht neu codieren. Wandeln Sie die Datei in .nii.gz oder .nrrd um.</translation>
    </message>
    <message>
        <source>only PNG, JPEG, TIFF and DICOM images can be stripped of metadata. Save the image as PNG.</source>
        <comment>deidentify.picture</comment>
        <translation>nur aus PNG-, JPEG-, TIFF- und DICOM-Bildern lassen sich die Metadaten entfernen. Speichern Sie es als PNG.</translation>
    </message>
    <message>
        <source>the folder is not empty. Choose an empty folder so that no other files are shared with the output.</source>
        <comment>deidentify.output-not-empty</comment>
        <translation>der Ordner ist nicht leer. Wählen Sie einen leeren, damit keine anderen Dateien mit weitergegeben werden.</translation>
    </message>
    <message>
        <source>the folder contains no DICOM image. Choose the folder of one study.</source>
        <comment>deidentify.nothing</comment>
        <translation>der Ordner enthält kein DICOM-Bild. Wählen Sie den Ordner einer Studie.</translation>
    </message>
    <message>
        <source>an input file of the case could not be read and is therefore missing from the ZIP archive: %1</source>
        <comment>pack.input-missing</comment>
        <translation>eine Eingabedatei des Falls war nicht lesbar und fehlt im ZIP-Archiv: %1</translation>
    </message>
    <message>
        <source>cases can be shared only as .zip. Change the extension.</source>
        <comment>pack.format</comment>
        <translation>Fälle werden als .zip weitergegeben. Ändern Sie die Endung.</translation>
    </message>
    <message>
        <source>the ZIP archive cannot be written (%1). Choose another folder, or free disk space.</source>
        <comment>pack.not-written</comment>
        <translation>das ZIP-Archiv lässt sich nicht schreiben (%1). Wählen Sie einen anderen Ordner, oder schaffen Sie Speicherplatz.</translation>
    </message>
    <message>
        <source>Names, notes and other text entered by users were replaced by numbers (count: %1).</source>
        <comment>pack.texts-cleared</comment>
        <translation>Eingegebene Namen, Notizen und Texte wurden durch Nummern ersetzt: %1.</translation>
    </message>
    <message>
        <source>the ZIP archive does not match the original case: %1 Nothing was written.</source>
        <comment>pack.differs</comment>
        <translation>das ZIP-Archiv stimmt nicht mit dem ursprünglichen Fall überein: %1 Es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>Branch names are kept. Check that they contain anatomy only.</source>
        <comment>pack.branch-names</comment>
        <translation>Astnamen bleiben erhalten. Prüfen Sie, dass sie nur Anatomie benennen.</translation>
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
        <source>a result is no longer valid.</source>
        <comment>pack.results</comment>
        <translation>ein Ergebnis ist nicht mehr gültig.</translation>
    </message>
    <message>
        <source>the vessels differ.</source>
        <comment>pack.vessels</comment>
        <translation>die Gefäße weichen ab.</translation>
    </message>
    <message>
        <source>a key must be at least 16 bytes long. To create one: head -c 32 /dev/urandom &gt; key</source>
        <comment>deidentify.key-too-short</comment>
        <translation>ein Schlüssel braucht mindestens 16 Byte. Einen erzeugen: head -c 32 /dev/urandom &gt; key</translation>
    </message>
    <message>
        <source>the output for this file must have the extension %1; the output for a folder is a folder. Name OUT accordingly.</source>
        <comment>deidentify.kind</comment>
        <translation>die Ausgabe für diese Datei muss die Endung %1 haben; die Ausgabe für einen Ordner ist ein Ordner. Benennen Sie OUT entsprechend.</translation>
    </message>
    <message>
        <source>this TIFF cannot be rewritten losslessly (supported: grayscale, palette and RGB images in strips, with 8-bit, 16-bit or floating-point samples). Convert it to PNG.</source>
        <comment>deidentify.tiff</comment>
        <translation>dieses TIFF lässt sich nicht verlustfrei wieder speichern (unterstützt: Grau, Palette oder RGB mit 8 oder 16 Bit oder Gleitkomma, in Streifen). Speichern Sie es als PNG.</translation>
    </message>
    <message>
        <source>this is a PDF document, and any of its pages may contain names. Create it again from a de-identified case.</source>
        <comment>deidentify.pages</comment>
        <translation>dies ist ein PDF-Dokument, dessen Seiten überall Namen enthalten können. Erzeugen Sie es neu aus einem de-identifizierten Fall.</translation>
    </message>
    <message>
        <source>objects of SOP class %1 contain data that cannot be reliably de-identified. Exclude this object.</source>
        <comment>deidentify.object</comment>
        <translation>Objekte der SOP-Klasse %1 enthalten Daten, die sich nicht zuverlässig de-identifizieren lassen. Schließen Sie dieses Objekt aus.</translation>
    </message>
    <message>
        <source>the SOP class (%1) does not define an image, but the file contains one, which would be lost. Export the object again, or exclude it.</source>
        <comment>deidentify.object-with-pixels</comment>
        <translation>die SOP-Klasse (%1) sieht kein Bild vor, die Datei enthält aber eines, das verloren ginge. Exportieren Sie das Objekt erneut, oder schließen Sie es aus.</translation>
    </message>
    <message>
        <source>Free text was removed from reports, segmentations or presentation states (count: %1); codes and numbers were kept.</source>
        <comment>deidentify.words-cleared</comment>
        <translation>Freitext wurde aus Befunden, Segmentierungen oder Darstellungszuständen entfernt (Anzahl: %1); Kodes und Zahlen blieben erhalten.</translation>
    </message>
    <message>
        <source>Alternative path: %1 (probability %2).</source>
        <comment>wire.may-follow</comment>
        <translation>Alternativer Weg: %1 (%2).</translation>
    </message>
    <message>
        <source>No path through the vessel tree is likely: the best path has a probability of %1.</source>
        <comment>wire.unlikely</comment>
        <translation>Kein Weg durch den Gefäßbaum ist wahrscheinlich: der beste hat eine Wahrscheinlichkeit von %1.</translation>
    </message>
    <message>
        <source>Only %1 of the guidewire lies along the vessel tree.</source>
        <comment>wire.off-tree</comment>
        <translation>Nur %1 des Führungsdrahts liegen entlang des Gefäßbaums.</translation>
    </message>
    <message>
        <source>The traced curves do not form a single line: %1 of its length is gaps. Remove the curves that do not belong to the guidewire.</source>
        <comment>wire.in-pieces</comment>
        <translation>Die erkannten Kurven bilden keine einzelne Linie: %1 davon sind Lücken. Entfernen Sie die Kurven, die nicht zum Führungsdraht gehören.</translation>
    </message>
    <message>
        <source>The guidewire does not match any path through the vessel tree near the initial pose. Start from the last full registration, or allow a larger deviation.</source>
        <comment>wire.nowhere</comment>
        <translation>Der Führungsdraht passt nahe der Startlage zu keinem Weg im Gefäßbaum. Beginnen Sie mit der letzten vollständigen Registrierung, oder lassen Sie eine größere Abweichung zu.</translation>
    </message>
    <message>
        <source>The guidewire follows branches %1 with a probability of %2, at a distance of %3 from their centerlines.</source>
        <comment>wire.follows</comment>
        <translation>Der Führungsdraht folgt mit einer Wahrscheinlichkeit von %2 den Ästen %1; er liegt %3 neben den Mittellinien.</translation>
    </message>
    <message>
        <source>The requested path rank exceeds the number of likely paths (%1): the most likely path is used instead.</source>
        <comment>wire.fewer-ways</comment>
        <translation>Der gewünschte Rang übersteigt die Zahl der wahrscheinlichen Wege (%1): Stattdessen wird der wahrscheinlichste verwendet.</translation>
    </message>
    <message>
        <source>images can be saved as .png or .svg, and in the window also as .pdf. Choose one of these.</source>
        <comment>picture.kind</comment>
        <translation>Bilder lassen sich als .png oder .svg speichern, im Fenster auch als .pdf. Wählen Sie eines davon.</translation>
    </message>
    <message>
        <source>16-bit gray values can be saved only as .png.</source>
        <comment>picture.grey-kind</comment>
        <translation>Grauwerte mit 16 Bit lassen sich nur als .png speichern.</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; cannot be created: %2.</source>
        <comment>folder.not-made</comment>
        <translation>Der Ordner „%1“ lässt sich nicht anlegen: %2.</translation>
    </message>
    <message>
        <source>Unexpected error: %1</source>
        <comment>run.unexpected-failure</comment>
        <translation>Unerwarteter Fehler: %1</translation>
    </message>
    <message>
        <source>unknown setting &apos;%1&apos;. Closest names: %2.</source>
        <comment>setting.unknown</comment>
        <translation>es gibt keine Einstellung „%1“. Die ähnlichsten Namen sind: %2.</translation>
    </message>
    <message>
        <source>invalid value &apos;%2&apos; for the setting %1: %3</source>
        <comment>setting.value</comment>
        <translation>ungültiger Wert „%2“ für die Einstellung %1: %3</translation>
    </message>
    <message>
        <source>a batch file needs a header row with a case column, or with vessels and angiogram columns, and one row per case.</source>
        <comment>batch.header-missing</comment>
        <translation>eine Stapeldatei braucht eine Kopfzeile mit der Spalte case oder mit den Spalten vessels und angiogram, und eine Zeile je Fall.</translation>
    </message>
    <message>
        <source>line %1, column %2: %3</source>
        <comment>batch.cell</comment>
        <translation>Zeile %1, Spalte %2: %3</translation>
    </message>
    <message>
        <source>line %1 specifies both a case and inputs. Specify either the case, or its vessels and angiogram.</source>
        <comment>batch.not-both</comment>
        <translation>Zeile %1 nennt sowohl einen Fall als auch Eingaben. Nennen Sie entweder den Fall, oder seine Gefäße und sein Angiogramm.</translation>
    </message>
    <message>
        <source>line %1 is incomplete. Specify a case, or both vessels and an angiogram.</source>
        <comment>batch.inputs-lack</comment>
        <translation>Zeile %1 ist unvollständig. Nennen Sie einen Fall, oder sowohl Gefäße als auch ein Angiogramm.</translation>
    </message>
    <message>
        <source>line %1: invalid seeds &apos;%2&apos;. Specify x y z in mm (LPS), with &apos;;&apos; between points.</source>
        <comment>batch.seeds-unclear</comment>
        <translation>Zeile %1: Die Startpunkte „%2“ sind keine Punkte. Schreiben Sie x y z in mm (LPS), mit „;“ zwischen den Punkten.</translation>
    </message>
    <message>
        <source>the worker process ended unexpectedly (%1). Its partial output was discarded.</source>
        <comment>batch.crashed</comment>
        <translation>der Arbeitsprozess endete unerwartet (%1). Seine unvollständige Ausgabe wurde verworfen.</translation>
    </message>
    <message>
        <source>the case exceeded the time limit of %1 and was aborted. Raise the limit with --time-limit.</source>
        <comment>batch.out-of-time</comment>
        <translation>der Fall überschritt das Zeitlimit von %1 und wurde abgebrochen. Erhöhen Sie es mit --time-limit.</translation>
    </message>
    <message>
        <source>the worker program %1 cannot be started.</source>
        <comment>batch.no-worker</comment>
        <translation>das Arbeitsprogramm %1 lässt sich nicht starten.</translation>
    </message>
    <message>
        <source>the input contains %1 series. Specify a file of one of them, or a case that specifies the series.</source>
        <comment>batch.several-series</comment>
        <translation>die Eingabe enthält %1 Serien. Nennen Sie eine Datei einer davon, oder einen Fall, der die Serie nennt.</translation>
    </message>
    <message>
        <source>the vessels span %1 units, which are unlikely to be millimeters. Specify a case that defines the unit.</source>
        <comment>batch.unit-unclear</comment>
        <translation>die Gefäße messen insgesamt %1 Einheiten, was kaum Millimeter sind. Nennen Sie einen Fall, der die Einheit angibt.</translation>
    </message>
    <message>
        <source>no folder contains a result for this row. Process the row with --resume.</source>
        <comment>batch.row-missing</comment>
        <translation>kein Ordner enthält ein Ergebnis zu dieser Zeile. Führen Sie sie mit --resume aus.</translation>
    </message>
    <message>
        <source>the results of %1 and %2 were computed with different settings or versions. Merge only results with the same settings and version.</source>
        <comment>batch.merge-differs</comment>
        <translation>die Ergebnisse von %1 und %2 stammen aus unterschiedlichen Einstellungen oder Versionen. Führen Sie nur Ergebnisse gleicher Einstellungen und Version zusammen.</translation>
    </message>
    <message>
        <source>this case has not been registered: its vessels are at the initial pose. Use --register, or --from with a result; use --start-pose to export the initial pose itself.</source>
        <comment>dicom-export.at-start</comment>
        <translation>dieser Fall wurde nicht registriert: Seine Gefäße sind in der Startlage. Geben Sie --register an, oder --from mit einem Ergebnis; mit --start-pose wird die Startlage selbst exportiert.</translation>
    </message>
    <message>
        <source>This case has not been registered: the vessels are drawn at the initial pose. Register the case with --save, or use --pose or --from.</source>
        <comment>command.drawn-at-start</comment>
        <translation>Dieser Fall wurde nicht registriert: Die Gefäße sind in der Startlage gezeichnet. Registrieren Sie ihn mit --save, oder geben Sie --pose oder --from an.</translation>
    </message>
    <message>
        <source>initial pose, not registered</source>
        <comment>pose.at-start</comment>
        <translation>Startlage, nicht registriert</translation>
    </message>
    <message>
        <source>this is not a registration result. Provide a result.json or joint.json written by `register` or `batch`.</source>
        <comment>result.not-one</comment>
        <translation>dies ist kein Registrierungsergebnis. Geben Sie eine result.json oder joint.json an, die `register` oder `batch` geschrieben hat.</translation>
    </message>
    <message>
        <source>the result does not record its inputs: it was computed by an earlier version, or with estimated geometry. Register its case instead.</source>
        <comment>result.without-case</comment>
        <translation>das Ergebnis hält seine Eingaben nicht fest: Es wurde mit einer früheren Version berechnet, oder die Geometrie wurde geschätzt. Registrieren Sie stattdessen seinen Fall.</translation>
    </message>
    <message>
        <source>no file with the recorded contents (SHA-256 %2) was found for input %1. Specify its folder with --inputs.</source>
        <comment>result.input-missing</comment>
        <translation>es wurde keine Eingabe %1 mit dem aufgezeichneten Inhalt (SHA-256 %2) gefunden. Geben Sie ihren Ordner mit --inputs an.</translation>
    </message>
    <message>
        <source>the contents of input %1 have changed since the result was computed. Specify the folder of the original with --inputs.</source>
        <comment>result.input-changed</comment>
        <translation>der Inhalt der Eingabe %1 hat sich seit der Berechnung geändert. Geben Sie den Ordner des Originals mit --inputs an.</translation>
    </message>
    <message>
        <source>--shard expects a part and the number of parts, such as 2/4, not &apos;%1&apos;.</source>
        <comment>command.shard-unclear</comment>
        <translation>--shard braucht den Teil und die Anzahl der Teile, z. B. 2/4, nicht „%1“.</translation>
    </message>
    <message>
        <source>There is no degree of freedom &apos;%1&apos;. Available: %2, or none.</source>
        <comment>command.no-such-freedom</comment>
        <translation>Es gibt keinen Freiheitsgrad „%1“. Möglich: %2 oder none.</translation>
    </message>
    <message>
        <source>there is no deformable registration for this pose. Register a frame in which the vessels appear deformed, or use the option deformable=always.</source>
        <comment>command.no-bent-vessels</comment>
        <translation>zu dieser Lage gibt es keine deformierbare Registrierung. Registrieren Sie ein Bild, in dem die Gefäße verformt erscheinen, oder verwenden Sie die Option deformable=always.</translation>
    </message>
    <message>
        <source>the image of this view could not be read.</source>
        <comment>command.view-image-unread</comment>
        <translation>das Bild dieser Ansicht konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The folders to merge contain results of &apos;%1&apos; instead of &apos;%2&apos;.</source>
        <comment>command.merge-of-others</comment>
        <translation>Die zusammenzuführenden Ordner enthalten Ergebnisse von „%1“, nicht von „%2“.</translation>
    </message>
    <message>
        <source>the file contains no centerlines yet. Trace them with: angiopose-cli trace-vessel %1 --output %2.</source>
        <comment>convert.no-curves</comment>
        <translation>die Datei enthält noch keine Mittellinien. Erfassen Sie sie mit: angiopose-cli trace-vessel %1 --output %2.</translation>
    </message>
    <message>
        <source>this is neither a volume nor a surface, so it cannot be converted to a volume. Choose a scan (DICOM, NIfTI, NRRD, MetaImage) or a surface, or choose another output name.</source>
        <comment>convert.no-volume</comment>
        <translation>dies ist weder Volumen noch Oberfläche und lässt sich nicht in ein Volumen umwandeln. Wählen Sie einen Scan (DICOM, NIfTI, NRRD, MetaImage) oder eine Oberfläche, oder einen anderen Ausgabenamen.</translation>
    </message>
    <message>
        <source>files with this extension cannot be written. Centerlines: .vtp, .csv, .swc, .mrk.json; volumes: .nii, .nii.gz, .nrrd, .mha; surfaces: .stl; poses: .json, .tfm, .h5; X-ray runs: .dcm.</source>
        <comment>convert.extension</comment>
        <translation>diese Endung lässt sich nicht schreiben. Mittellinien: .vtp, .csv, .swc, .mrk.json; Volumen: .nii, .nii.gz, .nrrd, .mha; Oberflächen: .stl; Lagen: .json, .tfm, .h5; Röntgenserien: .dcm.</translation>
    </message>
    <message>
        <source>this is the input file, which is never overwritten. Choose another name.</source>
        <comment>convert.onto-input</comment>
        <translation>das ist die Eingabedatei, die nie überschrieben wird. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>this is not a label image, so it has no labels. Omit --label, or choose a segmentation.</source>
        <comment>trace.no-labels</comment>
        <translation>dies ist kein Label-Bild und hat daher keine Labels. Lassen Sie --label weg, oder wählen Sie eine Segmentierung.</translation>
    </message>
    <message>
        <source>the file already contains centerlines, so no tracing is needed. Use `convert` to change the format.</source>
        <comment>trace.centrelines</comment>
        <translation>die Datei enthält bereits Mittellinien; Erfassen ist nicht nötig. Das Format ändert `convert`.</translation>
    </message>
    <message>
        <source>this surface cannot be traced. Choose another one.</source>
        <comment>trace.other-surface</comment>
        <translation>diese Oberfläche lässt sich nicht erfassen. Wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>the detection of thin vessels requires the gray values of a scan, but this file has none. Omit --tubes.</source>
        <comment>trace.tubes-of-mask</comment>
        <translation>zum Erkennen dünner Gefäße sind die Grauwerte eines Scans nötig; diese Datei enthält keine. Lassen Sie --tubes weg.</translation>
    </message>
    <message>
        <source>this file cannot be traced. Choose a scan.</source>
        <comment>trace.no-scan</comment>
        <translation>diese Datei lässt sich nicht erfassen. Wählen Sie einen Scan.</translation>
    </message>
    <message>
        <source>unsupported file type. AngioPose reads cases (.angiopose), centerlines (VTP, VTK, CSV, SWC, .mrk.json), scans and segmentations (DICOM, NIfTI, NRRD, MetaImage), surfaces (STL, PLY, OBJ), angiograms (DICOM, PNG, TIFF, JPEG) and poses (.json, .tfm).</source>
        <comment>info.unknown</comment>
        <translation>nicht unterstützter Dateityp. AngioPose liest Fälle (.angiopose), Mittellinien (VTP, VTK, CSV, SWC, .mrk.json), Scans und Segmentierungen (DICOM, NIfTI, NRRD, MetaImage), Oberflächen (STL, PLY, OBJ), Angiogramme (DICOM, PNG, TIFF, JPEG) und Lagen (.json, .tfm).</translation>
    </message>
    <message>
        <source>this is %1, which AngioPose does not read. AngioPose reads cases (.angiopose), centerlines (VTP, VTK, CSV, SWC, .mrk.json), scans and segmentations (DICOM, NIfTI, NRRD, MetaImage), surfaces (STL, PLY, OBJ), angiograms (DICOM, PNG, TIFF, JPEG) and poses (.json, .tfm).</source>
        <comment>info.other</comment>
        <translation>dies ist %1, was AngioPose nicht liest. AngioPose liest Fälle (.angiopose), Mittellinien (VTP, VTK, CSV, SWC, .mrk.json), Scans und Segmentierungen (DICOM, NIfTI, NRRD, MetaImage), Oberflächen (STL, PLY, OBJ), Angiogramme (DICOM, PNG, TIFF, JPEG) und Lagen (.json, .tfm).</translation>
    </message>
    <message>
        <source>Not enough memory. Close other programs, or use smaller inputs.</source>
        <comment>run.not-enough-memory</comment>
        <translation>Nicht genügend Speicher. Schließen Sie andere Programme, oder verwenden Sie kleinere Daten.</translation>
    </message>
    <message>
        <source>A software library reported an error: %1. Check the inputs.</source>
        <comment>run.library-gave-up</comment>
        <translation>Eine Bibliothek meldet einen Fehler: %1. Prüfen Sie die Eingaben.</translation>
    </message>
    <message>
        <source>The registration was stopped before it began.</source>
        <comment>run.stopped-before</comment>
        <translation>Die Registrierung wurde angehalten, bevor sie begann.</translation>
    </message>
    <message>
        <source>There is nothing to show yet.</source>
        <comment>run.not-shown</comment>
        <translation>Noch nichts anzuzeigen.</translation>
    </message>
    <message>
        <source>The scan does not cover the vessels. Show the whole scan, or open the scan that contains them.</source>
        <comment>scan.beside-vessels</comment>
        <translation>Der Scan reicht nicht bis zu den Gefäßen. Zeigen Sie den ganzen Scan, oder öffnen Sie den Scan, der die Gefäße enthält.</translation>
    </message>
    <message>
        <source>An overlay requires a vessel tree and an angiogram. Open both first.</source>
        <comment>picture.overlay-incomplete</comment>
        <translation>Eine Überlagerung braucht Gefäßbaum und Angiogramm. Öffnen Sie zuerst beide.</translation>
    </message>
    <message>
        <source>Exporting an image requires a vessel tree and an angiogram. Open both first.</source>
        <comment>picture.incomplete</comment>
        <translation>Ein Bildexport braucht Gefäßbaum und Angiogramm. Öffnen Sie zuerst beide.</translation>
    </message>
    <message>
        <source>stopped; objects already received in full are kept.</source>
        <comment>archive.stopped</comment>
        <translation>angehalten; vollständig empfangene Objekte bleiben erhalten.</translation>
    </message>
    <message>
        <source>host %1 is unknown. Check the host name in the PACS list and the network connection.</source>
        <comment>archive.unknown-host</comment>
        <translation>der Host %1 ist unbekannt. Prüfen Sie seinen Namen in der PACS-Liste und das Netzwerk.</translation>
    </message>
    <message>
        <source>%1 cannot be reached (%2). Check the host, the port and the network connection, and check that the PACS is running.</source>
        <comment>archive.no-connection</comment>
        <translation>%1 ist nicht erreichbar (%2). Prüfen Sie Host, Port und Netzwerk, und ob das PACS läuft.</translation>
    </message>
    <message>
        <source>%1 accepted the connection but did not answer within %2. Check that the port belongs to a PACS.</source>
        <comment>archive.silent</comment>
        <translation>%1 nahm die Verbindung an, antwortete aber nicht innerhalb von %2. Prüfen Sie, ob der Port zu einem PACS gehört.</translation>
    </message>
    <message>
        <source>no response within %1. Try again later, or increase the response timeout of this PACS; objects already received in full are kept.</source>
        <comment>archive.no-answer</comment>
        <translation>keine Antwort innerhalb von %1. Versuchen Sie es später erneut, oder erhöhen Sie das Antwort-Timeout dieses PACS; vollständig empfangene Objekte bleiben erhalten.</translation>
    </message>
    <message>
        <source>the connection was lost (%1). Try again; objects already received in full are kept.</source>
        <comment>archive.broken</comment>
        <translation>die Verbindung brach ab (%1). Versuchen Sie es erneut; vollständig empfangene Objekte bleiben erhalten.</translation>
    </message>
    <message>
        <source>%2 does not recognize the called AE title %1. Correct the AE title of this PACS in the PACS list.</source>
        <comment>archive.unknown-title</comment>
        <translation>%2 kennt den gerufenen AE-Titel %1 nicht. Berichtigen Sie den AE-Titel dieses PACS in der PACS-Liste.</translation>
    </message>
    <message>
        <source>the PACS does not recognize our calling AE title %1. Have it registered there, or correct it in the PACS list.</source>
        <comment>archive.title-not-allowed</comment>
        <translation>das PACS kennt unseren rufenden AE-Titel %1 nicht. Lassen Sie ihn dort eintragen, oder berichtigen Sie ihn in der PACS-Liste.</translation>
    </message>
    <message>
        <source>the association was rejected (%1). Ask the PACS administrator whether this computer may connect.</source>
        <comment>archive.refused</comment>
        <translation>die Assoziation wurde abgelehnt (%1). Fragen Sie den PACS-Administrator, ob sich dieser Rechner verbinden darf.</translation>
    </message>
    <message>
        <source>the PACS aborted the association. Check its log, or try again; objects already received in full are kept.</source>
        <comment>archive.aborted</comment>
        <translation>das PACS brach die Assoziation ab. Prüfen Sie sein Protokoll, oder versuchen Sie es erneut; vollständig empfangene Objekte bleiben erhalten.</translation>
    </message>
    <message>
        <source>the PACS does not offer the requested service (%1). Ask its administrator to enable it for our AE title %2.</source>
        <comment>archive.no-service</comment>
        <translation>das PACS bietet %1 nicht an. Bitten Sie den Administrator, es für unseren AE-Titel %2 freizugeben.</translation>
    </message>
    <message>
        <source>%1 failed with %2. Check the PACS log, or ask the PACS administrator.</source>
        <comment>archive.status</comment>
        <translation>%1 schlug mit %2 fehl. Prüfen Sie das Protokoll des PACS, oder fragen Sie den Administrator.</translation>
    </message>
    <message>
        <source>the response is invalid (%1). Check that the host, port and address belong to a PACS.</source>
        <comment>archive.nonsense</comment>
        <translation>die Antwort ist ungültig (%1). Prüfen Sie, ob Host, Port und Adresse zu einem PACS gehören.</translation>
    </message>
    <message>
        <source>the TLS handshake failed (%1). Check the CA file of this PACS and the certificates, and check whether this port uses TLS.</source>
        <comment>archive.tls-refused</comment>
        <translation>der TLS-Handshake schlug fehl (%1). Prüfen Sie die CA-Datei dieses PACS, die Zertifikate, und ob dieser Port TLS verwendet.</translation>
    </message>
    <message>
        <source>the file %1 cannot be used for TLS (%2). Check its path and contents.</source>
        <comment>archive.tls-file</comment>
        <translation>die Datei %1 ist für TLS nicht verwendbar (%2). Prüfen Sie Pfad und Inhalt.</translation>
    </message>
    <message>
        <source>the certificate was not issued for host %1. Check the host; if it is correct, turn off the host name check for this PACS.</source>
        <comment>archive.tls-host</comment>
        <translation>das Zertifikat wurde nicht für den Host %1 ausgestellt. Prüfen Sie den Host; ist er richtig, schalten Sie die Prüfung des Hostnamens für dieses PACS aus.</translation>
    </message>
    <message>
        <source>this is not a PACS list (%1). Correct or delete the file.</source>
        <comment>archive.list-invalid</comment>
        <translation>dies ist keine PACS-Liste (%1). Berichtigen Sie sie, oder löschen Sie die Datei.</translation>
    </message>
    <message>
        <source>the PACS %1 is not listed in %2; available: %3. Add the PACS, or correct the name.</source>
        <comment>archive.unknown</comment>
        <translation>das PACS %1 steht nicht in %2; vorhanden: %3. Fügen Sie es hinzu, oder berichtigen Sie den Namen.</translation>
    </message>
    <message>
        <source>a PACS has no valid name. Enter a name of 1 to 64 characters.</source>
        <comment>archive.no-name</comment>
        <translation>ein PACS hat keinen gültigen Namen. Geben Sie 1 bis 64 Zeichen ein.</translation>
    </message>
    <message>
        <source>the PACS has neither a host nor a DICOMweb address. Enter one of them.</source>
        <comment>archive.no-address</comment>
        <translation>das PACS hat weder einen Host noch eine DICOMweb-Adresse. Geben Sie eines davon ein.</translation>
    </message>
    <message>
        <source>%1 is not a valid host. Enter a host name or IP address without port or spaces.</source>
        <comment>archive.bad-host</comment>
        <translation>%1 ist kein gültiger Host. Geben Sie einen Hostnamen oder eine IP-Adresse ohne Port und Leerzeichen ein.</translation>
    </message>
    <message>
        <source>port %1 is invalid. Enter a number from 1 to 65535.</source>
        <comment>archive.bad-port</comment>
        <translation>Port %1 ist ungültig. Geben Sie eine Zahl von 1 bis 65535 ein.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a valid AE title. Enter 1 to 16 letters, digits or symbols except the backslash.</source>
        <comment>archive.bad-title</comment>
        <translation>„%1“ ist kein gültiger AE-Titel. Geben Sie 1 bis 16 Buchstaben, Ziffern oder Zeichen außer dem umgekehrten Schrägstrich ein.</translation>
    </message>
    <message>
        <source>%1 is not a DICOMweb address. Enter one that begins with https:// or http://.</source>
        <comment>archive.bad-url</comment>
        <translation>%1 ist keine DICOMweb-Adresse. Geben Sie eine ein, die mit https:// oder http:// beginnt.</translation>
    </message>
    <message>
        <source>the response timeout is invalid. Enter a value from 1 to 600 s.</source>
        <comment>archive.bad-time</comment>
        <translation>das Antwort-Timeout ist ungültig. Geben Sie 1 bis 600 s ein.</translation>
    </message>
    <message>
        <source>a client certificate and its private key must be specified together; one of them is missing. Specify both files.</source>
        <comment>archive.key-without-certificate</comment>
        <translation>Client-Zertifikat und privater Schlüssel sind nur zusammen verwendbar; eines fehlt. Geben Sie beide Dateien an.</translation>
    </message>
    <message>
        <source>the PACS has only a DICOMweb address. Enter a host and port as well, or use DICOMweb.</source>
        <comment>archive.no-dimse</comment>
        <translation>das PACS hat nur eine DICOMweb-Adresse. Geben Sie auch Host und Port ein, oder verwenden Sie DICOMweb.</translation>
    </message>
    <message>
        <source>the PACS has no DICOMweb address. Enter one, or use DIMSE.</source>
        <comment>archive.no-web</comment>
        <translation>das PACS hat keine DICOMweb-Adresse. Geben Sie eine ein, oder verwenden Sie DIMSE.</translation>
    </message>
    <message>
        <source>names and images are sent to %1 unencrypted. On a shared network, use TLS or https://.</source>
        <comment>archive.plain-text</comment>
        <translation>Namen und Bilder werden unverschlüsselt an %1 gesendet. Verwenden Sie in gemeinsam genutzten Netzen https:// oder TLS.</translation>
    </message>
    <message>
        <source>%1 is not a date. Enter YYYY-MM-DD, or a range such as 2024-01-01..2024-02-01.</source>
        <comment>archive.bad-date</comment>
        <translation>%1 ist kein Datum. Geben Sie JJJJ-MM-TT ein, oder einen Bereich wie 2024-01-01..2024-02-01.</translation>
    </message>
    <message>
        <source>there are more than %1 matches; the others are omitted. Narrow the query.</source>
        <comment>archive.many-matches</comment>
        <translation>es gibt mehr als %1 Treffer; der Rest fehlt. Schränken Sie die Suche ein.</translation>
    </message>
    <message>
        <source>the PACS has no data for %1. Repeat the query.</source>
        <comment>archive.nothing-there</comment>
        <translation>das PACS hat keine Daten zu %1. Suchen Sie erneut.</translation>
    </message>
    <message>
        <source>%1 is not a UID. Copy it from the output of `find`.</source>
        <comment>archive.bad-uid</comment>
        <translation>%1 ist keine UID. Kopieren Sie sie aus der Ausgabe von `find`.</translation>
    </message>
    <message>
        <source>%1 of %2 objects were received; the PACS did not send the others (%3). Retrieve them again, or check the PACS log.</source>
        <comment>archive.not-all-came</comment>
        <translation>%1 von %2 Objekten wurden empfangen; die übrigen sendete das PACS nicht (%3). Rufen Sie sie erneut ab, oder prüfen Sie das Protokoll des PACS.</translation>
    </message>
    <message>
        <source>the PACS does not offer C-GET, and C-MOVE requires a local port. Set the C-MOVE port, and have the AE title, host and port of this computer registered at the PACS.</source>
        <comment>archive.no-way-back</comment>
        <translation>das PACS bietet C-GET nicht an, und C-MOVE braucht einen lokalen Port. Setzen Sie den C-MOVE-Port, und lassen Sie AE-Titel, Host und Port im PACS eintragen.</translation>
    </message>
    <message>
        <source>cannot listen on port %1 (%2). Choose another port above 1024.</source>
        <comment>archive.port-taken</comment>
        <translation>an Port %1 lässt sich nicht lauschen (%2). Wählen Sie einen anderen Port über 1024.</translation>
    </message>
    <message>
        <source>an object exceeds the limit of %1 and was discarded. Raise the limit (--max-object) if you need this object.</source>
        <comment>archive.object-too-large</comment>
        <translation>ein Objekt überschreitet die Grenze von %1 und wurde verworfen. Erhöhen Sie bei Bedarf die Grenze (--max-object).</translation>
    </message>
    <message>
        <source>a received object is not readable DICOM and was discarded. Check the PACS log.</source>
        <comment>archive.object-unreadable</comment>
        <translation>ein empfangenes Objekt ist kein lesbares DICOM und wurde verworfen. Prüfen Sie das Protokoll des PACS.</translation>
    </message>
    <message>
        <source>a received object does not match the announced one (%1) and was discarded. Check the PACS log.</source>
        <comment>archive.object-foreign</comment>
        <translation>ein empfangenes Objekt ist nicht das angekündigte (%1) und wurde verworfen. Prüfen Sie das Protokoll des PACS.</translation>
    </message>
    <message>
        <source>a received object has the same UID (%1) as a different local object; the local one is kept. Determine which one is correct.</source>
        <comment>archive.object-differs</comment>
        <translation>ein empfangenes Objekt hat die UID (%1) eines anderen lokalen Objekts; das lokale bleibt erhalten. Klären Sie, welches richtig ist.</translation>
    </message>
    <message>
        <source>the series does not fit into the cache (limit %1). Raise the limit, or empty the cache.</source>
        <comment>archive.cache-too-small</comment>
        <translation>die Serie passt nicht in den Zwischenspeicher von %1. Erhöhen Sie seine Grenze, oder leeren Sie ihn.</translation>
    </message>
    <message>
        <source>the folder cannot be created or used (%1). Choose another folder, or free disk space.</source>
        <comment>archive.no-folder</comment>
        <translation>der Ordner lässt sich nicht anlegen oder benutzen (%1). Wählen Sie einen anderen, oder schaffen Sie Speicherplatz.</translation>
    </message>
    <message>
        <source>this is not a complete DICOM file with a specified transfer syntax, so it was not sent. Export it again, or choose another file.</source>
        <comment>archive.not-sendable</comment>
        <translation>dies ist keine vollständige DICOM-Datei mit Transfersyntax und wurde nicht gesendet. Schreiben Sie sie neu, oder wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>the PACS does not accept this SOP class in the stored transfer syntax (class %1, transfer syntax %2). Convert the object, or ask the PACS administrator.</source>
        <comment>archive.not-taken</comment>
        <translation>das PACS nimmt diese SOP-Klasse in der gespeicherten Transfersyntax nicht an (Klasse %1, Transfersyntax %2). Wandeln Sie das Objekt um, oder fragen Sie den PACS-Administrator.</translation>
    </message>
    <message>
        <source>the PACS rejected the object with %1. Check the PACS log, or ask the PACS administrator.</source>
        <comment>archive.store-refused</comment>
        <translation>das PACS lehnte das Objekt mit %1 ab. Prüfen Sie sein Protokoll, oder fragen Sie den Administrator.</translation>
    </message>
    <message>
        <source>%1 returned HTTP status %2. Check the DICOMweb address, or ask the PACS administrator.</source>
        <comment>archive.http-status</comment>
        <translation>%1 lieferte den HTTP-Status %2. Prüfen Sie die DICOMweb-Adresse, oder fragen Sie den PACS-Administrator.</translation>
    </message>
    <message>
        <source>access was denied (HTTP status %1). Check the client certificate or the authorization file of this PACS.</source>
        <comment>archive.http-forbidden</comment>
        <translation>der Zugriff wurde verweigert (HTTP-Status %1). Prüfen Sie das Client-Zertifikat oder die Berechtigungsdatei dieses PACS.</translation>
    </message>
    <message>
        <source>the response is larger than %1. Narrow the query.</source>
        <comment>archive.http-too-large</comment>
        <translation>die Antwort ist größer als %1. Schränken Sie die Suche ein.</translation>
    </message>
    <message>
        <source>%1 (AE title %2) was rejected: it is not in the list of allowed calling AE titles.</source>
        <comment>archive.title-turned-away</comment>
        <translation>%1 (AE-Titel %2) wurde abgelehnt: nicht in der Liste der zugelassenen rufenden AE-Titel.</translation>
    </message>
    <message>
        <source>%1 (AE title %2) was rejected: its called AE title %3 is not ours. Correct the title at the sender.</source>
        <comment>archive.called-otherwise</comment>
        <translation>%1 (AE-Titel %2) wurde abgelehnt: Der gerufene AE-Titel %3 ist nicht unserer. Berichtigen Sie ihn beim Sender.</translation>
    </message>
    <message>
        <source>an incoming connection failed (%1). Check the address, port and TLS settings at the sender.</source>
        <comment>archive.call-failed</comment>
        <translation>eine eingehende Verbindung schlug fehl (%1). Prüfen Sie beim Sender: Adresse, Port, TLS.</translation>
    </message>
    <message>
        <source>an incoming connection was rejected: the TLS handshake failed (%1). Check the sender&apos;s certificate and the certificates accepted here, and check whether the sender uses TLS.</source>
        <comment>archive.call-not-secured</comment>
        <translation>eine eingehende Verbindung wurde abgelehnt: Der TLS-Handshake schlug fehl (%1). Prüfen Sie das Zertifikat des Senders, die hier akzeptierten Zertifikate, und ob der Sender TLS verwendet.</translation>
    </message>
    <message>
        <source>TLS on a listening port requires a local certificate and its private key. Specify both files.</source>
        <comment>archive.port-unsecured</comment>
        <translation>TLS an einem lauschenden Port braucht ein lokales Zertifikat und dessen privaten Schlüssel. Geben Sie beide Dateien an.</translation>
    </message>
    <message>
        <source>%1 does not exist. Check the name, and check whether the drive is mounted.</source>
        <comment>open.missing</comment>
        <translation>%1 gibt es nicht. Prüfen Sie den Namen, und ob das Laufwerk eingehängt ist.</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2. Check its permissions.</source>
        <comment>open.unreadable</comment>
        <translation>%1 lässt sich nicht lesen: %2. Prüfen Sie die Rechte.</translation>
    </message>
    <message>
        <source>%1 is empty. Copy the file again from its source.</source>
        <comment>open.empty</comment>
        <translation>%1 ist leer. Kopieren Sie die Datei erneut von der Quelle.</translation>
    </message>
    <message>
        <source>Unsupported file type: %1. Open a case (.angiopose), a centerline (VTP, VTK, CSV, SWC), a CT scan (DICOM folder, NIfTI, NRRD, MetaImage), a surface (STL, PLY, OBJ) or an angiogram (DICOM, PNG, TIFF).</source>
        <comment>open.unknown</comment>
        <translation>Nicht unterstützter Dateityp: %1. Öffnen Sie einen Fall (.angiopose), eine Mittellinie (VTP, VTK, CSV, SWC), ein CT (DICOM-Ordner, NIfTI, NRRD, MetaImage), eine Oberfläche (STL, PLY, OBJ) oder ein Angiogramm (DICOM, PNG, TIFF).</translation>
    </message>
    <message>
        <source>%1 is a case. Open it on its own, without other files.</source>
        <comment>open.case-alone</comment>
        <translation>%1 ist ein Fall. Öffnen Sie ihn allein, ohne andere Dateien.</translation>
    </message>
    <message>
        <source>%1 is a second vessel tree. Open one vessel tree at a time.</source>
        <comment>open.second-tree</comment>
        <translation>%1 ist ein zweiter Gefäßbaum. Öffnen Sie nur einen auf einmal.</translation>
    </message>
    <message>
        <source>%1 is a second 2-D centerline. Open one 2-D centerline at a time.</source>
        <comment>open.second-centreline</comment>
        <translation>%1 ist eine zweite 2-D-Mittellinie. Öffnen Sie nur eine auf einmal.</translation>
    </message>
    <message>
        <source>%1 is a second angiogram. Open one angiogram at a time; add others as views.</source>
        <comment>open.second-angiogram</comment>
        <translation>%1 ist ein zweites Angiogramm. Öffnen Sie nur eines auf einmal; weitere fügen Sie als Ansichten hinzu.</translation>
    </message>
    <message>
        <source>%1 is no longer at its saved path; it was found at %2. Save the case to keep the new path.</source>
        <comment>open.moved</comment>
        <translation>%1 wurde verschoben und unter %2 gefunden. Speichern Sie den Fall, um den neuen Pfad zu behalten.</translation>
    </message>
    <message>
        <source>this is not an angiogram. Choose an XA image, or a case that contains one.</source>
        <comment>open.no-angiogram</comment>
        <translation>dies ist kein Angiogramm. Wählen Sie eine XA-Aufnahme, oder einen Fall mit einer.</translation>
    </message>
    <message>
        <source>none of the %1 series can be opened. %2</source>
        <comment>open.no-series</comment>
        <translation>keine der %1 Serien lässt sich öffnen. %2</translation>
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
        <source>before: initial pose</source>
        <comment>picture.before</comment>
        <translation>vorher: in der Startlage</translation>
    </message>
    <message>
        <source>after: this pose</source>
        <comment>picture.after</comment>
        <translation>nachher: diese Lage</translation>
    </message>
    <message>
        <source>%1 · median %2</source>
        <comment>picture.pose</comment>
        <translation>%1 · Median %2</translation>
    </message>
    <message>
        <source>%1 · median %2 · not reliable</source>
        <comment>picture.pose-not-trustworthy</comment>
        <translation>%1 · Median %2 · nicht verlässlich</translation>
    </message>
    <message>
        <source>displacement (mm)</source>
        <comment>picture.motion-scale</comment>
        <translation>Verschiebung (mm)</translation>
    </message>
    <message>
        <source>deformation from frame %1, not from this frame</source>
        <comment>picture.bent-on-frame</comment>
        <translation>Verformung von Bild %1, nicht von diesem</translation>
    </message>
    <message>
        <source>deformation in depth: unknown</source>
        <comment>picture.bent-depth-untold</comment>
        <translation>Verformung in der Tiefe: unbekannt</translation>
    </message>
    <message>
        <source>rigid: %1</source>
        <comment>picture.of-rigid-vessels</comment>
        <translation>starr: %1</translation>
    </message>
    <message>
        <source>vessels shown without deformation; deformation available</source>
        <comment>picture.vessels-rigid</comment>
        <translation>Gefäße ohne Verformung gezeigt; Verformung verfügbar</translation>
    </message>
    <message>
        <source>vessels deformed by up to %1 (uncertain)</source>
        <comment>picture.vessels-bent-unsure</comment>
        <translation>Gefäße um bis zu %1 verformt, unsicher</translation>
    </message>
    <message>
        <source>vessels deformed by up to %1</source>
        <comment>picture.vessels-bent</comment>
        <translation>Gefäße um bis zu %1 verformt</translation>
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
        <source>%1 at the detector (%2)</source>
        <comment>picture.scale-at-detector</comment>
        <translation>%1 am Detektor (%2)</translation>
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
        <source>entered</source>
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
        <source>The %1 of the simulation must be between %2 and %3, not %4.</source>
        <comment>simulation.out-of-range</comment>
        <translation>%1 der Simulation muss zwischen %2 und %3 liegen, nicht %4.</translation>
    </message>
    <message>
        <source>Method &apos;%1&apos; has no option with the value &apos;%2&apos;. Specify it as option=value.</source>
        <comment>contest.no-such-choice</comment>
        <translation>Die Methode „%1“ hat keine Option mit dem Wert „%2“. Verwenden Sie option=wert.</translation>
    </message>
    <message>
        <source>Method &apos;%1&apos; has several options with the value &apos;%2&apos;. Specify it as option=value.</source>
        <comment>contest.choice-of-several</comment>
        <translation>Die Methode „%1“ hat mehrere Optionen mit dem Wert „%2“. Verwenden Sie option=wert.</translation>
    </message>
    <message>
        <source>No method specified. For a list of methods, run: angiopose-cli evaluate --help</source>
        <comment>contest.no-method-named</comment>
        <translation>Es ist keine Methode angegeben. Eine Liste der Methoden gibt: angiopose-cli evaluate --help</translation>
    </message>
    <message>
        <source>The experiment &apos;%1&apos; has no condition &apos;%2&apos;. For a list of conditions, run: angiopose-cli evaluate --help</source>
        <comment>experiment.no-such-condition</comment>
        <translation>Das Experiment „%1“ hat keine Bedingung „%2“. Eine Liste der Bedingungen gibt: angiopose-cli evaluate --help</translation>
    </message>
    <message>
        <source>The condition &apos;%1&apos; does not belong to &apos;%2&apos;. Merge only results of this program version.</source>
        <comment>merge.foreign-condition</comment>
        <translation>Die Bedingung „%1“ gehört nicht zu „%2“. Führen Sie nur Ergebnisse dieser Programmversion zusammen.</translation>
    </message>
    <message>
        <source>Two parts contain different results of method %1 in trial %2 of &apos;%3&apos;. Merge only results of the same program version and settings.</source>
        <comment>merge.parts-disagree</comment>
        <translation>Zwei Teile enthalten verschiedene Ergebnisse der Methode %1 im Versuch %2 von „%3“. Führen Sie nur Ergebnisse derselben Programmversion und Einstellungen zusammen.</translation>
    </message>
    <message>
        <source>There are no results to merge.</source>
        <comment>merge.nothing</comment>
        <translation>Es gibt keine Ergebnisse zusammenzuführen.</translation>
    </message>
    <message>
        <source>The results of &apos;%1&apos; (seed %2) and &apos;%3&apos; (seed %4) do not belong together. Merge only parts of the same experiment.</source>
        <comment>merge.runs-of-others</comment>
        <translation>Die Ergebnisse von „%1“ (Startwert %2) und „%3“ (Startwert %4) gehören nicht zusammen. Führen Sie nur Teile desselben Experiments zusammen.</translation>
    </message>
    <message>
        <source>The focal lengths fx and fy must be finite and nonzero.</source>
        <comment>camera.focal-lengths</comment>
        <translation>Die Brennweiten fx und fy müssen endlich und ungleich null sein.</translation>
    </message>
    <message>
        <source>The principal point (cx, cy) must be finite.</source>
        <comment>camera.principal-point</comment>
        <translation>Der Hauptpunkt cx, cy muss endlich sein.</translation>
    </message>
    <message>
        <source>The image size of the camera is invalid: width and height must be positive.</source>
        <comment>camera.image-size</comment>
        <translation>Die Bildgröße der Kamera ist ungültig: Breite und Höhe müssen positiv sein.</translation>
    </message>
    <message>
        <source>The camera belongs to images of %1 × %2 pixels, but the angiogram is %3 × %4 pixels. Use the camera that belongs to this angiogram.</source>
        <comment>camera.other-image</comment>
        <translation>Die Kamera gilt für Bilder mit %1 × %2 Pixeln, das Angiogramm hat aber %3 × %4 Pixel. Verwenden Sie die zum Angiogramm gehörende Kamera.</translation>
    </message>
    <message>
        <source>Image width and height must each be between 1 and %1 px. Choose another size.</source>
        <comment>picture.size</comment>
        <translation>Breite und Höhe des Bildes müssen zwischen 1 und %1 px liegen. Wählen Sie eine andere Größe.</translation>
    </message>
    <message>
        <source>%1 is missing or not positive. Enter it in the C-arm geometry; the image header does not contain it.</source>
        <comment>geometry.value-missing</comment>
        <translation>%1 fehlt oder ist nicht positiv. Tragen Sie den Wert in der C-Bogen-Geometrie ein (der Bildheader enthält ihn nicht).</translation>
    </message>
    <message>
        <source>The source-to-detector distance (SID)</source>
        <comment>geometry.the-sid</comment>
        <translation>Der Abstand Fokus–Detektor (SID)</translation>
    </message>
    <message>
        <source>The source-to-isocenter distance (SOD)</source>
        <comment>geometry.the-sod</comment>
        <translation>Der Abstand Fokus–Isozentrum (SOD)</translation>
    </message>
    <message>
        <source>The detector pixel spacing</source>
        <comment>geometry.the-spacing</comment>
        <translation>Die Pixelgröße des Detektors</translation>
    </message>
    <message>
        <source>The gantry angles (LAO/RAO, CRA/CAU) are missing or invalid. Enter them in the C-arm geometry.</source>
        <comment>geometry.angles-missing</comment>
        <translation>Die Angulationswinkel (LAO/RAO, CRA/CAU) fehlen oder sind ungültig. Tragen Sie sie in der C-Bogen-Geometrie ein.</translation>
    </message>
    <message>
        <source>A coordinate of the isocenter is not a finite number. Enter the position of the isocenter in patient coordinates (mm).</source>
        <comment>geometry.isocentre-not-finite</comment>
        <translation>Eine Koordinate des Isozentrums ist keine endliche Zahl. Geben Sie die Position des Isozentrums in Patientenkoordinaten (mm) ein.</translation>
    </message>
    <message>
        <source>Enter the source-to-detector distance (SID), typically 900 to 1200 mm.</source>
        <comment>geometry.ask-sid</comment>
        <translation>Abstand Fokus–Detektor (SID) eingeben, typisch 900 bis 1200 mm.</translation>
    </message>
    <message>
        <source>Enter the source-to-isocenter distance (SOD), typically 700 to 800 mm.</source>
        <comment>geometry.ask-sod</comment>
        <translation>Abstand Fokus–Isozentrum (SOD) eingeben, typisch 700 bis 800 mm.</translation>
    </message>
    <message>
        <source>Enter the detector pixel spacing, or the width of the field of view at the detector divided by the number of columns.</source>
        <comment>geometry.ask-spacing</comment>
        <translation>Pixelgröße des Detektors eingeben, oder die Breite des Bildfelds auf dem Detektor geteilt durch die Spaltenzahl.</translation>
    </message>
    <message>
        <source>Enter the LAO/RAO angle, or register from landmarks.</source>
        <comment>geometry.ask-primary-angle</comment>
        <translation>Winkel LAO/RAO eingeben, oder nach Landmarken registrieren.</translation>
    </message>
    <message>
        <source>Enter the CRA/CAU angle, or register from landmarks.</source>
        <comment>geometry.ask-secondary-angle</comment>
        <translation>Winkel CRA/CAU eingeben, oder nach Landmarken registrieren.</translation>
    </message>
    <message>
        <source>A source-to-detector distance (SID) of %1 is implausible for a C-arm (500 to 2000 mm): check the unit.</source>
        <comment>geometry.sid-unusual</comment>
        <translation>Ein Abstand Fokus–Detektor (SID) von %1 ist für einen C-Bogen unplausibel (500 bis 2000 mm): Prüfen Sie die Einheit.</translation>
    </message>
    <message>
        <source>The SOD (%1) is not smaller than the SID (%2): the isocenter would lie behind the detector. Correct one of the two distances.</source>
        <comment>geometry.sod-beyond-sid</comment>
        <translation>SOD (%1) ist nicht kleiner als SID (%2): Das Isozentrum läge hinter dem Detektor. Berichtigen Sie einen der Werte.</translation>
    </message>
    <message>
        <source>The SID is %1 times the SOD, but the typical angiographic magnification is 1.0 to 2.5. Check both distances.</source>
        <comment>geometry.magnification-unusual</comment>
        <translation>SID ist das %1-fache von SOD; Angiogramme sind typischerweise 1,0- bis 2,5-fach vergrößert. Prüfen Sie beide Abstände.</translation>
    </message>
    <message>
        <source>The magnification in the header (0018,1114) is %1, which does not match SID/SOD = %2: one of the three values is outdated. Check the SID and the SOD.</source>
        <comment>geometry.magnification-stale</comment>
        <translation>Die Vergrößerung im Header (0018,1114) ist %1 und entspricht nicht SID/SOD = %2: Einer der drei Werte ist veraltet. Prüfen Sie SID und SOD.</translation>
    </message>
    <message>
        <source>The detector pixel spacing of %1 is outside the range of 0.05 to 2 mm: check its unit.</source>
        <comment>geometry.spacing-unusual</comment>
        <translation>Eine Pixelgröße von %1 liegt außerhalb 0,05 bis 2 mm: Prüfen Sie die Einheit.</translation>
    </message>
    <message>
        <source>The ratio of pixel height to width is %1 according to the pixel spacing, but %2 according to the pixel aspect ratio: check the pixel spacing.</source>
        <comment>geometry.aspect-differs</comment>
        <translation>Das Verhältnis von Pixelhöhe zu -breite ist nach der Pixelgröße %1, nach dem Pixelseitenverhältnis %2: Prüfen Sie die Pixelgröße.</translation>
    </message>
    <message>
        <source>According to its pixel spacing, the image covers %1 × %2 of the detector</source>
        <comment>geometry.image-covers</comment>
        <translation>Nach der Pixelgröße bedeckt das Bild %1 × %2 des Detektors</translation>
    </message>
    <message>
        <source>%1: no C-arm detector has this size. Check the pixel spacing.</source>
        <comment>geometry.extent-unlike-detector</comment>
        <translation>%1: Kein C-Bogen-Detektor hat diese Größe. Prüfen Sie die Pixelgröße.</translation>
    </message>
    <message>
        <source>%1, but the field of view is %2 × %3: the image may have been zoomed, cropped or resampled. Check the pixel spacing.</source>
        <comment>geometry.extent-unlike-field</comment>
        <translation>%1, das Bildfeld ist aber %2 × %3: Das Bild ist vielleicht gezoomt, beschnitten oder neu abgetastet. Prüfen Sie die Pixelgröße.</translation>
    </message>
    <message>
        <source>%1, which exceeds the diameter of the image intensifier (%2). Check the pixel spacing.</source>
        <comment>geometry.extent-beyond-intensifier</comment>
        <translation>%1, mehr als der Bildverstärker von %2. Prüfen Sie die Pixelgröße.</translation>
    </message>
    <message>
        <source>%1, which exceeds the active area of the detector (%2 × %3). Check the pixel spacing.</source>
        <comment>geometry.extent-beyond-detector</comment>
        <translation>%1, mehr als seine aktive Fläche von %2 × %3. Prüfen Sie die Pixelgröße.</translation>
    </message>
    <message>
        <source>The calibrated pixel spacing (%1) multiplied by SID/SOD is %2, but the detector pixel spacing is %3: the calibration or one of the distances is wrong.</source>
        <comment>geometry.calibration-off</comment>
        <translation>Die kalibrierte Pixelgröße von %1 mal SID/SOD ergibt %2, nicht die %3 des Detektors: Kalibrierung oder Abstand stimmt nicht.</translation>
    </message>
    <message>
        <source>The uncalibrated Pixel Spacing (0028,0030) is %1, but the detector pixel spacing is %2: check which one applies.</source>
        <comment>geometry.spacings-differ</comment>
        <translation>Pixel Spacing (0028,0030) ist ohne Kalibrierung %1, die Pixelgröße des Detektors aber %2: Prüfen Sie, welche gilt.</translation>
    </message>
    <message>
        <source>The primary angle (LAO/RAO) is outside ±180°. Correct it.</source>
        <comment>geometry.primary-angle-outside</comment>
        <translation>Der Primärwinkel (LAO/RAO) liegt außerhalb ±180°. Berichtigen Sie ihn.</translation>
    </message>
    <message>
        <source>The secondary angle (CRA/CAU) is outside ±90°. Correct it.</source>
        <comment>geometry.secondary-angle-outside</comment>
        <translation>Der Sekundärwinkel (CRA/CAU) liegt außerhalb ±90°. Berichtigen Sie ihn.</translation>
    </message>
    <message>
        <source>The roll is outside ±180°. Correct it.</source>
        <comment>geometry.roll-outside</comment>
        <translation>Das Rollen liegt außerhalb ±180°. Berichtigen Sie es.</translation>
    </message>
    <message>
        <source>The principal point (%1, %2) is outside the image, which is plausible only if the image was cropped.</source>
        <comment>geometry.principal-point-outside</comment>
        <translation>Der Hauptpunkt (%1, %2) liegt außerhalb des Bildes; das ist nur bei einem beschnittenen Bild richtig.</translation>
    </message>
    <message>
        <source>Two of the angiograms appear to belong to different patients (%1 differs). Check that the correct files are open.</source>
        <comment>patient.of-runs-differs</comment>
        <translation>Zwei der Angiogramme scheinen von verschiedenen Patienten zu sein (%1 verschieden). Prüfen Sie, ob die richtigen geöffnet sind.</translation>
    </message>
    <message>
        <source>Two of the angiograms appear to belong to different patients (%1 differ). Check that the correct files are open.</source>
        <comment>patient.of-runs-differs-in-several</comment>
        <translation>Zwei der Angiogramme scheinen von verschiedenen Patienten zu sein (%1 verschieden). Prüfen Sie, ob die richtigen geöffnet sind.</translation>
    </message>
    <message>
        <source>Two of the angiograms show opposite sides of the patient. Check that the correct files are open.</source>
        <comment>patient.side-of-runs-differs</comment>
        <translation>Zwei der Angiogramme zeigen entgegengesetzte Seiten des Patienten. Prüfen Sie, ob die richtigen geöffnet sind.</translation>
    </message>
    <message>
        <source>The registration rated this pose as unreliable.</source>
        <comment>pose.run-distrusted</comment>
        <translation>Die Registrierung stufte diese Lage als nicht verlässlich ein.</translation>
    </message>
    <message>
        <source>Images may be from different patients</source>
        <comment>picture.not-same-patient</comment>
        <translation>Bilder möglicherweise von verschiedenen Patienten</translation>
    </message>
    <message>
        <source>Two of the angiograms are from different examinations (different accession numbers): the vessels may have moved between them.</source>
        <comment>patient.examination-of-runs-differs</comment>
        <translation>Zwei der Angiogramme stammen aus verschiedenen Untersuchungen (Anforderungsnummer verschieden): Die Gefäße können sich dazwischen bewegt haben.</translation>
    </message>
    <message>
        <source>Images may not belong together</source>
        <comment>picture.not-together</comment>
        <translation>Bilder gehören möglicherweise nicht zusammen</translation>
    </message>
    <message>
        <source>The scan and the angiogram appear to belong to different patients (%1 differs). Check that the correct files are open.</source>
        <comment>patient.differs</comment>
        <translation>Scan und Angiogramm scheinen von verschiedenen Patienten zu sein (%1 verschieden). Prüfen Sie, ob beide richtig sind.</translation>
    </message>
    <message>
        <source>The scan and the angiogram appear to belong to different patients (%1 differ). Check that the correct files are open.</source>
        <comment>patient.differs-in-several</comment>
        <translation>Scan und Angiogramm scheinen von verschiedenen Patienten zu sein (%1 verschieden). Prüfen Sie, ob beide richtig sind.</translation>
    </message>
    <message>
        <source>patient ID</source>
        <comment>patient.number</comment>
        <translation>Patienten-ID</translation>
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
        <source>The scan shows the patient&apos;s %1 side, but the angiogram shows the other side. Check that the correct files are open.</source>
        <comment>patient.side-differs</comment>
        <translation>Der Scan zeigt die Seite %1 des Patienten, das Angiogramm die andere. Prüfen Sie, ob beide richtig sind.</translation>
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
        <source>There is no angiogram yet. Open an image first.</source>
        <comment>case.no-angiogram</comment>
        <translation>Noch kein Angiogramm. Öffnen Sie zuerst ein Bild.</translation>
    </message>
    <message>
        <source>There is no vessel tree yet. Open a centerline first.</source>
        <comment>case.no-vessel-tree</comment>
        <translation>Noch kein Gefäßbaum. Öffnen Sie zuerst eine Mittellinie.</translation>
    </message>
    <message>
        <source>All six degrees of freedom are locked: there is nothing to optimize. Unlock at least one.</source>
        <comment>options.all-locked</comment>
        <translation>Alle sechs Freiheitsgrade sind gesperrt: Es gibt nichts zu optimieren. Entsperren Sie mindestens einen.</translation>
    </message>
    <message>
        <source>%1 solves for all six degrees of freedom at once and cannot lock any. Unlock them, or choose another method.</source>
        <comment>options.method-cannot-lock</comment>
        <translation>%1 löst alle sechs Freiheitsgrade zugleich und kann keinen sperren. Entsperren Sie sie, oder wählen Sie eine andere Methode.</translation>
    </message>
    <message>
        <source>There is no method &apos;%1&apos;. Choose one of: %2.</source>
        <comment>options.no-such-method</comment>
        <translation>Es gibt keine Methode „%1“. Wählen Sie eine von: %2.</translation>
    </message>
    <message>
        <source>Option %1 is out of range. Enter a number from %2 to %3.</source>
        <comment>options.out-of-range</comment>
        <translation>Die Option %1 liegt außerhalb des Bereichs. Geben Sie eine Zahl von %2 bis %3 ein.</translation>
    </message>
    <message>
        <source>Option &apos;%1&apos; requires a value, not &apos;%2&apos;.</source>
        <comment>options.needs-value</comment>
        <translation>Die Option „%1“ braucht einen Wert, nicht „%2“.</translation>
    </message>
    <message>
        <source>Option &apos;%1&apos; must be one of %2, not &apos;%3&apos;.</source>
        <comment>options.needs-choice</comment>
        <translation>Die Option „%1“ muss einen der Werte %2 haben, nicht „%3“.</translation>
    </message>
    <message>
        <source>Option &apos;%1&apos; must be an integer, not %2.</source>
        <comment>options.needs-whole-number</comment>
        <translation>Die Option „%1“ muss eine ganze Zahl sein, nicht %2.</translation>
    </message>
    <message>
        <source>Option &apos;%1&apos; must be between %2 and %3, not %4.</source>
        <comment>options.value-out-of-range</comment>
        <translation>Die Option „%1“ muss zwischen %2 und %3 liegen, nicht %4.</translation>
    </message>
    <message>
        <source>Unknown option &apos;%1&apos;. For a list of options, run: angiopose-cli register --help</source>
        <comment>options.no-such-option</comment>
        <translation>Unbekannte Option „%1“. Eine Liste der Optionen gibt: angiopose-cli register --help</translation>
    </message>
    <message>
        <source>Branch %1 is selected as %2, but does not exist in the vessel tree. Select an existing branch.</source>
        <comment>input.chosen-branch-missing</comment>
        <translation>Ast %1 ist als %2 ausgewählt, der Gefäßbaum hat ihn aber nicht. Wählen Sie einen vorhandenen Ast.</translation>
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
        <translation>Alle Äste des Gefäßbaums sind ausgeschlossen. Schließen Sie mindestens einen ein.</translation>
    </message>
    <message>
        <source>The image size does not match the camera. Use the camera that belongs to this image.</source>
        <comment>input.image-not-of-camera</comment>
        <translation>Die Bildgröße passt nicht zur Kamera. Verwenden Sie die zum Bild gehörende Kamera.</translation>
    </message>
    <message>
        <source>Unordered points of the traced vessels were connected to their neighbors (number of points: %1).</source>
        <comment>input.target-reordered</comment>
        <translation>%1 Punkte der erkannten Gefäße waren ungeordnet: Jeder wurde mit seinen Nachbarn verbunden.</translation>
    </message>
    <message>
        <source>Auxiliary branches: median distance to the traced vessels %1 (%2 in the fit of all branches). The pose changed by %3 and %4.</source>
        <comment>result.chosen-branches-fitted</comment>
        <translation>Hilfsäste: medianer Abstand zu den erkannten Gefäßen %1 (%2 bei Anpassung aller Äste). Die Lage änderte sich um %3 und %4.</translation>
    </message>
    <message>
        <source>With deformation allowed, the vessels move toward the matched branches by %1 (RMS; maximum %2), which changes the median distance from %4 (rigid pose) to %3. The rigid pose is reported.</source>
        <comment>result.matched-branches-moved</comment>
        <translation>Mit Verformung bewegen sich die Gefäße um %1 (RMS; maximal %2) auf die zugeordneten Äste zu: Der mediane Abstand wird %3 statt %4 in der starren Lage. Angegeben ist die starre Lage.</translation>
    </message>
    <message>
        <source>The initial pose is not a rigid transform: its rotation must be orthonormal with determinant +1, and all values must be finite. Correct cameraFromPatient, or derive the initial pose from the angles.</source>
        <comment>input.start-pose-not-rigid</comment>
        <translation>Die Startlage ist keine starre Transformation: Die Drehung muss orthonormal mit Determinante +1 sein, alle Werte endlich. Berichtigen Sie cameraFromPatient, oder leiten Sie die Startlage aus den Winkeln ab.</translation>
    </message>
    <message>
        <source>The initial pose places vessels at or behind the X-ray source, where they cannot be projected. Check the source-to-isocenter distance and the direction of the initial pose.</source>
        <comment>input.start-pose-behind-source</comment>
        <translation>Die Startlage setzt Gefäße an oder hinter den Röntgenfokus, wo keine Projektion möglich ist. Prüfen Sie den Abstand Fokus–Isozentrum und die Richtung der Startlage.</translation>
    </message>
    <message>
        <source>The pose to evaluate is not a rigid transform: its rotation must be orthonormal with determinant +1, and all values must be finite.</source>
        <comment>input.judged-pose-not-rigid</comment>
        <translation>Die zu beurteilende Lage ist keine starre Transformation: Die Drehung muss orthonormal mit Determinante +1 sein, alle Werte endlich.</translation>
    </message>
    <message>
        <source>There are no landmarks yet. Click a point on the vessels and the same point in the image.</source>
        <comment>landmarks.missing</comment>
        <translation>Noch keine Landmarken. Klicken Sie eine Stelle an den Gefäßen und dieselbe im Bild an.</translation>
    </message>
    <message>
        <source>Without gantry angles, four landmarks are required to determine a pose; there are %1. Add landmarks, or enter the angles; one landmark is then enough.</source>
        <comment>landmarks.too-few</comment>
        <translation>Ohne C-Bogen-Winkel braucht eine Lage vier Landmarken; es sind %1. Fügen Sie Landmarken hinzu, oder tragen Sie die Winkel ein: dann genügt eine.</translation>
    </message>
    <message>
        <source>A landmark has a coordinate that is not a finite number. Remove it.</source>
        <comment>landmarks.not-finite</comment>
        <translation>Eine Landmarke hat eine Koordinate, die keine endliche Zahl ist. Entfernen Sie sie.</translation>
    </message>
    <message>
        <source>All landmarks are at the same position. Place them farther apart.</source>
        <comment>landmarks.in-one-place</comment>
        <translation>Die Landmarken liegen alle an derselben Stelle. Wählen Sie weiter auseinander liegende.</translation>
    </message>
    <message>
        <source>The landmarks are collinear, so the rotation about their line is undetermined. Add a landmark off that line.</source>
        <comment>landmarks.on-one-line</comment>
        <translation>Die Landmarken liegen auf einer Geraden; die Drehung um sie ist daher unbestimmt. Fügen Sie eine daneben hinzu.</translation>
    </message>
    <message>
        <source>No pose projects these landmarks onto their pixels. Check that the two points of each pair mark the same anatomical location.</source>
        <comment>landmarks.no-pose</comment>
        <translation>Keine Lage projiziert diese Landmarken auf ihre Pixel. Prüfen Sie, ob jedes Paar dieselbe Stelle markiert.</translation>
    </message>
    <message>
        <source>View %1: %2</source>
        <comment>views.in-view</comment>
        <translation>Ansicht %1: %2</translation>
    </message>
    <message>
        <source>A joint registration requires at least two views.</source>
        <comment>views.too-few</comment>
        <translation>Eine gemeinsame Registrierung braucht mindestens zwei Ansichten.</translation>
    </message>
    <message>
        <source>A joint registration cannot lock individual degrees of freedom. Unlock them first.</source>
        <comment>views.cannot-lock</comment>
        <translation>Eine gemeinsame Registrierung kann einzelne Freiheitsgrade nicht sperren. Entsperren Sie sie zuerst.</translation>
    </message>
    <message>
        <source>View %1 uses a different vessel tree or different branches than view %2. Use the same tree and branches in all views.</source>
        <comment>views.other-tree</comment>
        <translation>Ansicht %1 verwendet einen anderen Gefäßbaum oder andere Äste als Ansicht %2. Verwenden Sie in allen Ansichten dieselben.</translation>
    </message>
    <message>
        <source>View %1 is inconsistent with the joint pose.</source>
        <comment>views.disagrees</comment>
        <translation>Ansicht %1 ist mit der gemeinsamen Lage nicht vereinbar.</translation>
    </message>
    <message>
        <source>The geometry of view %1 differs substantially from the values in its header. Check the angles and distances.</source>
        <comment>views.far-from-header</comment>
        <translation>Die Geometrie der Ansicht %1 weicht stark von ihrem Header ab. Prüfen Sie Winkel und Abstände.</translation>
    </message>
    <message>
        <source>There is only one frame, so there is nothing to track. Open a run with several frames.</source>
        <comment>follow.one-frame</comment>
        <translation>Nur ein Bild: nichts zu verfolgen. Öffnen Sie eine Serie mit mehreren Bildern.</translation>
    </message>
    <message>
        <source>The centerline of this frame comes from a file, and the other frames have none. Remove this centerline from the case so that every frame is traced.</source>
        <comment>follow.given-target</comment>
        <translation>Die Mittellinie dieses Bildes stammt aus einer Datei; andere Bilder haben keine. Entfernen Sie diese Mittellinie aus dem Fall, um jedes Bild zu erfassen.</translation>
    </message>
    <message>
        <source>The gantry rotates during this run: the frames differ not only by vessel motion but also in the projection angles. Register the frames individually, or jointly as views.</source>
        <comment>follow.gantry-turns</comment>
        <translation>Der C-Bogen dreht sich während der Serie: Die Bilder unterscheiden sich im Blickwinkel, nicht nur durch Bewegung. Registrieren Sie die Bilder einzeln, oder gemeinsam als Ansichten.</translation>
    </message>
    <message>
        <source>Only %1 of the vessel tree is inside the image.</source>
        <comment>trust.outside-image</comment>
        <translation>Nur %1 des Gefäßbaums liegen im Bild.</translation>
    </message>
    <message>
        <source>Only %1 of the vessel tree matches a traced vessel, and the tree accounts for %2 of the traced vessels.</source>
        <comment>trust.little-agreement</comment>
        <translation>Nur %1 des Gefäßbaums passen zu einem erkannten Gefäß, und er erklärt %2 der erkannten Gefäße.</translation>
    </message>
    <message>
        <source>The vessel tree accounts for only %1 of the traced vessels. Check that it belongs to the image and that its unit is mm.</source>
        <comment>trust.little-explained</comment>
        <translation>Der Gefäßbaum erklärt nur %1 der erkannten Gefäße. Prüfen Sie, ob er zum Bild gehört und seine Einheit mm ist.</translation>
    </message>
    <message>
        <source>A better fit exists %1 away.</source>
        <comment>trust.better-aside</comment>
        <translation>Eine bessere Übereinstimmung liegt %1 entfernt.</translation>
    </message>
    <message>
        <source>The out-of-plane tilt of the vessels is poorly determined by the image.</source>
        <comment>trust.out-of-plane-uncertain</comment>
        <translation>Die Kippung der Gefäße aus der Bildebene ist durch das Bild kaum bestimmt.</translation>
    </message>
    <message>
        <source>The in-plane rotation of the vessels is poorly determined by the image.</source>
        <comment>trust.in-plane-turn-uncertain</comment>
        <translation>Die Drehung der Gefäße in der Bildebene ist durch das Bild kaum bestimmt.</translation>
    </message>
    <message>
        <source>The position of the tree along the vessels is poorly determined by the image.</source>
        <comment>trust.shift-uncertain</comment>
        <translation>Die Position des Gefäßbaums entlang der Gefäße ist durch das Bild kaum bestimmt.</translation>
    </message>
    <message>
        <source>The pose uncertainty is about %1.</source>
        <comment>trust.pose-uncertain</comment>
        <translation>Die Unsicherheit der Lage beträgt etwa %1.</translation>
    </message>
    <message>
        <source>Another pose fits the image almost as well: compare the other solutions.</source>
        <comment>trust.rival</comment>
        <translation>Eine andere Lage passt fast ebenso gut zum Bild: Vergleichen Sie die anderen Lösungen.</translation>
    </message>
    <message>
        <source>Only %1 of fits of this quality are within 2 mm of the vessels.</source>
        <comment>trust.often-fails</comment>
        <translation>Vergleichbare Anpassungen liegen nur in %1 der Fälle höchstens 2 mm neben den Gefäßen.</translation>
    </message>
    <message>
        <source>The registration was stopped before it finished.</source>
        <comment>trust.stopped</comment>
        <translation>Die Registrierung wurde vorzeitig angehalten.</translation>
    </message>
    <message>
        <source>The image shows %1 of the vessel tree. These branches appear unopacified: %2. The pose is based on the remaining branches.</source>
        <comment>trust.part-filled</comment>
        <translation>Das Bild zeigt %1 des Gefäßbaums. Diese Äste erscheinen nicht kontrastiert: %2. Die Lage beruht auf den übrigen.</translation>
    </message>
    <message>
        <source>The image shows %1 of the vessel tree: %2 of %3 branches appear unopacified. The pose is based on the remaining branches.</source>
        <comment>trust.few-filled</comment>
        <translation>Das Bild zeigt %1 des Gefäßbaums: %2 von %3 Ästen erscheinen nicht kontrastiert. Die Lage beruht auf den übrigen.</translation>
    </message>
    <message>
        <source>The image shows %1 of the vessel tree and less than half of each branch. The pose is based on the visible segments.</source>
        <comment>trust.pieces-filled</comment>
        <translation>Das Bild zeigt %1 des Gefäßbaums und von jedem Ast weniger als die Hälfte. Die Lage beruht auf den sichtbaren Abschnitten.</translation>
    </message>
    <message>
        <source>Only part of the vessel tree appears opacified, and this part accounts for too little of the image for a reliable result.</source>
        <comment>trust.filled-doubtful</comment>
        <translation>Nur ein Teil des Gefäßbaums erscheint kontrastiert, und er erklärt zu wenig vom Bild für ein sicheres Ergebnis.</translation>
    </message>
    <message>
        <source>Only a single vessel path is visible. It fits at many positions, and a guidewire or catheter does not follow the centerline exactly. The guidewire method ranks the possible paths.</source>
        <comment>trust.single-path</comment>
        <translation>Nur ein Gefäßweg ist sichtbar. Er passt an vielen Stellen, und ein Führungsdraht oder Katheter folgt nicht genau der Mittellinie. Die Führungsdraht-Methode stuft die möglichen Wege ein.</translation>
    </message>
    <message>
        <source>Depth cannot be determined from this single view: the distance from the source stays close to that of the initial pose.</source>
        <comment>trust.depth-unknown</comment>
        <translation>Die Tiefe lässt sich aus dieser einen Ansicht nicht bestimmen: Der Abstand vom Fokus bleibt nahe der Startlage.</translation>
    </message>
    <message>
        <source>Depth cannot be determined from this single view: the distance from the source differs by %1 from that of the initial pose and may be wrong. Lock the depth, or add a view.</source>
        <comment>trust.depth-moved</comment>
        <translation>Die Tiefe lässt sich aus dieser einen Ansicht nicht bestimmen: Der Abstand vom Fokus weicht um %1 von der Startlage ab und kann falsch sein. Sperren Sie die Tiefe, oder fügen Sie eine Ansicht hinzu.</translation>
    </message>
    <message>
        <source>The vessels fit clearly better with a focal length that is %1 longer. Check the source-to-detector distance (it may be larger) and the pixel spacing (it may be smaller). The option “Estimate geometry” uses the values that best fit the images.</source>
        <comment>camera.focal-longer</comment>
        <translation>Die Gefäße passen deutlich besser mit einer um %1 längeren Brennweite. Prüfen Sie den Abstand Fokus–Detektor (vielleicht größer) und die Pixelgröße (vielleicht kleiner). Die Option „Geometrie schätzen“ verwendet die Werte, die zu den Bildern passen.</translation>
    </message>
    <message>
        <source>The vessels fit clearly better with a focal length that is %1 shorter. Check the source-to-detector distance (it may be smaller) and the pixel spacing (it may be larger). The option “Estimate geometry” uses the values that best fit the images.</source>
        <comment>camera.focal-shorter</comment>
        <translation>Die Gefäße passen deutlich besser mit einer um %1 kürzeren Brennweite. Prüfen Sie den Abstand Fokus–Detektor (vielleicht kleiner) und die Pixelgröße (vielleicht größer). Die Option „Geometrie schätzen“ verwendet die Werte, die zu den Bildern passen.</translation>
    </message>
    <message>
        <source>The images contradicted the specified geometry, so the geometry was estimated from the images: the focal length is %1 of the specified value, and the principal point is shifted by (%2, %3) px.</source>
        <comment>camera.estimated</comment>
        <translation>Die Bilder widersprachen der Geometrie, die daher aus ihnen geschätzt wurde: Die Brennweite ist %1 der angegebenen, der Hauptpunkt ist um (%2, %3) px verschoben.</translation>
    </message>
    <message>
        <source>The vessels fit clearly better with the principal point shifted by %1, to (%2, %3). Check the principal point, and check whether the image was cropped or shifted.</source>
        <comment>camera.principal-point-off</comment>
        <translation>Die Gefäße passen deutlich besser, wenn der Hauptpunkt um %1 nach (%2, %3) verschoben ist. Prüfen Sie ihn, und ob das Bild beschnitten oder verschoben wurde.</translation>
    </message>
    <message>
        <source>The image appears to be rotated 90° clockwise: when it is rotated back, the agreement between vessels and image is %1 instead of %2. Check the image export, or the roll.</source>
        <comment>frame.turned-clockwise</comment>
        <translation>Das Bild scheint um 90° im Uhrzeigersinn gedreht: Zurückgedreht stimmen Gefäße und Bild zu %1 statt %2 überein. Prüfen Sie den Bildexport, oder die Bilddrehung.</translation>
    </message>
    <message>
        <source>The image appears to be rotated 90° counterclockwise: when it is rotated back, the agreement between vessels and image is %1 instead of %2. Check the image export, or the roll.</source>
        <comment>frame.turned-anticlockwise</comment>
        <translation>Das Bild scheint um 90° gegen den Uhrzeigersinn gedreht: Zurückgedreht stimmen Gefäße und Bild zu %1 statt %2 überein. Prüfen Sie den Bildexport, oder die Bilddrehung.</translation>
    </message>
    <message>
        <source>The image appears to be rotated 180°: when it is rotated back, the agreement between vessels and image is %1 instead of %2. Check the image export, the roll and the patient position.</source>
        <comment>frame.upside-down</comment>
        <translation>Das Bild scheint um 180° gedreht: Zurückgedreht stimmen Gefäße und Bild zu %1 statt %2 überein. Prüfen Sie den Bildexport, die Bilddrehung und die Patientenlagerung.</translation>
    </message>
    <message>
        <source>The image appears to be mirrored left to right: when it is mirrored back, the agreement between vessels and image is %1 instead of %2. Check the viewing side in the geometry.</source>
        <comment>frame.mirrored-left-right</comment>
        <translation>Das Bild scheint links-rechts gespiegelt: Zurückgespiegelt stimmen Gefäße und Bild zu %1 statt %2 überein. Prüfen Sie die Betrachtungsseite in der Geometrie.</translation>
    </message>
    <message>
        <source>The image appears to be mirrored top to bottom: when it is mirrored back, the agreement between vessels and image is %1 instead of %2. Check the image export.</source>
        <comment>frame.mirrored-up-down</comment>
        <translation>Das Bild scheint oben-unten gespiegelt: Zurückgespiegelt stimmen Gefäße und Bild zu %1 statt %2 überein. Prüfen Sie den Bildexport.</translation>
    </message>
    <message>
        <source>The image appears to be mirrored and rotated 90°: when both are undone, the agreement between vessels and image is %1 instead of %2. Check the image export.</source>
        <comment>frame.mirrored-and-turned</comment>
        <translation>Das Bild scheint gespiegelt und um 90° gedreht: Korrigiert stimmen Gefäße und Bild zu %1 statt %2 überein. Prüfen Sie den Bildexport.</translation>
    </message>
    <message>
        <source>The patient position was %1, and the device appears to define its angles relative to the table: with this interpretation, the agreement between vessels and image is %2 instead of %3. Enter these angles in the geometry: LAO/RAO %4, CRA/CAU %5, roll %6.</source>
        <comment>frame.counted-from-table</comment>
        <translation>Die Patientenlagerung war %1, und das Gerät scheint seine Winkel relativ zum Tisch anzugeben: So interpretiert stimmen Gefäße und Bild zu %2 statt %3 überein. Geben Sie in der Geometrie ein: LAO/RAO %4, CRA/CAU %5, Bilddrehung %6.</translation>
    </message>
    <message>
        <source>The mirrored image fits the vessels about equally well (agreement %1; currently %2): check the viewing side in the geometry.</source>
        <comment>frame.mirror-rival</comment>
        <translation>Das gespiegelte Bild passt etwa ebenso gut zu den Gefäßen (Übereinstimmung %1, derzeit %2): Prüfen Sie die Betrachtungsseite des Bildes.</translation>
    </message>
    <message>
        <source>The patient position is %1 (0018,5100), not head-first supine (HFS). The angles are interpreted as the DICOM standard defines them: relative to the patient, with the head up in the image. If this device defines them relative to the table, the initial pose is incorrectly rotated. If a registration fails, AngioPose tests this interpretation and reports the angles to enter.</source>
        <comment>dicom.patient-lies</comment>
        <translation>Die Patientenlagerung ist %1 (0018,5100), nicht Kopf voran in Rückenlage. Die Winkel werden nach dem DICOM-Standard interpretiert: relativ zum Patienten, Kopf im Bild oben. Gibt dieses Gerät sie relativ zum Tisch an, ist die Startlage gedreht; misslingt eine Registrierung, prüft AngioPose dies und nennt die einzugebenden Winkel.</translation>
    </message>
    <message>
        <source>The table moved during this run (%1). The motion is ignored: a pose is valid only for its own frame, and different frames do not show the same table position.</source>
        <comment>dicom.table-moved</comment>
        <translation>Der Tisch bewegte sich während dieser Serie (%1). Die Bewegung bleibt unberücksichtigt: Eine Lage gilt nur für ihr eigenes Bild, und die Bilder sind keine Ansichten derselben Position.</translation>
    </message>
    <message>
        <source>distance not specified in the header</source>
        <comment>dicom.table-moved-unknown</comment>
        <translation>Strecke im Header nicht angegeben</translation>
    </message>
    <message>
        <source>Deformable registration requires at least one registered view.</source>
        <comment>bend.no-view</comment>
        <translation>Deformierbare Registrierung braucht mindestens eine registrierte Ansicht.</translation>
    </message>
    <message>
        <source>The traced vessels consist of isolated points. Connect the points to form curves before deforming the tree.</source>
        <comment>bend.needs-curves</comment>
        <translation>Die erkannten Gefäße sind einzelne Punkte. Verbinden Sie sie zu Kurven, bevor der Baum verformt wird.</translation>
    </message>
    <message>
        <source>The pose priors and the knot spacing must be positive numbers.</source>
        <comment>bend.options-unusable</comment>
        <translation>Die A-priori-Werte der Lage und der Knotenabstand müssen positive Zahlen sein.</translation>
    </message>
    <message>
        <source>The vessels are deformed relative to the tree: the rigid overlay deviates by %1 on average and most at branch %3 (%2).</source>
        <comment>bend.rigid-off</comment>
        <translation>Die Gefäße sind gegenüber dem Baum verformt: Die starre Überlagerung weicht im Mittel um %1 ab, am meisten an Ast %3 (%2).</translation>
    </message>
    <message>
        <source>The vessels may be deformed relative to the tree, but the image is inconclusive: the rigid overlay would deviate by %1 on average and most at branch %3 (%2).</source>
        <comment>bend.may-be-off</comment>
        <translation>Die Gefäße sind möglicherweise gegenüber dem Baum verformt, das Bild ist aber nicht eindeutig: Die starre Überlagerung wiche im Mittel um %1 ab, am meisten an Ast %3 (%2).</translation>
    </message>
    <message>
        <source>Deformable registration was stopped before it finished; the rigid pose is kept.</source>
        <comment>bend.stopped</comment>
        <translation>Die deformierbare Registrierung wurde vorzeitig angehalten: Die starre Lage bleibt erhalten.</translation>
    </message>
    <message>
        <source>Deformable registrations from different initial values differ by %1: some branches may be matched to the wrong vessels.</source>
        <comment>bend.runs-differ</comment>
        <translation>Deformierbare Registrierungen von verschiedenen Startwerten unterscheiden sich um %1: Einige Äste sind vielleicht falschen Gefäßen zugeordnet.</translation>
    </message>
    <message>
        <source>Only %1 of the vessel tree was matched to vessels in the image.</source>
        <comment>bend.little-seen</comment>
        <translation>Nur %1 des Gefäßbaums ließen sich Gefäßen im Bild zuordnen.</translation>
    </message>
    <message>
        <source>The traced vessels are still about %1 away from the deformed tree: the vessel motion is more local than the model can represent.</source>
        <comment>bend.not-followed</comment>
        <translation>Die erkannten Gefäße liegen noch etwa %1 neben dem verformten Baum: Ihre Bewegung ist kleinräumiger, als das Modell abbilden kann.</translation>
    </message>
    <message>
        <source>The %1 vessels (%2 of the total vessel length) are displaced by %3 relative to the rest (direction: %4).</source>
        <comment>bend.part-moved</comment>
        <translation>Die Gefäße %1 (%2 der gesamten Gefäßlänge) sind gegenüber dem Rest um %3 nach %4 verschoben.</translation>
    </message>
    <message>
        <source>Vessel motion in depth cannot be determined from a single view.</source>
        <comment>bend.depth-unknown</comment>
        <translation>Die Bewegung der Gefäße in der Tiefe lässt sich aus einer Ansicht nicht bestimmen.</translation>
    </message>
    <message>
        <source>anterior</source>
        <comment>side.front</comment>
        <translation>anterior</translation>
    </message>
    <message>
        <source>posterior</source>
        <comment>side.back</comment>
        <translation>posterior</translation>
    </message>
    <message>
        <source>superior</source>
        <comment>side.head</comment>
        <translation>kranial</translation>
    </message>
    <message>
        <source>inferior</source>
        <comment>side.feet</comment>
        <translation>kaudal</translation>
    </message>
    <message>
        <source>The angiogram frame is empty. Choose another frame or file.</source>
        <comment>frame.empty</comment>
        <translation>Das Angiogrammbild ist leer. Wählen Sie ein anderes Bild oder eine andere Datei.</translation>
    </message>
    <message>
        <source>The angiogram frame contains pixel values that are not finite numbers. Choose another frame, or export the image again.</source>
        <comment>frame.not-finite</comment>
        <translation>Das Angiogrammbild enthält Pixelwerte, die keine endlichen Zahlen sind. Wählen Sie ein anderes Bild, oder exportieren Sie die Aufnahme neu.</translation>
    </message>
    <message>
        <source>All pixels of the angiogram frame have the same gray value, so there is nothing to trace. Choose another frame or file.</source>
        <comment>frame.one-colour</comment>
        <translation>Das Angiogrammbild hat nur einen Grauwert: Es gibt nichts zu erkennen. Wählen Sie ein anderes Bild oder eine andere Datei.</translation>
    </message>
    <message>
        <source>This is a page of text, such as a dose report, not an angiogram. Choose the corresponding run, or another frame.</source>
        <comment>frame.report-page</comment>
        <translation>Dies ist eine Textseite, etwa ein Dosisbericht, kein Angiogramm. Wählen Sie die Serie, zu der sie gehört, oder ein anderes Bild.</translation>
    </message>
    <message>
        <source>The structures traced here are already visible in the first frame of the run: no contrast agent arrives between the two frames. If the run contains no contrast agent, the structures are catheters, guidewires and bone edges, not vessels.</source>
        <comment>frame.nothing-new</comment>
        <translation>Die hier erkannten Strukturen sind schon im ersten Bild der Serie sichtbar: Dazwischen kommt kein Kontrastmittel an. Enthält die Serie keines, sind es Katheter, Führungsdrähte und Knochenkanten, keine Gefäße.</translation>
    </message>
    <message>
        <source>Few structures in this frame resemble opacified vessels: the traced curves are short or faint, or may be catheters, guidewires and bone edges. Choose a frame with more contrast agent; if there is no such frame, check the curves with “Edit traced vessels”.</source>
        <comment>frame.little-contrast</comment>
        <translation>Wenige Strukturen in diesem Bild ähneln kontrastierten Gefäßen: Die erkannten Kurven sind kurz oder schwach, oder es sind vielleicht Katheter, Führungsdrähte und Knochenkanten. Wählen Sie ein Bild mit mehr Kontrastmittel; gibt es keines, prüfen Sie die Kurven mit „Erkannte Gefäße bearbeiten“.</translation>
    </message>
    <message>
        <source>No vessel was found in the angiogram frame. Choose a frame with more contrast agent, raise the sensitivity, or check whether the vessels are dark or bright.</source>
        <comment>frame.no-vessels</comment>
        <translation>Im Angiogrammbild wurde kein Gefäß gefunden. Wählen Sie ein Bild mit mehr Kontrastmittel, erhöhen Sie die Empfindlichkeit, oder prüfen Sie, ob Gefäße dunkel oder hell sind.</translation>
    </message>
    <message>
        <source>The minimum vessel radius (%1) must be positive and not larger than the maximum vessel radius (%2).</source>
        <comment>trace.radii-unusable</comment>
        <translation>Der minimale Gefäßradius (%1) muss positiv und darf höchstens so groß wie der maximale (%2) sein.</translation>
    </message>
    <message>
        <source>The tracing sensitivity must be greater than 0, not %1.</source>
        <comment>trace.sensitivity-unusable</comment>
        <translation>Die Empfindlichkeit der Erkennung muss über 0 liegen, nicht %1.</translation>
    </message>
    <message>
        <source>The vessel mask contains no vessel with a length of at least %1. Draw longer vessels, or lower the minimum length.</source>
        <comment>frame.mask-without-vessels</comment>
        <translation>Die Gefäßmaske enthält kein Gefäß von mindestens %1. Zeichnen Sie längere Gefäße, oder senken Sie die Mindestlänge.</translation>
    </message>
    <message>
        <source>The run has only one frame, so no mask can be subtracted. Choose a run with frames before the arrival of contrast agent.</source>
        <comment>subtraction.one-frame</comment>
        <translation>Die Serie hat nur ein Bild: Es gibt nichts zu subtrahieren. Wählen Sie eine Serie mit Bildern vor Kontrastmittelankunft.</translation>
    </message>
    <message>
        <source>The frames of the run differ in size and cannot be subtracted.</source>
        <comment>subtraction.sizes-differ</comment>
        <translation>Die Bilder der Serie sind verschieden groß und lassen sich nicht subtrahieren.</translation>
    </message>
    <message>
        <source>The run shows contrast agent from the first frame on, so no frame can serve as the mask. Specify the mask frames, or trace without subtraction.</source>
        <comment>subtraction.no-mask</comment>
        <translation>Die Serie zeigt vom ersten Bild an Kontrastmittel; kein Bild eignet sich als Maske. Geben Sie die Maskenbilder an, oder erkennen Sie ohne Subtraktion.</translation>
    </message>
    <message>
        <source>The subtraction was stopped.</source>
        <comment>subtraction.stopped</comment>
        <translation>Die Subtraktion wurde angehalten.</translation>
    </message>
    <message>
        <source>The volume is empty. Choose another series or file.</source>
        <comment>volume.empty</comment>
        <translation>Das Volumen ist leer. Wählen Sie eine andere Serie oder Datei.</translation>
    </message>
    <message>
        <source>The volume has more than 4 billion voxels. Crop or resample it first.</source>
        <comment>volume.too-large</comment>
        <translation>Das Volumen hat mehr als 4 Milliarden Voxel. Schneiden Sie es zuerst zu, oder tasten Sie es neu ab.</translation>
    </message>
    <message>
        <source>The volume has no valid voxel spacing. Enter the spacing in mm, or export the volume again.</source>
        <comment>volume.no-spacing</comment>
        <translation>Das Volumen hat keinen gültigen Voxelabstand. Geben Sie den Abstand in mm ein, oder exportieren Sie es neu.</translation>
    </message>
    <message>
        <source>All voxels of the volume have the same value, so there is nothing to trace. Choose another series or file.</source>
        <comment>volume.one-value</comment>
        <translation>Das Volumen hat nur einen Wert: Es gibt nichts zu erkennen. Wählen Sie eine andere Serie oder Datei.</translation>
    </message>
    <message>
        <source>Tracing was stopped; no result was kept.</source>
        <comment>tracing.stopped</comment>
        <translation>Die Erkennung wurde angehalten; es wurde kein Ergebnis behalten.</translation>
    </message>
    <message>
        <source>The volume contains no vessel: no voxel belongs to the mask. Lower the threshold, or load another file.</source>
        <comment>tracing.nothing-set</comment>
        <translation>Das Volumen enthält kein Gefäß: Kein Voxel ist gesetzt. Senken Sie die Schwelle, oder laden Sie eine andere Datei.</translation>
    </message>
    <message>
        <source>The volume contains no vessel-like structure: no branch is long enough. Lower the threshold or the minimum branch length.</source>
        <comment>tracing.no-long-branch</comment>
        <translation>Das Volumen enthält keine gefäßartige Struktur: Kein Ast ist lang genug. Senken Sie die Schwelle oder die Mindestlänge der Äste.</translation>
    </message>
    <message>
        <source>No opacified vessels were found: soft tissue measures %1, and no uniform region shows vascular enhancement. Is this the arterial phase? Choose the CT angiogram, or set the lower vessel threshold.</source>
        <comment>tracing.no-contrast</comment>
        <translation>Es wurden keine kontrastierten Gefäße gefunden: Weichgewebe misst %1, und kein homogener Bereich zeigt eine Gefäßkontrastierung. Ist dies die arterielle Phase? Wählen Sie die CT-Angiographie, oder geben Sie die untere Schwelle der Gefäße an.</translation>
    </message>
    <message>
        <source>No opacified vessels were found: apart from bone, the brightest region measures %1 (soft tissue %2) and is not vessel-like. Is this the arterial phase? Choose the CT angiogram, or set the lower vessel threshold.</source>
        <comment>tracing.brightest-is-no-vessel</comment>
        <translation>Es wurden keine kontrastierten Gefäße gefunden: Außer Knochen misst der hellste Bereich %1 (Weichgewebe %2) und ist nicht gefäßartig. Ist dies die arterielle Phase? Wählen Sie die CT-Angiographie, oder geben Sie die untere Schwelle der Gefäße an.</translation>
    </message>
    <message>
        <source>There are points to avoid, but no seed. Place at least one seed in the vessels.</source>
        <comment>tracing.avoid-without-seed</comment>
        <translation>Es gibt zu meidende Punkte, aber keinen Startpunkt. Setzen Sie mindestens einen in die Gefäße.</translation>
    </message>
    <message>
        <source>(%1, %2, %3)</source>
        <comment>tracing.place</comment>
        <translation>(%1, %2, %3)</translation>
    </message>
    <message>
        <source>The seed at %1 mm (LPS) is not inside a vessel. Place the seed inside a vessel, or lower the threshold.</source>
        <comment>tracing.seed-in-no-vessel</comment>
        <translation>Der Startpunkt %1 mm (LPS) liegt in keinem Gefäß. Setzen Sie ihn in eines, oder senken Sie die Schwelle.</translation>
    </message>
    <message>
        <source>The seed at %1 mm (LPS) is not inside an enhanced vessel: the vessel at a distance of %2 was used.</source>
        <comment>tracing.seed-moved</comment>
        <translation>Der Startpunkt %1 mm (LPS) liegt in keinem kontrastierten Gefäß: Das Gefäß in %2 Abstand wurde verwendet.</translation>
    </message>
    <message>
        <source>No seed was placed: the aorta (or main artery) was found automatically at %1 mm (LPS) and traced. If it is the wrong vessel, place a seed in the correct one.</source>
        <comment>tracing.no-seed-found-vessel</comment>
        <translation>Kein Startpunkt gesetzt: Die Aorta (oder Hauptarterie) wurde automatisch bei %1 mm (LPS) gefunden und erfasst. Ist es das falsche Gefäß, setzen Sie einen Startpunkt in das richtige.</translation>
    </message>
    <message>
        <source>No seed was placed, and no aorta or main artery was found: the largest component was traced. If it does not contain the desired vessels, place a seed in those vessels.</source>
        <comment>tracing.no-seed-largest-piece</comment>
        <translation>Kein Startpunkt gesetzt, und keine Aorta oder Hauptarterie gefunden: Die größte Komponente wurde erfasst. Sind es nicht die gewünschten Gefäße, setzen Sie einen Startpunkt in diese.</translation>
    </message>
    <message>
        <source>This is a head scan, in which arteries cannot be identified reliably: venous sinuses and veins may also be enhanced. Place a seed in the artery to trace, for example in a carotid artery in the neck or at the skull base.</source>
        <comment>tracing.head-needs-seed</comment>
        <translation>Dies ist ein Kopfscan, und die Arterien sind nicht sicher zu erkennen: Auch venöse Sinus und Venen können kontrastiert sein. Setzen Sie einen Startpunkt in die zu erfassende Arterie, etwa in eine Halsschlagader am Hals oder an der Schädelbasis.</translation>
    </message>
    <message>
        <source>The values of this scan are not in Hounsfield units, so no large vessel can be identified reliably. Place a seed in a wide part of the artery to trace.</source>
        <comment>tracing.scan-needs-seed</comment>
        <translation>Die Werte dieses Scans sind keine Hounsfield-Einheiten, und kein großes Gefäß ist sicher zu erkennen. Setzen Sie einen Startpunkt an einer weiten Stelle in die zu erfassende Arterie.</translation>
    </message>
    <message>
        <source>In this head scan, arteries and venous sinuses are connected and equally enhanced: the vessel that was found without a seed runs along the skull. Place a seed in the artery to trace, and mark the sinuses as points to avoid.</source>
        <comment>tracing.veins-with-arteries</comment>
        <translation>Arterien und venöse Sinus dieses Kopfes sind verbunden und gleich kontrastiert: Das ohne Startpunkt gefundene Gefäß verläuft am Schädel entlang. Setzen Sie einen Startpunkt in die zu erfassende Arterie, und markieren Sie die Sinus als zu meiden.</translation>
    </message>
    <message>
        <source>Intensity inhomogeneity due to coil sensitivity (up to %1×) was corrected: the threshold refers to intensities where the sensitivity is highest.</source>
        <comment>tracing.coil-evened-out</comment>
        <translation>Die Intensitätsinhomogenität durch die Spulenempfindlichkeit (bis %1×) wurde korrigiert: Die Schwelle bezieht sich auf Intensitäten, wo die Empfindlichkeit am höchsten ist.</translation>
    </message>
    <message>
        <source>The centerlines follow %1 of the mask&apos;s skeleton within two voxels; most of the rest is at %2 mm (LPS). Where the lumen is wide or its wall is rough, the centerlines follow the center of the lumen instead. Check there for a missing vessel.</source>
        <comment>tracing.skeleton-not-followed</comment>
        <translation>Die Mittellinien folgen %1 des Maskenskeletts bis auf zwei Voxel; das meiste vom Rest liegt bei %2 mm (LPS). Wo das Lumen weit oder seine Wand rau ist, folgen sie stattdessen der Lumenmitte. Prüfen Sie dort, ob ein Gefäß fehlt.</translation>
    </message>
    <message>
        <source>The point at %1 mm (LPS) is outside the scan. Choose a point inside the scan.</source>
        <comment>tracing.path-end-outside-scan</comment>
        <translation>Der Punkt %1 mm (LPS) liegt außerhalb des Scans. Wählen Sie einen innerhalb.</translation>
    </message>
    <message>
        <source>The point at %1 mm (LPS) is not inside a structure brighter than its surroundings. Place the point inside the vessel.</source>
        <comment>tracing.path-end-in-nothing</comment>
        <translation>Der Punkt %1 mm (LPS) liegt in keiner Struktur, die heller als ihre Umgebung ist. Setzen Sie ihn in das Gefäß.</translation>
    </message>
    <message>
        <source>Both points are at the same position in the vessel. Place them farther apart.</source>
        <comment>tracing.path-ends-too-near</comment>
        <translation>Beide Punkte liegen an derselben Stelle des Gefäßes. Setzen Sie sie weiter auseinander.</translation>
    </message>
    <message>
        <source>No path was found between the two points. Place them closer together.</source>
        <comment>tracing.path-not-found</comment>
        <translation>Zwischen den beiden Punkten wurde kein Weg gefunden. Setzen Sie sie näher zusammen.</translation>
    </message>
    <message>
        <source>Over a length of %1, the path does not run through a vessel-like structure. Check the path, or place a point in between.</source>
        <comment>tracing.path-outside</comment>
        <translation>Auf einer Länge von %1 verläuft der Weg durch keine gefäßartige Struktur. Prüfen Sie ihn, oder setzen Sie einen Punkt dazwischen.</translation>
    </message>
    <message>
        <source>Tracing thin vessels requires seeds, but none has been placed. Place one in each vessel, near its origin.</source>
        <comment>tracing.tubes-need-seed</comment>
        <translation>Das Erfassen dünner Gefäße braucht Startpunkte, und keiner ist gesetzt. Setzen Sie in jedes Gefäß einen, nahe dem Abgang.</translation>
    </message>
    <message>
        <source>No thin vessel of sufficient length was found starting from the seeds. Place the seeds at the center of the vessels, or turn off the restriction to thin vessels.</source>
        <comment>tracing.no-tube-at-seed</comment>
        <translation>Von den Startpunkten aus wurde kein ausreichend langes dünnes Gefäß gefunden. Setzen Sie sie in die Mitte der Gefäße, oder heben Sie die Beschränkung auf dünne Gefäße auf.</translation>
    </message>
    <message>
        <source>The search limit was reached, so the vessels are truncated. Check for leakage into lung, liver or bone.</source>
        <comment>tracing.tubes-cut-short</comment>
        <translation>Die Suchgrenze wurde erreicht: Die Gefäße sind abgeschnitten. Prüfen Sie, ob die Segmentierung in Lunge, Leber oder Knochen ausläuft.</translation>
    </message>
    <message>
        <source>The vessels consist of %1 unconnected components, each with its own root: %2. Connect those that belong together, or select the desired components by placing a seed in each.</source>
        <comment>tracing.vessels-in-pieces</comment>
        <translation>Die Gefäße bestehen aus %1 unverbundenen Komponenten, jede mit eigener Wurzel: %2. Verbinden Sie, was zusammengehört, oder wählen Sie einzelne durch je einen Startpunkt aus.</translation>
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
        <source>%1 more with %2</source>
        <comment>tracing.other-pieces</comment>
        <translation>%1 weitere mit %2</translation>
    </message>
    <message>
        <source>A component that is not connected to the traced vessels was omitted: at %1 mm (LPS). Place a seed in it if it belongs to the tree.</source>
        <comment>tracing.one-piece-left-out</comment>
        <translation>Eine nicht mit den erkannten Gefäßen verbundene Komponente wurde ausgelassen: %1 mm (LPS). Setzen Sie einen Startpunkt hinein, wenn sie zum Baum gehört.</translation>
    </message>
    <message>
        <source>%1 components with %2 of the voxels are not connected to the traced vessels and were omitted: %3. Place a seed in each that belongs to the tree.</source>
        <comment>tracing.pieces-left-out</comment>
        <translation>%1 Komponenten mit %2 der Voxel sind nicht mit den erkannten Gefäßen verbunden und wurden ausgelassen: %3. Setzen Sie in jede, die zum Baum gehört, einen Startpunkt.</translation>
    </message>
    <message>
        <source>A component contains no branch of the minimum length and was omitted: at %1 mm (LPS). Lower the minimum branch length if it is a vessel.</source>
        <comment>tracing.one-piece-too-short</comment>
        <translation>Eine Komponente enthält keinen Ast der Mindestlänge und wurde ausgelassen: %1 mm (LPS). Senken Sie die Mindestlänge der Äste, wenn es ein Gefäß ist.</translation>
    </message>
    <message>
        <source>%1 components with %2 of the voxels contain no branch of the minimum length and were omitted: %3. Lower the minimum branch length if they are vessels.</source>
        <comment>tracing.pieces-too-short</comment>
        <translation>%1 Komponenten mit %2 der Voxel enthalten keinen Ast der Mindestlänge und wurden ausgelassen: %3. Senken Sie die Mindestlänge der Äste, wenn es Gefäße sind.</translation>
    </message>
    <message>
        <source>Gaps across which a vessel clearly continues were closed (number: %1; length: up to %2). Check that the connected vessels belong together.</source>
        <comment>tracing.gaps-closed</comment>
        <translation>Lücken, über die ein Gefäß deutlich weiterläuft, wurden geschlossen (Anzahl: %1; Länge: bis %2). Prüfen Sie, ob die verbundenen Gefäße zusammengehören.</translation>
    </message>
    <message>
        <source>1 loop was cut at its narrowest point; check whether vessels merely touch there.</source>
        <comment>tracing.one-loop-opened</comment>
        <translation>1 Schleife wurde an der engsten Stelle getrennt; prüfen Sie, ob sich dort Gefäße nur berühren.</translation>
    </message>
    <message>
        <source>%1 loops were cut at their narrowest points; check whether vessels merely touch there.</source>
        <comment>tracing.loops-opened</comment>
        <translation>%1 Schleifen wurden an den engsten Stellen getrennt; prüfen Sie, ob sich dort Gefäße nur berühren.</translation>
    </message>
    <message>
        <source>Loops kept as requested: %1. Where a loop closes, one branch ends on another.</source>
        <comment>tracing.loops-kept</comment>
        <translation>Wie gewünscht erhaltene Schleifen: %1. Wo sich eine schließt, endet ein Ast auf einem anderen.</translation>
    </message>
    <message>
        <source>A region darker than the vessels was omitted; it may be a vein or soft tissue. Place a seed in it if it belongs to the tree.</source>
        <comment>tracing.one-dim-part-left-out</comment>
        <translation>Ein Bereich, der dunkler als die Gefäße ist, wurde ausgelassen; es könnte eine Vene oder Weichgewebe sein. Setzen Sie einen Startpunkt hinein, wenn er zum Baum gehört.</translation>
    </message>
    <message>
        <source>%1 regions darker than the vessels were omitted; they may be veins or soft tissue. Place seeds in those that belong to the tree.</source>
        <comment>tracing.dim-parts-left-out</comment>
        <translation>%1 Bereiche, die dunkler als die Gefäße sind, wurden ausgelassen; es könnten Venen oder Weichgewebe sein. Setzen Sie in die, die zum Baum gehören, einen Startpunkt.</translation>
    </message>
    <message>
        <source>No voxel of the scan has a value as low as that of air in Hounsfield units. If the values are not in Hounsfield units, bone cannot be separated reliably from vessels. Check the vessels for bone, or export the scan in Hounsfield units.</source>
        <comment>tracing.perhaps-no-hounsfield</comment>
        <translation>Kein Voxel des Scans ist so dunkel wie Luft in Hounsfield-Einheiten: Sind die Werte keine HE, lässt sich Knochen nicht sicher von Gefäßen trennen. Prüfen Sie die Gefäße auf Knochen, oder exportieren Sie den Scan in Hounsfield-Einheiten.</translation>
    </message>
    <message>
        <source>The vessel tree has no branches. Provide a centerline with at least one branch.</source>
        <comment>tree.no-branches</comment>
        <translation>Der Gefäßbaum hat keine Äste. Geben Sie eine Mittellinie mit mindestens einem Ast an.</translation>
    </message>
    <message>
        <source>Branch %1 occurs twice in the vessel tree. Branch IDs must be unique.</source>
        <comment>tree.branch-twice</comment>
        <translation>Ast %1 kommt im Gefäßbaum doppelt vor. Ast-IDs müssen eindeutig sein.</translation>
    </message>
    <message>
        <source>Branch %1 of the vessel tree has fewer than two points. Remove the branch, or add points.</source>
        <comment>tree.branch-too-few-points</comment>
        <translation>Ast %1 des Gefäßbaums hat weniger als zwei Punkte. Entfernen Sie ihn, oder ergänzen Sie Punkte.</translation>
    </message>
    <message>
        <source>Branch %1 of the vessel tree has a coordinate that is not a finite number.</source>
        <comment>tree.branch-not-finite</comment>
        <translation>Ast %1 des Gefäßbaums hat eine Koordinate, die keine endliche Zahl ist.</translation>
    </message>
    <message>
        <source>Branch %1 of the vessel tree has zero length: all its points coincide.</source>
        <comment>tree.branch-without-length</comment>
        <translation>Ast %1 des Gefäßbaums hat keine Länge: alle Punkte fallen zusammen.</translation>
    </message>
    <message>
        <source>Branch %1 of the vessel tree has different numbers of radii and points.</source>
        <comment>tree.branch-radii-missing</comment>
        <translation>Die Zahl der Radien von Ast %1 des Gefäßbaums entspricht nicht der Zahl seiner Punkte.</translation>
    </message>
    <message>
        <source>Branch %1 of the vessel tree has a radius that is negative or not a number. Correct the radius, or omit the radii of this branch.</source>
        <comment>tree.branch-radius-unusable</comment>
        <translation>Ast %1 des Gefäßbaums hat einen Radius, der negativ oder keine Zahl ist. Berichtigen Sie ihn, oder lassen Sie die Radien dieses Astes weg.</translation>
    </message>
    <message>
        <source>The vessel tree has no branch %1.</source>
        <comment>tree.no-such-branch</comment>
        <translation>Der Gefäßbaum hat keinen Ast %1.</translation>
    </message>
    <message>
        <source>The range of %1 must consist of two angles within ±%2°, with the lower one first.</source>
        <comment>angles.range-odd</comment>
        <translation>Der Bereich von %1 braucht zwei Winkel innerhalb von ±%2°, den kleineren zuerst.</translation>
    </message>
    <message>
        <source>The angle search was stopped.</source>
        <comment>angles.stopped</comment>
        <translation>Die Winkelsuche wurde angehalten.</translation>
    </message>
    <message>
        <source>The angle step must be at least %1.</source>
        <comment>angles.step-too-fine</comment>
        <translation>Die Winkelschrittweite muss mindestens %1 sein.</translation>
    </message>
    <message>
        <source>Select one branch in the image, in the 3-D view or in the list.</source>
        <comment>angles.select-one-branch</comment>
        <translation>Wählen Sie einen Ast im Bild, in der 3-D-Ansicht oder in der Liste aus.</translation>
    </message>
    <message>
        <source>The vessels have no radii: 1 mm is assumed, so the overlap of the branch is an estimate.</source>
        <comment>tree.radii-assumed</comment>
        <translation>Die Gefäße haben keine Radien: 1 mm wird angenommen; die Überdeckung des Astes ist daher geschätzt.</translation>
    </message>
    <message>
        <source>Branch %1 is not connected to another branch, so it has no takeoff. Specify the branch itself instead.</source>
        <comment>tree.no-take-off</comment>
        <translation>Ast %1 ist mit keinem anderen Ast verbunden und hat daher keinen Abgang. Verwenden Sie den Ast selbst.</translation>
    </message>
    <message>
        <source>All branches descend from branch %1; no branches would remain if it were deleted.</source>
        <comment>edit.all-hang-on-branch</comment>
        <translation>Alle Äste gehen von Ast %1 aus; es blieben keine Äste übrig.</translation>
    </message>
    <message>
        <source>All branches are shorter or thinner than the limits; no branches would remain. Lower the limits.</source>
        <comment>edit.all-pruned</comment>
        <translation>Alle Äste sind kürzer oder dünner als die Grenzen; es blieben keine Äste übrig. Senken Sie die Grenzen.</translation>
    </message>
    <message>
        <source>Branch %1 cannot be cut so close to its end. Delete the branch, or cut it farther from the end.</source>
        <comment>edit.cut-too-near-end</comment>
        <translation>Ast %1 lässt sich so nah am Ende nicht trennen. Löschen Sie ihn, oder trennen Sie weiter vom Ende entfernt.</translation>
    </message>
    <message>
        <source>The whole path runs inside vessels that are already traced, so there is nothing to add.</source>
        <comment>edit.branch-runs-inside</comment>
        <translation>Der ganze Weg verläuft in bereits erfassten Gefäßen: Es gibt nichts hinzuzufügen.</translation>
    </message>
    <message>
        <source>A branch cannot be connected to itself. Choose two branches.</source>
        <comment>edit.joined-to-itself</comment>
        <translation>Ein Ast lässt sich nicht mit sich selbst verbinden. Wählen Sie zwei Äste.</translation>
    </message>
    <message>
        <source>The 2-D centerline is empty: no vessel was found in the image. Choose another frame or a higher sensitivity, or provide a centerline file.</source>
        <comment>centreline.empty</comment>
        <translation>Die 2-D-Mittellinie ist leer: Im Bild wurde kein Gefäß gefunden. Wählen Sie ein anderes Bild oder eine höhere Empfindlichkeit, oder geben Sie eine Mittelliniendatei an.</translation>
    </message>
    <message>
        <source>Curve %1 of the 2-D centerline has a coordinate that is not a finite number.</source>
        <comment>centreline.curve-not-finite</comment>
        <translation>Kurve %1 der 2-D-Mittellinie hat eine Koordinate, die keine endliche Zahl ist.</translation>
    </message>
    <message>
        <source>The surface has no triangles, or the voxel size is not positive. Choose another surface.</source>
        <comment>surface.empty</comment>
        <translation>Die Oberfläche hat keine Dreiecke, oder die Voxelgröße ist nicht positiv. Wählen Sie eine andere Oberfläche.</translation>
    </message>
    <message>
        <source>The surface is flat and encloses no volume. Choose the surface of a vessel wall.</source>
        <comment>surface.flat</comment>
        <translation>Die Oberfläche ist flach und umschließt kein Volumen. Wählen Sie eine Gefäßwand.</translation>
    </message>
    <message>
        <source>The voxel size is too small for a surface of this size. Choose a larger voxel size.</source>
        <comment>surface.voxel-too-fine</comment>
        <translation>Die Voxelgröße ist für eine so große Oberfläche zu klein. Wählen Sie eine größere.</translation>
    </message>
    <message>
        <source>The surface encloses no volume: it has large openings or is thinner than a voxel. Close its holes, or choose a smaller voxel size.</source>
        <comment>surface.nothing-inside</comment>
        <translation>Die Oberfläche umschließt nichts: Sie ist zu offen oder dünner als ein Voxel. Schließen Sie die Löcher, oder wählen Sie kleinere Voxel.</translation>
    </message>
    <message>
        <source>the file is too large for a case. Choose an .angiopose file.</source>
        <comment>case.too-large</comment>
        <translation>die Datei ist zu groß für einen Fall. Wählen Sie eine .angiopose-Datei.</translation>
    </message>
    <message>
        <source>this is %1, not a case. Choose an .angiopose file.</source>
        <comment>case.is-other</comment>
        <translation>dies ist %1, kein Fall. Wählen Sie eine .angiopose-Datei.</translation>
    </message>
    <message>
        <source>this JSON is not an AngioPose case (its format is not &quot;angiopose-case&quot;). Choose an .angiopose file.</source>
        <comment>case.not-one</comment>
        <translation>dieses JSON ist kein AngioPose-Fall (sein format ist nicht &quot;angiopose-case&quot;). Wählen Sie eine .angiopose-Datei.</translation>
    </message>
    <message>
        <source>a value has the wrong type. Compare the file with the published schema.</source>
        <comment>case.wrong-kind</comment>
        <translation>ein Wert hat den falschen Typ. Vergleichen Sie die Datei mit dem veröffentlichten Schema.</translation>
    </message>
    <message>
        <source>the case was saved by a newer version of AngioPose. Update the program.</source>
        <comment>case.newer</comment>
        <translation>der Fall stammt von einem neueren AngioPose. Aktualisieren Sie das Programm.</translation>
    </message>
    <message>
        <source>the key %1 is missing. Add it.</source>
        <comment>case.key-missing</comment>
        <translation>der Schlüssel %1 fehlt. Ergänzen Sie ihn.</translation>
    </message>
    <message>
        <source>this value is not allowed. See the published schema.</source>
        <comment>case.value-not-allowed</comment>
        <translation>der Wert ist nicht erlaubt. Siehe das veröffentlichte Schema.</translation>
    </message>
    <message>
        <source>the value has the wrong type. See the published schema.</source>
        <comment>case.value-of-wrong-kind</comment>
        <translation>der Wert hat den falschen Typ. Siehe das veröffentlichte Schema.</translation>
    </message>
    <message>
        <source>%1 Correct this value.</source>
        <comment>case.value-wrong</comment>
        <translation>%1 Berichtigen Sie diesen Wert.</translation>
    </message>
    <message>
        <source>the file does not conform to the published schema. Compare it with a valid case.</source>
        <comment>case.against-schema</comment>
        <translation>die Datei entspricht nicht dem veröffentlichten Schema. Vergleichen Sie sie mit einem gültigen Fall.</translation>
    </message>
    <message>
        <source>this is an input of the case and will not be overwritten. Choose another name.</source>
        <comment>case.is-input</comment>
        <translation>dies ist eine Eingabe des Falls und wird nicht überschrieben. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>a file name or other text in the case is not valid UTF-8. Rename the file, or correct the text.</source>
        <comment>case.not-utf8</comment>
        <translation>ein Dateiname oder anderer Text im Fall ist kein gültiges UTF-8. Benennen Sie die Datei um, oder berichtigen Sie den Text.</translation>
    </message>
    <message>
        <source>a scan alone is not a case: a case requires traced vessels and an angiogram. Trace the vessels and open an angiogram before saving; the scan file itself is not changed.</source>
        <comment>case.scan-alone</comment>
        <translation>ein CT allein ist noch kein Fall: Die Falldatei braucht erfasste Gefäße und ein Angiogramm. Erfassen Sie vor dem Speichern die Gefäße, und öffnen Sie ein Angiogramm; die CT-Datei selbst wird nicht verändert.</translation>
    </message>
    <message>
        <source>a case requires a vessel tree and an angiogram. Open both before saving.</source>
        <comment>case.incomplete</comment>
        <translation>ein Fall braucht Gefäßbaum und Angiogramm. Öffnen Sie vor dem Speichern beide.</translation>
    </message>
    <message>
        <source>the pose is not a rigid transform with finite values. Reset it before saving.</source>
        <comment>case.pose-not-rigid</comment>
        <translation>die Lage ist keine starre Transformation mit endlichen Werten. Setzen Sie sie vor dem Speichern zurück.</translation>
    </message>
    <message>
        <source>the camera belongs to an image of %1 × %2 pixels, but the angiogram is %3 × %4 pixels. Specify the camera that belongs to this angiogram.</source>
        <comment>case.camera-of-other-image</comment>
        <translation>die Kamera gehört zu einem Bild mit %1 × %2 Pixeln, das Angiogramm hat aber %3 × %4 Pixel. Geben Sie die zum Angiogramm gehörende Kamera an.</translation>
    </message>
    <message>
        <source>maxVesselRadiusPx is less than minVesselRadiusPx. Swap the two values.</source>
        <comment>case.radii-swapped</comment>
        <translation>maxVesselRadiusPx ist kleiner als minVesselRadiusPx. Vertauschen Sie beide.</translation>
    </message>
    <message>
        <source>the case specifies no vessel input. Specify the vessel file as centerline, segmentation, surface or volume.</source>
        <comment>case.no-input</comment>
        <translation>der Fall nennt keine Eingabe für die Gefäße. Geben Sie die Gefäßdatei als centerline, segmentation, surface oder volume an.</translation>
    </message>
    <message>
        <source>%1 Remove the key to restore the unedited vessels.</source>
        <comment>case.edited-tree</comment>
        <translation>%1 Entfernen Sie den Schlüssel, um die unbearbeiteten Gefäße wiederherzustellen.</translation>
    </message>
    <message>
        <source>branch %1 occurs twice.</source>
        <comment>case.branch-twice</comment>
        <translation>Ast %1 kommt doppelt vor.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is unknown. Use one of %2.</source>
        <comment>case.method-unknown</comment>
        <translation>&quot;%1&quot; ist unbekannt. Möglich: %2.</translation>
    </message>
    <message>
        <source>enter a number from %1 to %2.</source>
        <comment>case.option-number</comment>
        <translation>geben Sie eine Zahl von %1 bis %2 ein.</translation>
    </message>
    <message>
        <source>choose one of %1.</source>
        <comment>case.option-choice</comment>
        <translation>wählen Sie eines von %1.</translation>
    </message>
    <message>
        <source>the initial pose is missing and cannot be computed from the angles. %1</source>
        <comment>case.no-start-pose</comment>
        <translation>die Startlage fehlt und lässt sich nicht aus den Winkeln berechnen. %1</translation>
    </message>
    <message>
        <source>the file has changed since the case was saved. Check that it is the correct file.</source>
        <comment>case.file-changed</comment>
        <translation>die Datei hat sich seit dem Speichern des Falls geändert. Prüfen Sie, ob es die richtige ist.</translation>
    </message>
    <message>
        <source>the stored result was discarded because the vessels, the image or the traced curves have changed since it was computed. Register again.</source>
        <comment>case.result-stale</comment>
        <translation>das gespeicherte Ergebnis wurde verworfen, weil sich Gefäße, Bild oder erkannte Kurven seither geändert haben. Registrieren Sie erneut.</translation>
    </message>
    <message>
        <source>the stored result was discarded because parts of the case have changed since it was computed: %1. Register again.</source>
        <comment>case.result-beside</comment>
        <translation>das gespeicherte Ergebnis wurde verworfen, weil sich Teile des Falls seit der Berechnung geändert haben: %1. Registrieren Sie erneut.</translation>
    </message>
    <message>
        <source>the tracked poses were discarded because they do not match the run or the pose of the case. Track the vessels again.</source>
        <comment>case.followed-misfit</comment>
        <translation>die verfolgten Lagen wurden verworfen, weil sie nicht zur Serie oder zur Lage des Falls passen. Verfolgen Sie die Gefäße erneut.</translation>
    </message>
    <message>
        <source>The vessels of a tracked run are shown at the tracked poses, but without deformation: %1 Track the vessels again.</source>
        <comment>case.bends-left-out</comment>
        <translation>Die Gefäße einer verfolgten Serie werden in ihren Lagen gezeigt, aber ohne Verformung: %1 Verfolgen Sie sie erneut.</translation>
    </message>
    <message>
        <source>the case specifies no deformation file.</source>
        <comment>case.bends-unnamed</comment>
        <translation>der Fall nennt keine Verformungsdatei.</translation>
    </message>
    <message>
        <source>this is not a deformation file.</source>
        <comment>case.bends-none</comment>
        <translation>dies ist keine Verformungsdatei.</translation>
    </message>
    <message>
        <source>the deformations belong to different vessels or frames.</source>
        <comment>case.bends-of-others</comment>
        <translation>die Verformungen gehören zu anderen Gefäßen oder Bildern.</translation>
    </message>
    <message>
        <source>the deformations are damaged or truncated.</source>
        <comment>case.bends-cut</comment>
        <translation>die Verformungen sind beschädigt oder unvollständig.</translation>
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
        <translation>die erkannten Kurven</translation>
    </message>
    <message>
        <source>the geometry</source>
        <comment>part.geometry</comment>
        <translation>die Geometrie</translation>
    </message>
    <message>
        <source>the initial pose</source>
        <comment>part.start-pose</comment>
        <translation>die Startlage</translation>
    </message>
    <message>
        <source>the locked degrees of freedom</source>
        <comment>part.locks</comment>
        <translation>die gesperrten Freiheitsgrade</translation>
    </message>
    <message>
        <source>the method</source>
        <comment>part.method</comment>
        <translation>die Methode</translation>
    </message>
    <message>
        <source>the options</source>
        <comment>part.options</comment>
        <translation>die Optionen</translation>
    </message>
    <message>
        <source>this is not the DICOM image from which the case was created.</source>
        <comment>case.other-image</comment>
        <translation>dies ist nicht das DICOM-Bild, mit dem der Fall erstellt wurde.</translation>
    </message>
    <message>
        <source>%1 The case contains the edited vessels and can be opened without this file.</source>
        <comment>case.opens-without</comment>
        <translation>%1 Der Fall enthält die bearbeiteten Gefäße und lässt sich ohne die Datei öffnen.</translation>
    </message>
    <message>
        <source>the tree has no branch %1; this entry is ignored.</source>
        <comment>case.branch-left-out</comment>
        <translation>der Baum hat keinen Ast %1; der Eintrag wird ignoriert.</translation>
    </message>
    <message>
        <source>An additional view was omitted: %1</source>
        <comment>case.view-left-out</comment>
        <translation>Eine weitere Ansicht wurde ausgelassen: %1</translation>
    </message>
    <message>
        <source>line %1: &apos;%2&apos; is not a valid folder name. Use a name without &apos;/&apos;.</source>
        <comment>batch.no-folder-name</comment>
        <translation>Zeile %1: „%2“ ist kein gültiger Ordnername. Verwenden Sie einen ohne „/“.</translation>
    </message>
    <message>
        <source>line %1: the frame number &apos;%2&apos; is not an integer. Correct the line.</source>
        <comment>batch.frame-no-number</comment>
        <translation>Zeile %1: Die Bildnummer „%2“ ist keine ganze Zahl. Berichtigen Sie die Zeile.</translation>
    </message>
    <message>
        <source>line %1: the name &apos;%2&apos; is already in use. Use a unique name for each case.</source>
        <comment>batch.name-twice</comment>
        <translation>Zeile %1: Der Name „%2“ ist schon vergeben. Verwenden Sie für jeden Fall einen eigenen Namen.</translation>
    </message>
    <message>
        <source>the column %1 is missing. Choose a folder written by `angiopose-cli evaluate`.</source>
        <comment>runs.column-missing</comment>
        <translation>die Spalte %1 fehlt. Wählen Sie einen Ordner, den `angiopose-cli evaluate` geschrieben hat.</translation>
    </message>
    <message>
        <source>the value in line %1, column %2 is not a number. Choose a folder written by `angiopose-cli evaluate`.</source>
        <comment>runs.no-number</comment>
        <translation>Zeile %1, Spalte %2 ist keine Zahl. Wählen Sie einen Ordner, den `angiopose-cli evaluate` geschrieben hat.</translation>
    </message>
    <message>
        <source>the folder contains results of different experiments or seeds. Use a separate folder for each experiment and seed.</source>
        <comment>runs.mixed</comment>
        <translation>der Ordner enthält Ergebnisse verschiedener Experimente oder Startwerte. Verwenden Sie für jedes einen eigenen Ordner.</translation>
    </message>
    <message>
        <source>reading was stopped.</source>
        <comment>file.reading-stopped</comment>
        <translation>das Lesen wurde angehalten.</translation>
    </message>
    <message>
        <source>the file does not exist. Check the path.</source>
        <comment>file.missing</comment>
        <translation>die Datei existiert nicht. Prüfen Sie den Pfad.</translation>
    </message>
    <message>
        <source>the file cannot be accessed (%1). Check the path.</source>
        <comment>file.unreachable</comment>
        <translation>auf die Datei kann nicht zugegriffen werden (%1). Prüfen Sie den Pfad.</translation>
    </message>
    <message>
        <source>the file cannot be opened (%1). Check your read permission.</source>
        <comment>file.not-opened</comment>
        <translation>die Datei lässt sich nicht öffnen (%1). Prüfen Sie die Leserechte.</translation>
    </message>
    <message>
        <source>the file cannot be read (%1). Copy it to a local disk.</source>
        <comment>file.not-read</comment>
        <translation>die Datei lässt sich nicht lesen (%1). Kopieren Sie sie auf eine lokale Festplatte.</translation>
    </message>
    <message>
        <source>the file cannot be written (%1). Choose another folder, or free disk space.</source>
        <comment>file.not-written</comment>
        <translation>die Datei lässt sich nicht schreiben (%1). Wählen Sie einen anderen Ordner, oder schaffen Sie Speicherplatz.</translation>
    </message>
    <message>
        <source>this is a folder. Choose a file in it.</source>
        <comment>file.is-folder</comment>
        <translation>dies ist ein Ordner. Wählen Sie eine Datei darin.</translation>
    </message>
    <message>
        <source>this is not a regular file. Choose a file on a disk.</source>
        <comment>file.not-regular</comment>
        <translation>dies ist keine reguläre Datei. Wählen Sie eine Datei auf der Festplatte.</translation>
    </message>
    <message>
        <source>the file is empty. Export or copy it again.</source>
        <comment>file.empty</comment>
        <translation>die Datei ist leer. Exportieren oder kopieren Sie sie neu.</translation>
    </message>
    <message>
        <source>this is a Git LFS pointer, not the file itself. Run `git lfs pull` in its repository.</source>
        <comment>file.lfs-pointer</comment>
        <translation>dies ist ein Git-LFS-Verweis, nicht die Datei selbst. Führen Sie `git lfs pull` in ihrem Repository aus.</translation>
    </message>
    <message>
        <source>the file cannot be saved here. Enter a file name in an existing folder.</source>
        <comment>file.no-place</comment>
        <translation>die Datei lässt sich hier nicht speichern. Geben Sie einen Dateinamen in einem vorhandenen Ordner ein.</translation>
    </message>
    <message>
        <source>the unit must be a positive length in mm.</source>
        <comment>file.wrong-unit</comment>
        <translation>die Einheit muss eine positive Länge in mm sein.</translation>
    </message>
    <message>
        <source>the file declares more data than fit into memory. It is damaged; export it again.</source>
        <comment>file.larger-than-memory</comment>
        <translation>die Datei nennt mehr Daten, als in den Speicher passen. Sie ist beschädigt; exportieren Sie sie neu.</translation>
    </message>
    <message>
        <source>the decoder %1 is missing or cannot be started. Reinstall AngioPose.</source>
        <comment>file.decoder-missing</comment>
        <translation>der Decoder %1 fehlt oder lässt sich nicht starten. Installieren Sie AngioPose neu.</translation>
    </message>
    <message>
        <source>the decoder could not process the file. The file is damaged; export it again, or in another format.</source>
        <comment>file.decoder-died</comment>
        <translation>der Decoder konnte die Datei nicht verarbeiten. Die Datei ist beschädigt; exportieren Sie sie neu oder in einem anderen Format.</translation>
    </message>
    <message>
        <source>decoding takes far longer than expected for the file size. The file is damaged; export it again.</source>
        <comment>file.decoder-too-long</comment>
        <translation>das Dekodieren dauert viel länger, als für die Dateigröße zu erwarten ist. Die Datei ist beschädigt; exportieren Sie sie neu.</translation>
    </message>
    <message>
        <source>decoding requires far more memory than expected for the file size. The file is damaged; export it again.</source>
        <comment>file.decoder-too-large</comment>
        <translation>das Dekodieren braucht viel mehr Speicher, als für die Dateigröße zu erwarten ist. Die Datei ist beschädigt; exportieren Sie sie neu.</translation>
    </message>
    <message>
        <source>SHA-256 cannot be computed. Check the OpenSSL installation.</source>
        <comment>file.hash-impossible</comment>
        <translation>SHA-256 lässt sich nicht berechnen. Prüfen Sie die OpenSSL-Installation.</translation>
    </message>
    <message>
        <source>the folder cannot be read (%1). Check the path.</source>
        <comment>folder.not-read</comment>
        <translation>der Ordner lässt sich nicht lesen (%1). Prüfen Sie den Pfad.</translation>
    </message>
    <message>
        <source>the folder cannot be read completely. Copy it to a local disk.</source>
        <comment>folder.not-read-to-end</comment>
        <translation>der Ordner lässt sich nicht vollständig lesen. Kopieren Sie ihn auf eine lokale Festplatte.</translation>
    </message>
    <message>
        <source>the folder contains more than 50,000 files. Choose the folder of one study.</source>
        <comment>folder.too-full</comment>
        <translation>der Ordner enthält über 50.000 Dateien. Wählen Sie den Ordner einer einzelnen Studie.</translation>
    </message>
    <message>
        <source>the JSON is nested more than %1 levels deep. AngioPose does not write such files.</source>
        <comment>json.too-deep</comment>
        <translation>das JSON ist mehr als %1 Ebenen tief verschachtelt. AngioPose schreibt keine solchen Dateien.</translation>
    </message>
    <message>
        <source>the JSON is invalid at line %1. Correct the file, or restore a backup.</source>
        <comment>json.invalid</comment>
        <translation>das JSON ist in Zeile %1 ungültig. Berichtigen Sie die Datei, oder stellen Sie eine Sicherung wieder her.</translation>
    </message>
    <message>
        <source>the file contains a number that exceeds double precision. Correct it.</source>
        <comment>json.number-too-large</comment>
        <translation>die Datei enthält eine Zahl, die für double zu groß ist. Berichtigen Sie sie.</translation>
    </message>
    <message>
        <source>this is not a text table. Choose a CSV file with a header row.</source>
        <comment>table.no-text</comment>
        <translation>dies ist keine Texttabelle. Wählen Sie eine CSV-Datei mit Kopfzeile.</translation>
    </message>
    <message>
        <source>line %1 has %2 columns, but the first line has %3. Separate columns with commas, and use a period as the decimal point.</source>
        <comment>table.columns</comment>
        <translation>Zeile %1 hat %2 Spalten, die erste hat %3. Trennen Sie Spalten durch Kommas, und verwenden Sie den Punkt als Dezimalzeichen.</translation>
    </message>
    <message>
        <source>line %1, column %2: &quot;%3&quot; is not a finite number. Correct or remove the line.</source>
        <comment>table.no-number</comment>
        <translation>Zeile %1, Spalte %2: „%3“ ist keine endliche Zahl. Berichtigen oder entfernen Sie die Zeile.</translation>
    </message>
    <message>
        <source>line %1: the value in the branch column must be an integer. Correct the line.</source>
        <comment>table.branch-no-number</comment>
        <translation>Zeile %1: Der Wert in der Spalte branch muss eine ganze Zahl sein. Berichtigen Sie die Zeile.</translation>
    </message>
    <message>
        <source>the file must contain exactly one ITK transform. Export a single rigid transform.</source>
        <comment>pose.no-transform</comment>
        <translation>die Datei muss genau eine ITK-Transformation enthalten. Exportieren Sie eine einzelne starre Transformation.</translation>
    </message>
    <message>
        <source>the transform &quot;%1&quot; is not rigid, or parameters are missing. Export a rigid transform (affine, Euler3D or VersorRigid3D).</source>
        <comment>pose.not-rigid-transform</comment>
        <translation>die Transformation „%1“ ist nicht starr, oder es fehlen Parameter. Exportieren Sie eine starre (affine, Euler3D oder VersorRigid3D).</translation>
    </message>
    <message>
        <source>the center of the transform is not finite. Export the transform again.</source>
        <comment>pose.centre-not-finite</comment>
        <translation>der Mittelpunkt der Transformation ist nicht endlich. Exportieren Sie die Transformation neu.</translation>
    </message>
    <message>
        <source>the file contains no 4 × 4 matrix `cameraFromPatient`, at the top level or in `pose`. Add the matrix.</source>
        <comment>pose.no-matrix</comment>
        <translation>die Datei hat keine 4 × 4-Matrix `cameraFromPatient`, weder auf oberster Ebene noch in `pose`. Fügen Sie eine hinzu.</translation>
    </message>
    <message>
        <source>cameraFromPatient must have four rows of four numbers.</source>
        <comment>pose.rows</comment>
        <translation>cameraFromPatient muss vier Zeilen zu vier Zahlen haben.</translation>
    </message>
    <message>
        <source>cameraFromPatient contains a value that is not a finite number.</source>
        <comment>pose.not-finite</comment>
        <translation>cameraFromPatient enthält einen Wert, der keine endliche Zahl ist.</translation>
    </message>
    <message>
        <source>the last row of cameraFromPatient must be 0 0 0 1. Check that the matrix is not transposed.</source>
        <comment>pose.last-row</comment>
        <translation>die letzte Zeile von cameraFromPatient muss 0 0 0 1 sein. Prüfen Sie, ob die Matrix transponiert ist.</translation>
    </message>
    <message>
        <source>cameraFromPatient is a reflection (determinant below 0). Represent a mirrored image by the sign of fx, not by the rotation.</source>
        <comment>pose.reflection</comment>
        <translation>cameraFromPatient ist eine Spiegelung (Determinante unter 0). Ein gespiegeltes Bild gehört in das Vorzeichen von fx, nicht in die Drehung.</translation>
    </message>
    <message>
        <source>the upper left 3 × 3 block of cameraFromPatient is not a rotation (it contains scale or shear). Provide a rigid pose in mm.</source>
        <comment>pose.no-rotation</comment>
        <translation>der linke obere 3 × 3-Block von cameraFromPatient ist keine Drehung (Skalierung oder Scherung). Geben Sie eine starre Lage in mm an.</translation>
    </message>
    <message>
        <source>the file is too large for a pose. Choose a .json, .tfm, .mat or .h5 file.</source>
        <comment>pose.too-large</comment>
        <translation>die Datei ist zu groß für eine Lage. Wählen Sie eine .json-, .tfm-, .mat- oder .h5-Datei.</translation>
    </message>
    <message>
        <source>this is not a pose. Choose a .json file, or an ITK .tfm, .mat or .h5 file.</source>
        <comment>pose.unknown</comment>
        <translation>dies ist keine Lage. Wählen Sie eine .json-Datei, oder eine ITK-Datei (.tfm, .mat, .h5).</translation>
    </message>
    <message>
        <source>the pose is not a rigid transform with finite values. Reset it before saving.</source>
        <comment>pose.not-saved</comment>
        <translation>die Lage ist keine starre Transformation mit endlichen Werten. Setzen Sie sie vor dem Speichern zurück.</translation>
    </message>
    <message>
        <source>poses can be saved as .json, .tfm or .h5. Change the extension.</source>
        <comment>pose.extension</comment>
        <translation>Lagen lassen sich als .json, .tfm oder .h5 speichern. Ändern Sie die Endung.</translation>
    </message>
    <message>
        <source>this is not a blind trial log. Choose another name.</source>
        <comment>observer-log.not-one</comment>
        <translation>dies ist kein Protokoll von Blindversuchen. Wählen Sie einen anderen Namen.</translation>
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
        <translation>eine Legacy-VTK-Datei</translation>
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
        <source>The color image was converted to grayscale.</source>
        <comment>image.colour-to-grey</comment>
        <translation>Farbbild in Graustufen umgewandelt.</translation>
    </message>
    <message>
        <source>The transparency of the image is ignored.</source>
        <comment>image.transparency-ignored</comment>
        <translation>Die Transparenz des Bildes wird ignoriert.</translation>
    </message>
    <message>
        <source>A non-DICOM image contains no C-arm geometry. Enter the geometry manually.</source>
        <comment>image.no-geometry</comment>
        <translation>Ein Nicht-DICOM-Bild enthält keine C-Bogen-Geometrie. Tragen Sie sie in der Geometrie des Falls ein.</translation>
    </message>
    <message>
        <source>The image is a binary mask: the vessels are used as drawn.</source>
        <comment>image.is-mask</comment>
        <translation>Das Bild ist eine binäre Maske: Die Gefäße werden übernommen, wie sie gezeichnet sind.</translation>
    </message>
    <message>
        <source>unsupported image format. Choose a DICOM XA run, or a PNG, TIFF or JPEG image.</source>
        <comment>image.unknown</comment>
        <translation>nicht unterstütztes Bildformat. Wählen Sie eine DICOM-XA-Serie, oder ein PNG-, TIFF- oder JPEG-Bild.</translation>
    </message>
    <message>
        <source>this is %1, not an angiogram. Choose a DICOM XA run, or a PNG, TIFF or JPEG image.</source>
        <comment>image.is-other</comment>
        <translation>dies ist %1, kein Angiogramm. Wählen Sie eine DICOM-XA-Serie, oder ein PNG-, TIFF- oder JPEG-Bild.</translation>
    </message>
    <message>
        <source>this gzip archive contains no readable DICOM file. Unpack it and choose the angiogram itself.</source>
        <comment>image.gzip-without-dicom</comment>
        <translation>dieses gzip-Archiv enthält keine lesbare DICOM-Datei. Entpacken Sie es, und wählen Sie das Angiogramm selbst.</translation>
    </message>
    <message>
        <source>the image is damaged or truncated. Copy or export it again.</source>
        <comment>image.damaged</comment>
        <translation>das Bild ist beschädigt oder unvollständig. Kopieren oder exportieren Sie es neu.</translation>
    </message>
    <message>
        <source>the image is damaged or in an unsupported format. Export it as an untiled grayscale or RGB image with 8 or 16 bits per channel.</source>
        <comment>image.unusual</comment>
        <translation>das Bild ist beschädigt oder hat ein nicht unterstütztes Format. Exportieren Sie es in Grau oder RGB mit 8 oder 16 Bit, ohne Kacheln.</translation>
    </message>
    <message>
        <source>the image has fewer than 8 pixels per side, or more than AngioPose supports. Export the angiogram at its original size.</source>
        <comment>image.size</comment>
        <translation>das Bild hat weniger als 8 Pixel je Seite, oder mehr, als AngioPose unterstützt. Exportieren Sie das Angiogramm in Originalgröße.</translation>
    </message>
    <message>
        <source>the frames differ in size. All frames of a run must have the same size.</source>
        <comment>image.frames-differ</comment>
        <translation>die Bilder sind verschieden groß. Alle Bilder einer Serie müssen gleich groß sein.</translation>
    </message>
    <message>
        <source>there is no image to write. Render an image or trace the vessels first.</source>
        <comment>image.no-picture</comment>
        <translation>es gibt kein Bild zu schreiben. Erzeugen Sie zuerst eines.</translation>
    </message>
    <message>
        <source>a pixel value is not a finite number. Correct the image before writing it.</source>
        <comment>image.pixel-not-finite-writing</comment>
        <translation>ein Pixel ist keine endliche Zahl. Berichtigen Sie das Bild vor dem Schreiben.</translation>
    </message>
    <message>
        <source>a pixel value is not a finite number. Export the image again.</source>
        <comment>image.pixel-not-finite</comment>
        <translation>ein Pixel ist keine endliche Zahl. Exportieren Sie das Bild neu.</translation>
    </message>
    <message>
        <source>this is %1, not a 2-D centerline. Choose a CSV table or a PNG mask.</source>
        <comment>centreline.is-other</comment>
        <translation>dies ist %1, keine 2-D-Mittellinie. Wählen Sie eine CSV-Tabelle oder eine PNG-Maske.</translation>
    </message>
    <message>
        <source>this is not a binary mask. Draw the vessels in white on a black background.</source>
        <comment>centreline.no-mask</comment>
        <translation>dies ist keine binäre Maske. Zeichnen Sie die Gefäße weiß auf schwarz.</translation>
    </message>
    <message>
        <source>the header row has no x and y columns. The first line must specify the columns: x,y and, if available, branch,radius (px).</source>
        <comment>centreline.no-columns</comment>
        <translation>in der Kopfzeile fehlen die Spalten x und y. Die erste Zeile muss die Spalten nennen: x,y und, falls vorhanden, branch,radius (px).</translation>
    </message>
    <message>
        <source>the file has a z column, so it is a 3-D centerline. Choose the centerline traced in the image.</source>
        <comment>centreline.is-3d</comment>
        <translation>die Datei hat eine Spalte z, ist also eine 3-D-Mittellinie. Wählen Sie die im Bild erkannte Mittellinie.</translation>
    </message>
    <message>
        <source>the file has more than a million points. Resample the centerline.</source>
        <comment>centreline.too-long</comment>
        <translation>die Datei hat über eine Million Punkte. Tasten Sie die Mittellinie neu ab.</translation>
    </message>
    <message>
        <source>the point in line %1 is far outside any image. Coordinates must be in pixels.</source>
        <comment>centreline.outside</comment>
        <translation>der Punkt in Zeile %1 liegt weit außerhalb jedes Bildes. Koordinaten müssen in Pixeln angegeben sein.</translation>
    </message>
    <message>
        <source>this is not a DICOM file. Choose a scan.</source>
        <comment>dicom.not-one</comment>
        <translation>dies ist keine DICOM-Datei. Wählen Sie einen Scan.</translation>
    </message>
    <message>
        <source>the deflate-compressed data are damaged or truncated. Copy or export the file again.</source>
        <comment>dicom.deflate-damaged</comment>
        <translation>der Deflate-komprimierte Inhalt ist beschädigt oder unvollständig. Kopieren oder exportieren Sie sie neu.</translation>
    </message>
    <message>
        <source>the file contains no readable DICOM element. It is damaged; copy or export it again.</source>
        <comment>dicom.no-element</comment>
        <translation>die Datei enthält kein lesbares DICOM-Element. Sie ist beschädigt; kopieren oder exportieren Sie sie neu.</translation>
    </message>
    <message>
        <source>element %1 declares %2 bytes, but only %3 remain</source>
        <comment>dicom.element-too-long</comment>
        <translation>das Element %1 nennt %2 Bytes, es bleiben aber nur %3</translation>
    </message>
    <message>
        <source>the sequence %1 is not terminated</source>
        <comment>dicom.sequence-without-end</comment>
        <translation>die Sequenz %1 ist nicht abgeschlossen</translation>
    </message>
    <message>
        <source>the file ends within an element</source>
        <comment>dicom.ends-within</comment>
        <translation>die Datei endet innerhalb eines Elements</translation>
    </message>
    <message>
        <source>The end of the file is damaged (%1); the image is complete.</source>
        <comment>dicom.end-damaged</comment>
        <translation>Das Dateiende ist beschädigt (%1); das Bild ist vollständig.</translation>
    </message>
    <message>
        <source>%1 is damaged at a position before the pixel data: %2. Copy or export it again.</source>
        <comment>dicom.damaged-before-pixels</comment>
        <translation>%1 ist vor den Pixeldaten beschädigt: %2. Kopieren oder exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>%1 contains no image. Choose the X-ray angiography run.</source>
        <comment>dicom.holds-no-image</comment>
        <translation>%1 enthält kein Bild. Wählen Sie die Röntgenangiographie-Serie.</translation>
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
        <source>the header contains contradictory values for the bits per pixel. The header is damaged; export the run again.</source>
        <comment>dicom.bits-contradict</comment>
        <translation>die Angaben der Bits je Pixel widersprechen sich. Der Header ist beschädigt; exportieren Sie die Serie neu.</translation>
    </message>
    <message>
        <source>the image is stored in palette color. Export the angiogram in grayscale.</source>
        <comment>dicom.palette-colours</comment>
        <translation>das Bild ist in Palettenfarben gespeichert. Exportieren Sie das Angiogramm in Graustufen.</translation>
    </message>
    <message>
        <source>the pixels (%1, %2 samples per pixel) are neither grayscale nor color. Export the angiogram in grayscale.</source>
        <comment>dicom.not-grey</comment>
        <translation>die Pixel (%1, %2 Werte) sind weder grau noch farbig. Exportieren Sie das Angiogramm in Graustufen.</translation>
    </message>
    <message>
        <source>the pixels have %1 bits. Export the angiogram with 8 or 16 bits per pixel.</source>
        <comment>dicom.pixel-bits</comment>
        <translation>die Pixel haben %1 Bit. Exportieren Sie das Angiogramm mit 8 oder 16 Bit.</translation>
    </message>
    <message>
        <source>the header contains no image size. The file is damaged; export the run again.</source>
        <comment>dicom.no-image-size</comment>
        <translation>der Header nennt keine Bildgröße. Die Datei ist beschädigt; exportieren Sie die Serie neu.</translation>
    </message>
    <message>
        <source>the file declares %1 frames of %2 × %3 pixels, more than AngioPose supports. Export fewer frames.</source>
        <comment>dicom.too-many-frames</comment>
        <translation>die Datei nennt %1 Bilder mit %2 × %3 Pixeln, mehr als AngioPose unterstützt. Exportieren Sie weniger Bilder.</translation>
    </message>
    <message>
        <source>the pixel data are truncated: %1 of %2 bytes are present. Copy or export the file again.</source>
        <comment>dicom.pixels-cut-short</comment>
        <translation>die Pixeldaten sind unvollständig: %1 von %2 Bytes vorhanden. Kopieren oder exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>the compressed pixel data are truncated. Copy or export the file again.</source>
        <comment>dicom.packed-pixels-cut-short</comment>
        <translation>die komprimierten Pixeldaten sind unvollständig. Kopieren oder exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>only %1 of %2 frames are present. Copy or export the file again.</source>
        <comment>dicom.frames-missing</comment>
        <translation>nur %1 von %2 Bildern sind vorhanden. Kopieren oder exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>frame %1 cannot be decoded (transfer syntax %2): it is damaged or truncated, or its compression is not supported. Export the run again, uncompressed if possible.</source>
        <comment>dicom.frame-undecodable</comment>
        <translation>Bild %1 lässt sich nicht dekodieren (Transfersyntax %2): beschädigt, unvollständig oder nicht unterstützte Kompression. Exportieren Sie die Serie neu, möglichst unkomprimiert.</translation>
    </message>
    <message>
        <source>Some frames cannot be decoded and are shown blank: %1 (of %2 frames). Export the run again if you need these frames.</source>
        <comment>dicom.frames-lost</comment>
        <translation>Einige Bilder lassen sich nicht dekodieren und werden leer gezeigt: %1 (von %2 Bildern). Exportieren Sie die Serie neu, wenn Sie diese Bilder brauchen.</translation>
    </message>
    <message>
        <source>Some frames are partly damaged and are shown as far as they could be decoded: %1 (of %2 frames). Check them in another viewer before using them.</source>
        <comment>dicom.frames-flawed</comment>
        <translation>Einige Bilder sind teilweise beschädigt und werden gezeigt, soweit sie sich dekodieren ließen: %1 (von %2 Bildern). Prüfen Sie sie vor dem Gebrauch in einem anderen Betrachter.</translation>
    </message>
    <message>
        <source>The image is partly damaged and is shown as far as it could be decoded. Check it in another viewer before using it.</source>
        <comment>image.flawed</comment>
        <translation>Das Bild ist teilweise beschädigt und wird gezeigt, soweit es sich dekodieren ließ. Prüfen Sie es vor dem Gebrauch in einem anderen Betrachter.</translation>
    </message>
    <message>
        <source>the image has only %1 × %2 pixels. Choose the full-size angiogram.</source>
        <comment>dicom.thumbnail</comment>
        <translation>das Bild hat nur %1 × %2 Pixel. Wählen Sie das Angiogramm in voller Größe.</translation>
    </message>
    <message>
        <source>This is %1, not an X-ray angiogram: it has no C-arm geometry.</source>
        <comment>dicom.not-xray</comment>
        <translation>Dies ist %1, kein Röntgenangiogramm: Es gibt keine C-Bogen-Geometrie.</translation>
    </message>
    <message>
        <source>the DICOM file could not be written. Choose another format.</source>
        <comment>dicom.not-written</comment>
        <translation>die DICOM-Datei ließ sich nicht schreiben. Wählen Sie ein anderes Format.</translation>
    </message>
    <message>
        <source>there are no frames to write. Load or simulate an angiogram first.</source>
        <comment>dicom.no-frames-to-write</comment>
        <translation>es gibt keine Bilder zu schreiben. Laden oder simulieren Sie zuerst ein Angiogramm.</translation>
    </message>
    <message>
        <source>the run is too large for an uncompressed DICOM file. Write fewer frames.</source>
        <comment>dicom.run-too-large</comment>
        <translation>die Serie ist zu groß für eine unkomprimierte DICOM-Datei. Schreiben Sie weniger Bilder.</translation>
    </message>
    <message>
        <source>there is not enough memory to write this run. Write fewer frames.</source>
        <comment>dicom.no-memory-to-write</comment>
        <translation>der Speicher reicht nicht, um diese Serie zu schreiben. Schreiben Sie weniger Bilder.</translation>
    </message>
    <message>
        <source>an image of modality %1</source>
        <comment>dicom.modality</comment>
        <translation>ein Bild der Modalität %1</translation>
    </message>
    <message>
        <source>an image without a specified modality</source>
        <comment>dicom.no-modality</comment>
        <translation>ein Bild ohne Modalität</translation>
    </message>
    <message>
        <source>The header contains no imager pixel spacing: %1 was derived from the calibrated pixel spacing. Check it in the geometry.</source>
        <comment>dicom.spacing-from-calibration</comment>
        <translation>Der Header enthält kein Imager Pixel Spacing: %1 wurde aus der kalibrierten Pixelgröße abgeleitet. Prüfen Sie es in der Geometrie.</translation>
    </message>
    <message>
        <source>The header contains no imager pixel spacing (0018,1164): %1 was derived from the field of view. Check it in the geometry.</source>
        <comment>dicom.spacing-from-field</comment>
        <translation>Der Header enthält kein Imager Pixel Spacing (0018,1164): %1 wurde aus dem Bildfeld abgeleitet. Prüfen Sie es in der Geometrie.</translation>
    </message>
    <message>
        <source>The header contains no imager pixel spacing (0018,1164): enter it in the geometry.</source>
        <comment>dicom.spacing-missing</comment>
        <translation>Der Header enthält kein Imager Pixel Spacing (0018,1164): Tragen Sie es in der Geometrie ein.</translation>
    </message>
    <message>
        <source>The header contains no imager pixel spacing (0018,1164): enter it in the geometry. An image intensifier of %1 suggests at most %2.</source>
        <comment>dicom.spacing-missing-intensifier</comment>
        <translation>Der Header enthält kein Imager Pixel Spacing (0018,1164): Tragen Sie es in der Geometrie ein. Der Bildverstärker von %1 legt höchstens %2 nahe.</translation>
    </message>
    <message>
        <source>The header contains only isocenter angles (0018,9463), whose signs are ambiguous. Enter the LAO/RAO and CRA/CAU angles in the geometry.</source>
        <comment>dicom.angles-of-isocentre</comment>
        <translation>Der Header enthält nur Isozentrumswinkel (0018,9463), deren Vorzeichen mehrdeutig sind: Tragen Sie LAO/RAO und CRA/CAU in der Geometrie ein.</translation>
    </message>
    <message>
        <source>The detector is tilted by %1 (0018,1530): the principal point is uncertain.</source>
        <comment>dicom.detector-tilted</comment>
        <translation>Der Detektor ist um %1 gekippt (0018,1530): der Hauptpunkt ist unsicher.</translation>
    </message>
    <message>
        <source>Based on %1, the image is assumed to be mirrored. Check the orientation markers (L, R).</source>
        <comment>dicom.image-mirrored</comment>
        <translation>Auf Grundlage von %1 gilt das Bild als gespiegelt. Prüfen Sie die Orientierungsmarkierungen (L, R).</translation>
    </message>
    <message>
        <source>The C-arm moved during this run, but the header does not specify the angles of all %2 frames (specified: %1). The angles of the first frame are used. Check them for the selected frame.</source>
        <comment>dicom.gantry-moved</comment>
        <translation>Der C-Bogen hat sich während der Serie bewegt, der Header gibt aber nicht die Winkel aller %2 Bilder an (angegeben: %1). Es werden die Winkel des ersten Bildes verwendet. Prüfen Sie sie für das ausgewählte Bild.</translation>
    </message>
    <message>
        <source>none</source>
        <comment>dicom.gantry-no-angles</comment>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1</source>
        <comment>dicom.gantry-angles</comment>
        <translation>%1</translation>
    </message>
    <message>
        <source>The traced structure is hardly longer than it is wide: check that it is a vessel.</source>
        <comment>vessels.compact</comment>
        <translation>Die erfasste Struktur ist kaum länger als breit: Prüfen Sie, ob es ein Gefäß ist.</translation>
    </message>
    <message>
        <source>The extent (%1) or the diameter of the vessels is unusual: if the unit of the file is not the millimeter, specify the unit.</source>
        <comment>vessels.unusual-size</comment>
        <translation>Die Ausdehnung (%1) oder der Durchmesser der Gefäße ist ungewöhnlich: Ist die Einheit der Datei nicht Millimeter, geben Sie die Einheit an.</translation>
    </message>
    <message>
        <source>unsupported surface format. Choose a .vtp, .vtk, .stl, .ply or .obj file.</source>
        <comment>surface.unknown</comment>
        <translation>nicht unterstütztes Oberflächenformat. Wählen Sie eine .vtp-, .vtk-, .stl-, .ply- oder .obj-Datei.</translation>
    </message>
    <message>
        <source>this is %1, not a surface. Choose a .vtp, .vtk, .stl, .ply or .obj file.</source>
        <comment>surface.is-other</comment>
        <translation>dies ist %1, keine Oberfläche. Wählen Sie eine .vtp-, .vtk-, .stl-, .ply- oder .obj-Datei.</translation>
    </message>
    <message>
        <source>the file contains no triangles. Choose the surface of a vessel.</source>
        <comment>surface.no-triangles</comment>
        <translation>die Datei enthält keine Dreiecke. Wählen Sie die Oberfläche eines Gefäßes.</translation>
    </message>
    <message>
        <source>all triangles have zero area. Choose the surface of a vessel.</source>
        <comment>surface.no-area</comment>
        <translation>alle Dreiecke haben die Fläche null. Wählen Sie die Oberfläche eines Gefäßes.</translation>
    </message>
    <message>
        <source>the surface has more triangles than AngioPose supports. Decimate the surface.</source>
        <comment>surface.too-large</comment>
        <translation>die Oberfläche hat mehr Dreiecke, als AngioPose unterstützt. Vereinfachen Sie sie.</translation>
    </message>
    <message>
        <source>a coordinate is not a number or exceeds one kilometer. Correct the coordinate, or export the surface again.</source>
        <comment>surface.coordinate</comment>
        <translation>eine Koordinate ist keine Zahl oder größer als ein Kilometer. Berichtigen Sie sie, oder exportieren Sie die Oberfläche neu.</translation>
    </message>
    <message>
        <source>a triangle refers to a point that does not exist. The file is damaged; export it again.</source>
        <comment>surface.bad-index</comment>
        <translation>ein Dreieck verweist auf einen Punkt, den es nicht gibt. Die Datei ist beschädigt; exportieren Sie sie neu.</translation>
    </message>
    <message>
        <source>the triangles are damaged or truncated. Copy or export the file again.</source>
        <comment>surface.cut-short</comment>
        <translation>die Dreiecke sind beschädigt oder unvollständig. Kopieren oder exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>surfaces can be saved as .stl. Change the extension.</source>
        <comment>surface.extension</comment>
        <translation>Oberflächen lassen sich als .stl speichern. Ändern Sie die Endung.</translation>
    </message>
    <message>
        <source>The surface is not closed (%1 open and %2 non-manifold edges): its interior is determined by majority vote. Check the result, or close the holes.</source>
        <comment>surface.open</comment>
        <translation>Die Oberfläche ist nicht geschlossen (%1 offene und %2 mehrfache Kanten): Ihr Inneres wird durch Mehrheitsentscheid bestimmt. Prüfen Sie das Ergebnis, oder schließen Sie die Löcher.</translation>
    </message>
    <message>
        <source>The triangles are inconsistently oriented, so overlapping parts may cancel each other out.</source>
        <comment>surface.disoriented</comment>
        <translation>Die Dreiecke sind uneinheitlich orientiert; überlappende Teile können sich aufheben.</translation>
    </message>
    <message>
        <source>The surface measures %1 across, which is unusual: if its unit is not the millimeter, specify the unit.</source>
        <comment>surface.unusual-size</comment>
        <translation>Die Oberfläche misst insgesamt %1, was ungewöhnlich ist: Ist ihre Einheit nicht Millimeter, geben Sie die Einheit an.</translation>
    </message>
    <message>
        <source>Outlier points (%1) were removed together with their triangles because they are not finite or lie farther than %2 from the center. Check the surface.</source>
        <comment>surface.stray-points</comment>
        <translation>Ausreißerpunkte (%1) wurden mit ihren Dreiecken entfernt, da sie nicht endlich sind oder mehr als %2 von der Mitte entfernt liegen. Prüfen Sie die Oberfläche.</translation>
    </message>
    <message>
        <source>the surface measures %1 across, which is larger than any human body. Specify the unit of the file, or remove outlier points.</source>
        <comment>surface.larger-than-body</comment>
        <translation>die Oberfläche misst insgesamt %1, mehr als jeder Körper. Geben Sie die Einheit der Datei an, oder entfernen Sie Ausreißerpunkte.</translation>
    </message>
    <message>
        <source>line %1 does not define a valid point. The file is damaged; export it again.</source>
        <comment>surface.obj-bad-point</comment>
        <translation>Zeile %1 ist kein gültiger Punkt. Die Datei ist beschädigt; exportieren Sie sie neu.</translation>
    </message>
    <message>
        <source>the PLY header is damaged or truncated. Export the file again.</source>
        <comment>surface.ply-header-damaged</comment>
        <translation>der PLY-Header ist beschädigt oder unvollständig. Exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>the PLY header is damaged: the element &quot;%1&quot; has no properties. Export the file again.</source>
        <comment>surface.ply-element-empty</comment>
        <translation>der PLY-Header ist beschädigt: Das Element „%1“ hat keine Eigenschaften. Exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>the PLY data are damaged or truncated, or a face has more than 255 vertices. Export the file again, as triangles.</source>
        <comment>surface.ply-data-damaged</comment>
        <translation>die PLY-Daten sind beschädigt oder unvollständig, oder eine Fläche hat mehr als 255 Ecken. Exportieren Sie die Datei neu, als Dreiecke.</translation>
    </message>
    <message>
        <source>this is %1, not a centerline. Choose a centerline file: .vtp, .vtk, .vtu, .csv, .swc or .mrk.json.</source>
        <comment>tree.is-other</comment>
        <translation>dies ist %1, keine Mittellinie. Wählen Sie eine Mittelliniendatei: .vtp, .vtk, .vtu, .csv, .swc oder .mrk.json.</translation>
    </message>
    <message>
        <source>unsupported centerline format. Choose a centerline file: .vtp, .vtk, .vtu, .csv, .swc or .mrk.json.</source>
        <comment>tree.format-unknown</comment>
        <translation>nicht unterstütztes Mittellinienformat. Wählen Sie eine Mittelliniendatei: .vtp, .vtk, .vtu, .csv, .swc oder .mrk.json.</translation>
    </message>
    <message>
        <source>the file does not start with a VTK header. Export the centerlines again.</source>
        <comment>tree.no-vtk-beginning</comment>
        <translation>die Datei beginnt nicht mit einem VTK-Header. Exportieren Sie die Mittellinien neu.</translation>
    </message>
    <message>
        <source>vessel trees can be saved as .vtp, .csv, .swc or .mrk.json. Change the extension.</source>
        <comment>tree.extension</comment>
        <translation>Gefäßbäume lassen sich als .vtp, .csv, .swc oder .mrk.json speichern. Ändern Sie die Endung.</translation>
    </message>
    <message>
        <source>the file has %1 points; a centerline tree may have at most %2. Resample the centerlines.</source>
        <comment>tree.too-many-points</comment>
        <translation>die Datei hat %1 Punkte; ein Gefäßbaum darf höchstens %2 haben. Tasten Sie die Mittellinien neu ab.</translation>
    </message>
    <message>
        <source>the file has %1 separate lines; a centerline tree may have at most %2. Keep only the vessels of interest.</source>
        <comment>tree.too-many-lines</comment>
        <translation>die Datei hat %1 getrennte Linien; ein Gefäßbaum darf höchstens %2 haben. Behalten Sie nur die relevanten Gefäße.</translation>
    </message>
    <message>
        <source>the file contains no lines. Choose a file with vessel centerlines.</source>
        <comment>tree.no-lines</comment>
        <translation>die Datei enthält keine Linien. Wählen Sie eine Datei mit Gefäßmittellinien.</translation>
    </message>
    <message>
        <source>the file contains a surface, not centerlines. Extract the centerlines first (e.g., with VMTK or 3D Slicer), and open them instead.</source>
        <comment>tree.is-surface</comment>
        <translation>die Datei enthält eine Oberfläche, keine Mittellinien. Extrahieren Sie zuerst die Mittellinien (z. B. mit VMTK oder Slicer), und öffnen Sie diese.</translation>
    </message>
    <message>
        <source>a line refers to a point that does not exist. The file is damaged; export it again.</source>
        <comment>tree.bad-index</comment>
        <translation>eine Linie verweist auf einen Punkt, den es nicht gibt. Die Datei ist beschädigt; exportieren Sie sie neu.</translation>
    </message>
    <message>
        <source>the lines pass through the same points too often. The file is damaged; export it again.</source>
        <comment>tree.points-repeated</comment>
        <translation>die Linien durchlaufen dieselben Punkte zu oft. Die Datei ist beschädigt; exportieren Sie sie neu.</translation>
    </message>
    <message>
        <source>no line has two distinct points. Choose a file with vessel centerlines.</source>
        <comment>tree.no-length</comment>
        <translation>keine der Linien hat zwei verschiedene Punkte. Wählen Sie eine Datei mit Gefäßmittellinien.</translation>
    </message>
    <message>
        <source>the third line of a legacy VTK file must be ASCII or BINARY. Export the file again.</source>
        <comment>tree.vtk-third-line</comment>
        <translation>die dritte Zeile einer Legacy-VTK-Datei muss ASCII oder BINARY sein. Exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>the file contains no POLYDATA or UNSTRUCTURED_GRID data set. Export the centerlines as polylines.</source>
        <comment>tree.vtk-no-data-set</comment>
        <translation>die Datei enthält keinen Datensatz POLYDATA oder UNSTRUCTURED_GRID. Exportieren Sie die Mittellinien als Polylinien.</translation>
    </message>
    <message>
        <source>the file contains %1, not POLYDATA or UNSTRUCTURED_GRID. Export the centerlines as polylines.</source>
        <comment>tree.vtk-other-data-set</comment>
        <translation>die Datei enthält %1, nicht POLYDATA oder UNSTRUCTURED_GRID. Exportieren Sie die Mittellinien als Polylinien.</translation>
    </message>
    <message>
        <source>the section &quot;%1&quot; is damaged or truncated. Export the file again.</source>
        <comment>tree.vtk-section-damaged</comment>
        <translation>der Abschnitt „%1“ ist beschädigt oder unvollständig. Exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>the VTK XML data are damaged or truncated. Export the file again.</source>
        <comment>tree.vtk-xml-damaged</comment>
        <translation>die VTK-XML-Daten sind beschädigt oder unvollständig. Exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>the file contains neither VTK XML PolyData nor UnstructuredGrid. Export the centerlines as .vtp.</source>
        <comment>tree.vtk-xml-other</comment>
        <translation>die Datei enthält weder VTK-XML-PolyData noch UnstructuredGrid. Exportieren Sie die Mittellinien als .vtp.</translation>
    </message>
    <message>
        <source>the file declares %1, which is impossible. It is damaged; export it again.</source>
        <comment>tree.vtk-xml-impossible-count</comment>
        <translation>die Datei nennt %1, was unmöglich ist. Sie ist beschädigt; exportieren Sie sie neu.</translation>
    </message>
    <message>
        <source>this is not a 3D Slicer markups file with curves. Export the centerlines as .mrk.json curves, .vtp, .vtk, .csv or .swc.</source>
        <comment>tree.markups-none</comment>
        <translation>dies ist keine Slicer-Markups-Datei mit Kurven. Exportieren Sie die Mittellinien als .mrk.json-Kurven, .vtp, .vtk, .csv oder .swc.</translation>
    </message>
    <message>
        <source>line %1 does not have the form `id type x y z radius parent`. Correct the line, or export the file again.</source>
        <comment>tree.swc-line</comment>
        <translation>Zeile %1 hat nicht die Form `id type x y z radius parent`. Berichtigen Sie sie, oder exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>line %1 repeats an ID. IDs must be unique.</source>
        <comment>tree.swc-id-twice</comment>
        <translation>Zeile %1 wiederholt eine ID. Jede ID muss eindeutig sein.</translation>
    </message>
    <message>
        <source>line %1 refers to parent %2, which does not exist. Export the whole tree.</source>
        <comment>tree.swc-parent-missing</comment>
        <translation>Zeile %1 verweist auf den Elternknoten %2, der fehlt. Exportieren Sie den ganzen Baum.</translation>
    </message>
    <message>
        <source>the first line must specify the columns: x,y,z and, if available, radius,branch.</source>
        <comment>tree.table-no-header</comment>
        <translation>die erste Zeile muss die Spalten nennen: x,y,z und, falls vorhanden, radius,branch.</translation>
    </message>
    <message>
        <source>the header row has no x, y and z columns. Name the columns accordingly (coordinates in mm, LPS).</source>
        <comment>tree.table-no-columns</comment>
        <translation>der Kopfzeile fehlen die Spalten x, y und z. Benennen Sie die Spalten entsprechend (mm, Patient LPS).</translation>
    </message>
    <message>
        <source>the file appears to be a list of graph nodes (it has an id column) without an order along the vessels. Add a branch column, or export the centerlines themselves.</source>
        <comment>tree.table-is-graph</comment>
        <translation>die Datei scheint eine Liste von Graphknoten (Spalte id) ohne Reihenfolge entlang der Gefäße zu sein. Fügen Sie eine Spalte branch hinzu, oder exportieren Sie die Mittellinien selbst.</translation>
    </message>
    <message>
        <source>this folder contains no DICOM image. Choose the folder of a DICOM scan, or a volume file.</source>
        <comment>series.none</comment>
        <translation>dieser Ordner enthält kein DICOM-Bild. Wählen Sie den Ordner eines DICOM-Scans, oder eine Volumendatei.</translation>
    </message>
    <message>
        <source>this DICOM file contains no image. Choose a scan.</source>
        <comment>series.file-without-image</comment>
        <translation>diese DICOM-Datei enthält kein Bild. Wählen Sie einen Scan.</translation>
    </message>
    <message>
        <source>the series %1 is not in this folder. Choose the folder that contains it.</source>
        <comment>series.not-here</comment>
        <translation>die Serie %1 ist nicht in diesem Ordner. Wählen Sie den Ordner, der sie enthält.</translation>
    </message>
    <message>
        <source>the series of the case is not in this folder. Choose the folder that contains it.</source>
        <comment>series.of-case-not-here</comment>
        <translation>die Serie des Falls ist nicht in diesem Ordner. Wählen Sie den Ordner, der sie enthält.</translation>
    </message>
    <message>
        <source>no series in this folder forms a volume. Choose another folder.</source>
        <comment>series.none-makes-volume</comment>
        <translation>keine Serie in diesem Ordner bildet ein Volumen. Wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>the input contains %1 volumes (%2). Choose one of them by its series ID; `info` lists the IDs.</source>
        <comment>series.several</comment>
        <translation>die Eingabe enthält %1 Volumen (%2). Wählen Sie eines über seine Serien-ID; `info` listet sie auf.</translation>
    </message>
    <message>
        <source>this is an X-ray run, not a volume. Open it as the angiogram.</source>
        <comment>series.is-xray</comment>
        <translation>dies ist eine Röntgenserie, kein Volumen. Öffnen Sie sie als Angiogramm.</translation>
    </message>
    <message>
        <source>this is a DICOM segmentation. Export it as a NIfTI or NRRD label image.</source>
        <comment>series.is-segmentation</comment>
        <translation>dies ist eine DICOM-Segmentierung. Exportieren Sie sie als NIfTI- oder NRRD-Labelbild.</translation>
    </message>
    <message>
        <source>this is a single slice, not a volume. Copy all slices of the series, or choose another series.</source>
        <comment>series.single-slice</comment>
        <translation>dies ist eine einzelne Schicht, kein Volumen. Kopieren Sie alle Schichten der Serie, oder wählen Sie eine andere Serie.</translation>
    </message>
    <message>
        <source>the images specify no pixel size, so they do not form a volume. Choose another series.</source>
        <comment>series.no-pixel-size</comment>
        <translation>die Bilder enthalten keine Pixelgröße und bilden daher kein Volumen. Wählen Sie eine andere Serie.</translation>
    </message>
    <message>
        <source>the images specify no position in the patient, so they do not form a volume. Choose another series.</source>
        <comment>series.no-place</comment>
        <translation>die Bilder enthalten keine Position im Patienten und bilden daher kein Volumen. Wählen Sie eine andere Serie.</translation>
    </message>
    <message>
        <source>the slices lie side by side instead of being stacked. Choose another series.</source>
        <comment>series.beside-each-other</comment>
        <translation>die Schichten liegen nebeneinander statt übereinander. Wählen Sie eine andere Serie.</translation>
    </message>
    <message>
        <source>the slice spacing is too uneven for a volume (%1 slices over %2). Copy all slices of the series, or choose another series.</source>
        <comment>series.too-uneven</comment>
        <translation>der Schichtabstand ist für ein Volumen zu ungleichmäßig (%1 Schichten auf %2). Kopieren Sie alle Schichten der Serie, oder wählen Sie eine andere Serie.</translation>
    </message>
    <message>
        <source>this is a color image. Choose the grayscale scan itself.</source>
        <comment>series.colour</comment>
        <translation>dies ist ein Farbbild. Wählen Sie den Scan selbst in Grauwerten.</translation>
    </message>
    <message>
        <source>the image size does not match the header. Export the series again.</source>
        <comment>series.slice-size</comment>
        <translation>die Bildgröße entspricht nicht dem Header. Exportieren Sie die Serie neu.</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced (%1 to %2) and were resampled to a spacing of %3.</source>
        <comment>series.uneven-slices</comment>
        <translation>Die Schichten haben ungleiche Abstände (%1 bis %2): auf %3 neu abgetastet.</translation>
    </message>
    <message>
        <source>The slices are not stacked perpendicularly (deviation of %1, as with a tilted gantry): they were shifted in plane to their true positions.</source>
        <comment>series.slanted</comment>
        <translation>Die Schichten sind nicht senkrecht gestapelt (%1 Abweichung, wie bei geneigter Gantry): Sie wurden in ihrer Ebene an ihre tatsächliche Position verschoben.</translation>
    </message>
    <message>
        <source>1 of %1 slices is missing (%2) and was interpolated from its neighbors. Copy the series again if possible.</source>
        <comment>series.slice-missing</comment>
        <translation>1 von %1 Schichten fehlt (%2): zwischen den Nachbarn interpoliert. Kopieren Sie die Serie wenn möglich neu.</translation>
    </message>
    <message>
        <source>%1 of %2 slices are missing (%3) and were interpolated from their neighbors. Copy the series again if possible.</source>
        <comment>series.slices-missing</comment>
        <translation>%1 von %2 Schichten fehlen (%3): zwischen den Nachbarn interpoliert. Kopieren Sie die Serie wenn möglich neu.</translation>
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
        <source>%1 of %2 slices have the same position as another slice; only the slice acquired first at each position is used.</source>
        <comment>series.overlap</comment>
        <translation>%1 von %2 Schichten haben dieselbe Position wie eine andere; verwendet wird je Position nur die zuerst aufgenommene.</translation>
    </message>
    <message>
        <source>Duplicate files of the series are ignored (number: %1).</source>
        <comment>series.files-twice</comment>
        <translation>Doppelte Dateien der Serie werden ignoriert (Anzahl: %1).</translation>
    </message>
    <message>
        <source>Some files of the series are damaged at the end (number: %1).</source>
        <comment>series.files-damaged</comment>
        <translation>%1 Dateien der Serie sind am Ende beschädigt.</translation>
    </message>
    <message>
        <source>The series contains images of %1 different sizes or orientations; each is listed separately.</source>
        <comment>series.mixed</comment>
        <translation>Die Serie enthält Bilder in %1 verschiedenen Größen oder Ausrichtungen; jede ist einzeln aufgeführt.</translation>
    </message>
    <message>
        <source>part %1 of %2</source>
        <comment>series.part</comment>
        <translation>Teil %1 von %2</translation>
    </message>
    <message>
        <source>The slices are stored with different rescale factors or as floating-point values. %1</source>
        <comment>series.scales</comment>
        <translation>Die Schichten sind unterschiedlich skaliert oder als Gleitkommazahlen gespeichert. %1</translation>
    </message>
    <message>
        <source>unsupported volume format. Choose a DICOM folder, NIfTI, NRRD or MetaImage (.mha, .mhd).</source>
        <comment>volume.unknown</comment>
        <translation>nicht unterstütztes Volumenformat. Wählen Sie einen DICOM-Ordner, NIfTI, NRRD oder MetaImage (.mha, .mhd).</translation>
    </message>
    <message>
        <source>this is %1, not a volume. Choose a DICOM folder, NIfTI, NRRD or MetaImage (.mha, .mhd).</source>
        <comment>volume.is-other</comment>
        <translation>dies ist %1, kein Volumen. Wählen Sie einen DICOM-Ordner, NIfTI, NRRD oder MetaImage (.mha, .mhd).</translation>
    </message>
    <message>
        <source>the file contains an object of type %1, not an image. Choose the scan.</source>
        <comment>volume.holds-other</comment>
        <translation>die Datei enthält ein Objekt vom Typ %1, kein Bild. Wählen Sie den Scan.</translation>
    </message>
    <message>
        <source>the file declares %1, more than AngioPose supports. Crop the scan to the vessels.</source>
        <comment>volume.declares</comment>
        <translation>die Datei nennt %1, mehr als AngioPose unterstützt. Schneiden Sie den Scan auf die Gefäße zu.</translation>
    </message>
    <message>
        <source>the volume exceeds the memory of this computer. Crop the scan to the vessels.</source>
        <comment>volume.larger-than-memory</comment>
        <translation>das Volumen übersteigt den Speicher dieses Rechners. Schneiden Sie den Scan auf die Gefäße zu.</translation>
    </message>
    <message>
        <source>the file has %1: a single slice is not a volume. Choose the whole scan.</source>
        <comment>volume.single-slice</comment>
        <translation>die Datei hat %1: Eine einzelne Schicht ist kein Volumen. Wählen Sie den ganzen Scan.</translation>
    </message>
    <message>
        <source>the file is %1-dimensional, but a volume has three dimensions. Choose the whole scan.</source>
        <comment>volume.not-three-dimensional</comment>
        <translation>die Datei ist %1-dimensional, ein Volumen hat aber drei Dimensionen. Wählen Sie den ganzen Scan.</translation>
    </message>
    <message>
        <source>the file has %1 dimensions, but a volume has three. Save the volume you need as a separate file, and open that file.</source>
        <comment>volume.dimensions</comment>
        <translation>die Datei hat %1 Dimensionen, ein Volumen hat aber drei. Speichern Sie das benötigte Volumen als eigene Datei und öffnen Sie diese.</translation>
    </message>
    <message>
        <source>the file contains %1 volumes or values per voxel (4-D). Extract the volume you need, and open it.</source>
        <comment>volume.several-4d</comment>
        <translation>die Datei enthält %1 Volumen oder Werte je Voxel (4-D). Extrahieren Sie das benötigte Volumen, und öffnen Sie es.</translation>
    </message>
    <message>
        <source>the file contains %1 volumes, layers or values per voxel (4-D). Save the volume you need as a separate file, and open that file.</source>
        <comment>volume.several-layers</comment>
        <translation>die Datei enthält %1 Volumen, Ebenen oder Werte je Voxel (4-D). Speichern Sie das benötigte Volumen als eigene Datei, und öffnen Sie diese.</translation>
    </message>
    <message>
        <source>the file has %1 values per voxel. Choose the grayscale scan itself.</source>
        <comment>volume.channels</comment>
        <translation>die Datei hat %1 Werte je Voxel. Wählen Sie den Scan selbst in Grauwerten.</translation>
    </message>
    <message>
        <source>the first axis has %1 entries, so the file is a color image, not a volume. Choose the scan.</source>
        <comment>volume.colour-axis</comment>
        <translation>die erste Achse hat %1 Einträge; es ist also ein Farbbild, kein Volumen. Wählen Sie den Scan.</translation>
    </message>
    <message>
        <source>the voxel values are colors. Choose the grayscale scan itself.</source>
        <comment>volume.colours</comment>
        <translation>die Voxel sind Farben. Wählen Sie den Scan selbst in Grauwerten.</translation>
    </message>
    <message>
        <source>the header declares %1. The file is damaged; export it again.</source>
        <comment>volume.header-gives</comment>
        <translation>der Header nennt %1. Die Datei ist beschädigt; exportieren Sie sie neu.</translation>
    </message>
    <message>
        <source>the header contains no usable voxel size or position. Export the volume again.</source>
        <comment>volume.no-place</comment>
        <translation>der Header enthält keine brauchbare Voxelgröße oder Position. Exportieren Sie das Volumen neu.</translation>
    </message>
    <message>
        <source>the header is damaged: it declares %1 dimensions. Export the file again.</source>
        <comment>volume.header-dimensions</comment>
        <translation>der Header ist beschädigt: Er nennt %1 Dimensionen. Exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>the header is damaged: the voxel data offset is invalid. Export the file again.</source>
        <comment>volume.impossible-start</comment>
        <translation>der Header ist beschädigt: Der Offset der Voxeldaten ist ungültig. Exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>the angle between the axes is %1 instead of 90°. Resample the volume to orthogonal axes.</source>
        <comment>volume.skewed</comment>
        <translation>die Achsen stehen %1 statt 90° zueinander. Tasten Sie das Volumen auf orthogonale Achsen neu ab.</translation>
    </message>
    <message>
        <source>the header cannot be read (%1). Export the file again.</source>
        <comment>volume.header-not-read</comment>
        <translation>der Header ist nicht lesbar (%1). Exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>the %1 header cannot be read. Export the file again.</source>
        <comment>volume.format-header-not-read</comment>
        <translation>der %1-Header ist nicht lesbar. Exportieren Sie die Datei neu.</translation>
    </message>
    <message>
        <source>HeaderSize is invalid. Correct the header.</source>
        <comment>volume.header-size</comment>
        <translation>die HeaderSize ist ungültig. Berichtigen Sie den Header.</translation>
    </message>
    <message>
        <source>the header does not specify the voxel data file (ElementDataFile). Export the volume again.</source>
        <comment>volume.no-data-file</comment>
        <translation>der Header nennt die Datei mit den Voxeldaten nicht (ElementDataFile). Exportieren Sie das Volumen neu.</translation>
    </message>
    <message>
        <source>the line skip or byte skip is invalid. Correct the header.</source>
        <comment>volume.skips</comment>
        <translation>line skip oder byte skip ist ungültig. Berichtigen Sie den Header.</translation>
    </message>
    <message>
        <source>the header skips lines in a separate data file. Save the header and the voxels as one file.</source>
        <comment>volume.skips-lines-elsewhere</comment>
        <translation>der Header überspringt Zeilen in einer separaten Datendatei. Speichern Sie Header und Voxel als eine Datei.</translation>
    </message>
    <message>
        <source>the voxel data are split across several files. Save the volume as one file.</source>
        <comment>volume.several-files</comment>
        <translation>die Voxel sind auf mehrere Dateien verteilt. Speichern Sie es als eine Datei.</translation>
    </message>
    <message>
        <source>the voxel type &quot;%1&quot; is not supported. Save the volume with 16-bit integer or floating-point voxels.</source>
        <comment>volume.voxel-type</comment>
        <translation>der Voxeltyp „%1“ wird nicht unterstützt. Speichern Sie es als 16 Bit oder float.</translation>
    </message>
    <message>
        <source>the voxel type (NIfTI datatype %1) is not supported. Save the volume with 16-bit integer or floating-point voxels.</source>
        <comment>volume.nifti-type</comment>
        <translation>der Voxeltyp (NIfTI-Datentyp %1) wird nicht unterstützt. Speichern Sie es als 16 Bit oder float.</translation>
    </message>
    <message>
        <source>the voxel type is not supported. Save the volume with 16-bit integer or floating-point voxels.</source>
        <comment>volume.other-voxel-type</comment>
        <translation>der Voxeltyp wird nicht unterstützt. Speichern Sie es als 16 Bit oder float.</translation>
    </message>
    <message>
        <source>the voxels are compressed with bzip2. Save the volume with gzip or raw encoding.</source>
        <comment>volume.bzip2</comment>
        <translation>die Voxel sind mit bzip2 komprimiert. Speichern Sie es mit gzip- oder raw-Kodierung.</translation>
    </message>
    <message>
        <source>the voxels are stored as text (%1). Save the volume with gzip or raw encoding.</source>
        <comment>volume.text-encoding</comment>
        <translation>die Voxel sind als Text gespeichert (%1). Speichern Sie es mit gzip- oder raw-Kodierung.</translation>
    </message>
    <message>
        <source>the voxels are stored as text. Save the volume in binary form.</source>
        <comment>volume.text</comment>
        <translation>die Voxel sind als Text gespeichert. Speichern Sie es mit binären Daten.</translation>
    </message>
    <message>
        <source>the voxel data are truncated, or their compression is damaged. Copy or export the volume again.</source>
        <comment>volume.packing-damaged</comment>
        <translation>die Voxeldaten sind unvollständig, oder ihre Kompression ist beschädigt. Kopieren oder exportieren Sie es neu.</translation>
    </message>
    <message>
        <source>the voxel data are truncated or damaged. Copy or export the volume again.</source>
        <comment>volume.voxels-damaged</comment>
        <translation>die Voxeldaten sind unvollständig oder beschädigt. Kopieren oder exportieren Sie es neu.</translation>
    </message>
    <message>
        <source>the voxel data are truncated. Copy or export the volume again.</source>
        <comment>volume.cut-short</comment>
        <translation>die Voxeldaten sind unvollständig. Kopieren oder exportieren Sie es neu.</translation>
    </message>
    <message>
        <source>the voxel data are truncated: %1 of %2 bytes are present. Copy or export the volume again.</source>
        <comment>volume.cut-short-by</comment>
        <translation>die Voxeldaten sind unvollständig: %1 von %2 Bytes vorhanden. Kopieren oder exportieren Sie es neu.</translation>
    </message>
    <message>
        <source>the voxel data file %1 is missing. Copy both files together.</source>
        <comment>volume.voxels-not-there</comment>
        <translation>die Datei %1 mit den Voxeldaten fehlt. Kopieren Sie beide Dateien zusammen.</translation>
    </message>
    <message>
        <source>the voxel data file cannot be read (%1).</source>
        <comment>volume.voxel-file-not-read</comment>
        <translation>die Datei mit den Voxeln lässt sich nicht lesen (%1).</translation>
    </message>
    <message>
        <source>the voxel data start with the header of another volume. Open that file itself, or set the number of bytes to skip (-1 if the voxels are at the end).</source>
        <comment>volume.voxels-are-header</comment>
        <translation>die Voxeldaten beginnen mit dem Header eines anderen Volumens. Öffnen Sie jene Datei selbst, oder geben Sie die Zahl der zu überspringenden Bytes an: -1, wenn die Voxel am Ende stehen.</translation>
    </message>
    <message>
        <source>the volume contains no finite voxel values. Export it again.</source>
        <comment>volume.no-numbers</comment>
        <translation>das Volumen enthält keine endlichen Voxelwerte. Exportieren Sie es neu.</translation>
    </message>
    <message>
        <source>Some voxel values are not numbers (%1 voxels); they are set to the lowest value.</source>
        <comment>volume.not-numbers</comment>
        <translation>%1 Voxel sind keine Zahlen; sie werden auf den kleinsten Wert gesetzt.</translation>
    </message>
    <message>
        <source>The %1 voxels are rounded to 16 bits, in steps of %2.</source>
        <comment>volume.rounded</comment>
        <translation>Die %1-Voxel werden auf 16 Bit gerundet, in Schritten von %2.</translation>
    </message>
    <message>
        <source>The header does not specify the orientation of the axes: i toward the left, j posterior and k superior are assumed. Check left and right.</source>
        <comment>volume.axes-assumed</comment>
        <translation>Der Header nennt die Ausrichtung der Achsen nicht: i nach links, j nach hinten und k zum Kopf werden angenommen. Prüfen Sie links und rechts.</translation>
    </message>
    <message>
        <source>The header does not specify the orientation of the voxels: +x (right to left), +y (anterior to posterior) and +z (superior) are assumed to correspond to i, reversed j and k. Check left and right.</source>
        <comment>volume.voxels-assumed</comment>
        <translation>Der Header nennt die Ausrichtung der Voxel nicht: +x (rechts nach links), +y (vorn nach hinten) und +z (aufwärts) werden als i, umgekehrtes j und k angenommen. Prüfen Sie links und rechts.</translation>
    </message>
    <message>
        <source>The header contains no voxel size: 1 × 1 × 1 mm is assumed.</source>
        <comment>volume.size-assumed</comment>
        <translation>Der Header enthält keine Voxelgröße: 1 × 1 × 1 mm wird angenommen.</translation>
    </message>
    <message>
        <source>The voxel size is specified as 1 × 1 × 1 mm: check that the true size was not lost in a conversion.</source>
        <comment>volume.size-of-one</comment>
        <translation>Die Voxelgröße ist mit 1 × 1 × 1 mm angegeben: Prüfen Sie, ob sie bei einer Umwandlung verloren ging.</translation>
    </message>
    <message>
        <source>NIfTI supports at most 32767 voxels along an axis. Save the volume as .nrrd or .mha.</source>
        <comment>volume.nifti-too-long</comment>
        <translation>NIfTI unterstützt höchstens 32767 Voxel je Achse. Speichern Sie als .nrrd oder .mha.</translation>
    </message>
    <message>
        <source>volumes can be written as .nii, .nii.gz, .nrrd or .mha. Change the extension.</source>
        <comment>volume.extension</comment>
        <translation>Volumen lassen sich als .nii, .nii.gz, .nrrd oder .mha schreiben. Ändern Sie die Endung.</translation>
    </message>
    <message>
        <source>there are no voxels to write. Load a volume first.</source>
        <comment>volume.nothing-to-write</comment>
        <translation>es gibt keine Voxel zu schreiben. Laden Sie zuerst ein Volumen.</translation>
    </message>
    <message>
        <source>there is not enough memory to compress the volume.</source>
        <comment>volume.no-memory-to-pack</comment>
        <translation>der Speicher reicht nicht aus, um das Volumen zu komprimieren.</translation>
    </message>
    <message>
        <source>this DICOM file is not a segmentation. Choose a label image.</source>
        <comment>labels.no-segmentation</comment>
        <translation>diese DICOM-Datei ist keine Segmentierung. Wählen Sie ein Labelbild.</translation>
    </message>
    <message>
        <source>the file contains only a single slice, not a volume. Choose the complete segmentation.</source>
        <comment>labels.one-plane</comment>
        <translation>die Datei enthält nur eine Schicht, kein Volumen. Wählen Sie die vollständige Segmentierung.</translation>
    </message>
    <message>
        <source>the file contains the value %1, which is not a label: labels are non-negative integers. Choose a label image.</source>
        <comment>labels.no-whole-number</comment>
        <translation>die Datei enthält den Wert %1, der kein Label ist: Labels sind nichtnegative ganze Zahlen. Wählen Sie ein Labelbild.</translation>
    </message>
    <message>
        <source>the file contains no labeled voxels: all voxels are background. Choose another segmentation.</source>
        <comment>labels.nothing-marked</comment>
        <translation>die Datei enthält keine markierten Voxel: Alle Voxel sind Hintergrund. Wählen Sie eine andere Segmentierung.</translation>
    </message>
    <message>
        <source>there is no label %1. Choose one of the available labels: %2.</source>
        <comment>labels.no-such-number</comment>
        <translation>es gibt kein Label %1. Vorhandene Labels: %2. Wählen Sie eines davon.</translation>
    </message>
    <message>
        <source>there is no label &quot;%1&quot;. Choose one of the available labels: %2.</source>
        <comment>labels.no-such-name</comment>
        <translation>es gibt kein Label „%1“. Vorhandene Labels: %2. Wählen Sie eines davon.</translation>
    </message>
    <message>
        <source>none</source>
        <comment>labels.none</comment>
        <translation>keine</translation>
    </message>
    <message>
        <source>Labels traced: %1.</source>
        <comment>labels.traced</comment>
        <translation>Erfasste Labels: %1.</translation>
    </message>
    <message>
        <source>Labels skipped because of their names: %1.</source>
        <comment>labels.left-out</comment>
        <translation>Wegen ihres Namens ausgelassene Labels: %1.</translation>
    </message>
    <message>
        <source>The volume contains labels; the vessels are taken directly from these.</source>
        <comment>labels.volume-holds-labels</comment>
        <translation>Das Volumen enthält Labels; die Gefäße werden direkt daraus übernommen.</translation>
    </message>
    <message>
        <source>Measuring lengths at the vessels requires the depth of the vessels. Open a vessel tree, or measure at the detector or in pixels.</source>
        <comment>measure.needs-vessels</comment>
        <translation>Eine Länge an den Gefäßen erfordert deren Tiefe. Öffnen Sie die Gefäße, oder messen Sie am Detektor oder in Pixeln.</translation>
    </message>
    <message>
        <source>The vessels lie behind the X-ray source, so lengths at the vessels cannot be measured. Correct the pose, or measure in pixels.</source>
        <comment>measure.behind-source</comment>
        <translation>Die Gefäße liegen hinter dem Röntgenfokus, daher lässt sich an ihnen nichts messen. Korrigieren Sie die Lage, oder messen Sie in Pixeln.</translation>
    </message>
    <message>
        <source>The pixel spacing of the detector is unknown. Enter it under Geometry, or measure in pixels.</source>
        <comment>measure.needs-spacing</comment>
        <translation>Die Pixelgröße des Detektors ist unbekannt. Geben Sie sie unter „Geometrie“ ein, oder messen Sie in Pixeln.</translation>
    </message>
    <message>
        <source>This type of measurement requires at least %1 points, but has only %2. Draw the measurement again.</source>
        <comment>measure.points</comment>
        <translation>Diese Art von Messung braucht mindestens %1 Punkte; diese hat %2. Zeichnen Sie sie neu.</translation>
    </message>
    <message>
        <source>A point of the measurement has a non-finite coordinate. Draw the measurement again.</source>
        <comment>measure.not-finite</comment>
        <translation>Ein Punkt der Messung hat eine nicht endliche Koordinate. Zeichnen Sie sie neu.</translation>
    </message>
    <message>
        <source>One side of the angle has zero length. Move its two points apart.</source>
        <comment>measure.angle-open</comment>
        <translation>Ein Schenkel des Winkels hat die Länge null. Ziehen Sie seine Punkte auseinander.</translation>
    </message>
    <message>
        <source>The outline intersects itself, so its area is undefined. Move its points.</source>
        <comment>measure.crossed</comment>
        <translation>Der Umriss schneidet sich selbst, daher ist seine Fläche nicht definiert. Verschieben Sie seine Punkte.</translation>
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
        <source>Pixel size %2 at the depth of the vessel centroid (%1 from the source). Segments that run toward or away from the source are longer than they appear.</source>
        <comment>measure.basis-vessels</comment>
        <translation>Pixelgröße %2 in der Tiefe des Gefäßschwerpunkts (%1 vom Fokus). Abschnitte, die zum Fokus hin oder von ihm weg verlaufen, sind länger, als sie erscheinen.</translation>
    </message>
    <message>
        <source>Pixel size %1 at the detector. Structures in the patient are smaller by the magnification factor.</source>
        <comment>measure.basis-detector</comment>
        <translation>Pixelgröße %1 auf dem Detektor. Strukturen im Patienten sind um den Vergrößerungsfaktor kleiner.</translation>
    </message>
    <message>
        <source>In image pixels only; no physical scale.</source>
        <comment>measure.basis-pixels</comment>
        <translation>Nur Bildpixel; kein physikalischer Maßstab.</translation>
    </message>
    <message>
        <source>Projected angle; the true 3-D angle differs.</source>
        <comment>measure.basis-angle</comment>
        <translation>Projizierter Winkel; der wahre 3-D-Winkel weicht ab.</translation>
    </message>
    <message>
        <source>Pixels are assumed to be square.</source>
        <comment>measure.square-pixels</comment>
        <translation>Pixel werden als quadratisch angenommen.</translation>
    </message>
    <message>
        <source>The geometry used for this scale is assumed, not measured; its relative error carries over to this value.</source>
        <comment>measure.scale-assumed</comment>
        <translation>Die Geometrie hinter diesem Maßstab ist angenommen, nicht gemessen; ihr relativer Fehler überträgt sich auf diesen Wert.</translation>
    </message>
    <message>
        <source>The geometry used for this scale was entered manually.</source>
        <comment>measure.scale-typed</comment>
        <translation>Die Geometrie hinter diesem Maßstab wurde manuell eingegeben.</translation>
    </message>
    <message>
        <source>This pose was not determined by a registration; the depth of the vessels is unverified.</source>
        <comment>measure.depth-unchecked</comment>
        <translation>Diese Lage stammt nicht aus einer Registrierung; die Tiefe der Gefäße ist ungeprüft.</translation>
    </message>
    <message>
        <source>The registration that determined this pose is not reliable, and neither is the depth of the vessels.</source>
        <comment>measure.pose-doubtful</comment>
        <translation>Die Registrierung dieser Lage ist nicht verlässlich und damit auch nicht die Tiefe der Gefäße.</translation>
    </message>
    <message>
        <source>Depth uncertainty: ±%1 (1-σ), which corresponds to ±%2 of the measured length.</source>
        <comment>measure.depth-spread</comment>
        <translation>Unsicherheit der Tiefe: ±%1 (1-σ), das sind ±%2 der Länge.</translation>
    </message>
    <message>
        <source>this type of measurement requires at least %1 points, not %2. Add points, or remove the measurement.</source>
        <comment>case.measurement-points</comment>
        <translation>diese Art von Messung braucht mindestens %1 Punkte, nicht %2. Ergänzen Sie Punkte, oder entfernen Sie die Messung.</translation>
    </message>
    <message>
        <source>Branch %1 has zero length, so nothing can be measured along it. Trace the branch again.</source>
        <comment>measure.branch-no-length</comment>
        <translation>Ast %1 hat keine Länge, daher lässt sich entlang seines Verlaufs nichts messen. Erfassen Sie ihn neu.</translation>
    </message>
    <message>
        <source>This branch has no radii, so its diameter is unknown. Trace the vessels in a scan, or open a tree with radii.</source>
        <comment>measure.branch-no-radii</comment>
        <translation>Dieser Ast hat keine Radien, daher ist sein Durchmesser unbekannt. Erfassen Sie die Gefäße eines Scans, oder öffnen Sie einen Gefäßbaum mit Radien.</translation>
    </message>
    <message>
        <source>No segment of this branch is uniform enough to serve as a reference; no stenosis is reported.</source>
        <comment>measure.branch-no-reference</comment>
        <translation>Kein Abschnitt dieses Astes ist gleichmäßig genug für eine Referenz; es wird keine Stenose angegeben.</translation>
    </message>
    <message>
        <source>No scale was entered for this image. Enter the pixel size, or measure in pixels.</source>
        <comment>measure.needs-typed-scale</comment>
        <translation>Für dieses Bild wurde kein Maßstab eingegeben. Geben Sie die Größe eines Pixels ein, oder messen Sie in Pixeln.</translation>
    </message>
    <message>
        <source>%1 (scale entered)</source>
        <comment>measure.by-typed</comment>
        <translation>%1 (Maßstab eingegeben)</translation>
    </message>
    <message>
        <source>Pixel size %1, as entered for this image. Valid only at the depth at which it was determined.</source>
        <comment>measure.basis-typed</comment>
        <translation>Pixelgröße %1, wie für dieses Bild eingegeben. Gilt nur in der Tiefe, für die sie bestimmt wurde.</translation>
    </message>
    <message>
        <source>Not marked in this frame. Choose “Mark target point in image” and click the point.</source>
        <comment>check.not-seen</comment>
        <translation>In diesem Bild nicht markiert. Wählen Sie „Zielpunkt im Bild markieren“, und klicken Sie auf den Punkt.</translation>
    </message>
    <message>
        <source>Marked in frame %1, but the pose belongs to frame %2. Go to the marked frame, or mark the point in the current frame.</source>
        <comment>check.other-frame</comment>
        <translation>In Bild %1 markiert, aber die Lage gehört zu Bild %2. Wechseln Sie zum markierten Bild, oder markieren Sie den Punkt in diesem.</translation>
    </message>
    <message>
        <source>At this pose, the point lies behind the X-ray source. Correct the pose.</source>
        <comment>check.behind-source</comment>
        <translation>Bei dieser Lage liegt der Punkt hinter dem Röntgenfokus. Korrigieren Sie die Lage.</translation>
    </message>
    <message>
        <source>In the image plane at the depth of the point (%1 from the source): %2, %3. The pixel size there is %4, which limits the click accuracy.</source>
        <comment>check.image-error</comment>
        <translation>In der Bildebene in der Tiefe des Punkts (%1 vom Fokus): %2, %3. Ein Pixel misst dort %4 und begrenzt die Genauigkeit eines Klicks.</translation>
    </message>
    <message>
        <source>The pose covariance predicts an error of %1 at this point (1-σ).</source>
        <comment>check.claimed</comment>
        <translation>Die Kovarianz der Lage sagt an diesem Punkt %1 voraus (1-σ).</translation>
    </message>
    <message>
        <source>This pose was not determined by a registration; no error is predicted.</source>
        <comment>check.nothing-claimed</comment>
        <translation>Diese Lage stammt nicht aus einer Registrierung; es wird kein Fehler vorhergesagt.</translation>
    </message>
    <message>
        <source>With deformed vessels: %1.</source>
        <comment>check.bent</comment>
        <translation>Mit verformten Gefäßen: %1.</translation>
    </message>
    <message>
        <source>In 3-D, where the rays of views %1 are closest to each other (angle %2): %3. Distance between the rays: %4.</source>
        <comment>check.space-error</comment>
        <translation>In 3-D, wo sich die Strahlen der Ansichten %1 am nächsten kommen (Winkel %2): %3. Abstand der Strahlen: %4.</translation>
    </message>
    <message>
        <source>A 3-D error can be computed only if the point is marked in two views; it is currently marked in at most one.</source>
        <comment>check.needs-two-views</comment>
        <translation>Ein 3-D-Fehler setzt voraus, dass der Punkt in zwei Ansichten markiert ist; bisher ist er höchstens in einer markiert.</translation>
    </message>
    <message>
        <source>The views show the point from almost the same direction (angle between the rays: %1), so its depth cannot be determined.</source>
        <comment>check.rays-alike</comment>
        <translation>Die Ansichten zeigen den Punkt aus fast derselben Richtung (%1 zwischen den Strahlen), daher lässt sich seine Tiefe nicht bestimmen.</translation>
    </message>
    <message>
        <source>error %1</source>
        <comment>check.label</comment>
        <translation>Fehler %1</translation>
    </message>
    <message>
        <source>error %1, predicted %2</source>
        <comment>check.label-claimed</comment>
        <translation>Fehler %1, erwartet %2</translation>
    </message>
    <message>
        <source>⌀ %1</source>
        <comment>check.ring-width</comment>
        <translation>⌀ %1</translation>
    </message>
    <message>
        <source>This branch has no radius here, so the size of a ring is undefined. Add a target point instead.</source>
        <comment>check.ring-needs-radius</comment>
        <translation>Dieser Ast hat hier keinen Radius, daher ist die Größe eines Rings nicht definiert. Setzen Sie stattdessen einen Zielpunkt.</translation>
    </message>
    <message>
        <source>Click the vessels: target points and rings must lie on them.</source>
        <comment>check.needs-vessels</comment>
        <translation>Klicken Sie auf die Gefäße: Zielpunkte und Ringe müssen auf ihnen liegen.</translation>
    </message>
    <message>
        <source>Patient coordinates: x %1, y %2, z %3.</source>
        <comment>check.place</comment>
        <translation>Patientenkoordinaten x %1, y %2, z %3.</translation>
    </message>
    <message>
        <source>two marks have the number %1. Give each a unique number.</source>
        <comment>case.mark-twice</comment>
        <translation>zwei Marken haben die Nummer %1. Geben Sie jeder eine eigene Nummer.</translation>
    </message>
    <message>
        <source>a ring requires a radius greater than 0 and a direction. Add both, or remove the ring.</source>
        <comment>case.ring-open</comment>
        <translation>ein Ring braucht einen Radius über 0 und eine Richtung. Ergänzen Sie beides, oder entfernen Sie den Ring.</translation>
    </message>
    <message>
        <source>an arrow requires two points and a text annotation one point. Correct the points, or remove the annotation.</source>
        <comment>case.annotation-points</comment>
        <translation>ein Pfeil braucht zwei Punkte, ein Text einen. Korrigieren Sie die Punkte, oder entfernen Sie die Anmerkung.</translation>
    </message>
    <message>
        <source>Scan voxel size: %1 × %2 × %3.</source>
        <comment>measure.basis-scan</comment>
        <translation>Voxelgröße des Scans: %1 × %2 × %3.</translation>
    </message>
    <message>
        <source>In scan voxels; the voxel size is unknown because the scan is not open.</source>
        <comment>measure.basis-scan-away</comment>
        <translation>Scan-Voxel; ihre Größe ist unbekannt, weil der Scan nicht geöffnet ist.</translation>
    </message>
    <message>
        <source>Angle in the slice plane; if a side leaves the plane, the 3-D angle differs.</source>
        <comment>measure.basis-scan-angle</comment>
        <translation>Winkel in der Schichtebene; verlässt ein Schenkel die Ebene, weicht der 3-D-Winkel ab.</translation>
    </message>
    <message>
        <source>this is a report, not an image.</source>
        <comment>study.report</comment>
        <translation>dies ist ein Befund, kein Bild.</translation>
    </message>
    <message>
        <source>this object only defines how other images are displayed.</source>
        <comment>study.presentation</comment>
        <translation>dies legt nur fest, wie andere Bilder dargestellt werden.</translation>
    </message>
    <message>
        <source>this object contains no image (%1).</source>
        <comment>study.no-image</comment>
        <translation>hier ist kein Bild enthalten (%1).</translation>
    </message>
    <message>
        <source>this is a scout (localizer), neither a volume nor an angiogram.</source>
        <comment>study.scout</comment>
        <translation>dies ist ein Übersichtsbild (Scout), weder Volumen noch Angiogramm.</translation>
    </message>
    <message>
        <source>the frames are compressed as video, which is not supported. Export the run in another format.</source>
        <comment>study.video</comment>
        <translation>die Bilder sind als Video komprimiert, was nicht unterstützt wird. Exportieren Sie sie in einem anderen Format.</translation>
    </message>
    <message>
        <source>AngioPose does not trace vessels in images of modality %1.</source>
        <comment>study.modality</comment>
        <translation>AngioPose erfasst in Bildern der Modalität %1 keine Gefäße.</translation>
    </message>
    <message>
        <source>this is listed in the DICOMDIR, but the files are missing.</source>
        <comment>study.missing</comment>
        <translation>im DICOMDIR aufgeführt, aber die Dateien fehlen.</translation>
    </message>
    <message>
        <source>it contains no file list</source>
        <comment>directory.no-records</comment>
        <translation>es enthält keine Dateiliste</translation>
    </message>
    <message>
        <source>the records are not linked consistently</source>
        <comment>directory.torn</comment>
        <translation>die Einträge sind nicht schlüssig verkettet</translation>
    </message>
    <message>
        <source>it ends in the middle of a record</source>
        <comment>directory.unfinished</comment>
        <translation>es bricht mitten in einem Eintrag ab</translation>
    </message>
    <message>
        <source>movies can be saved as .mp4 or .gif. Choose one of these.</source>
        <comment>movie.kind</comment>
        <translation>Filme lassen sich als .mp4 oder .gif schreiben. Wählen Sie eines davon.</translation>
    </message>
    <message>
        <source>a movie must have at least %1 pixels per side. Choose a larger size.</source>
        <comment>movie.too-small</comment>
        <translation>ein Film muss mindestens %1 Pixel je Seite haben. Wählen Sie eine größere Größe.</translation>
    </message>
    <message>
        <source>MP4 does not support frames of %1 × %2 pixels: the limits are 9,437,184 pixels per frame (4096 × 2304) and 8688 pixels per side. Choose a smaller size, or GIF.</source>
        <comment>movie.too-large</comment>
        <translation>MP4 unterstützt keine Bilder von %1 × %2 Pixeln: Die Grenze liegt bei 9.437.184 Pixeln (4096 × 2304) und 8688 je Seite. Wählen Sie eine kleinere Größe oder GIF.</translation>
    </message>
    <message>
        <source>a GIF of %1 × %2 pixels is too large: the limit is %3 pixels per side. Choose a smaller size.</source>
        <comment>movie.gif-too-large</comment>
        <translation>ein GIF von %1 × %2 Pixeln ist zu groß: Die Grenze liegt bei %3 je Seite. Wählen Sie eine kleinere Größe.</translation>
    </message>
    <message>
        <source>all frames of a movie must have the same size.</source>
        <comment>movie.sizes-differ</comment>
        <translation>alle Bilder eines Films müssen gleich groß sein.</translation>
    </message>
    <message>
        <source>the movie could not be encoded. Choose another size, or GIF.</source>
        <comment>movie.encoder-failed</comment>
        <translation>der Film konnte nicht kodiert werden. Wählen Sie eine andere Größe oder GIF.</translation>
    </message>
    <message>
        <source>the movie would exceed 1 GB. Choose fewer frames or a smaller size.</source>
        <comment>movie.too-long</comment>
        <translation>der Film würde 1 GB überschreiten. Wählen Sie weniger Bilder oder eine kleinere Größe.</translation>
    </message>
    <message>
        <source>the movie could not be written. Choose another size or format.</source>
        <comment>movie.not-made</comment>
        <translation>der Film konnte nicht geschrieben werden. Wählen Sie eine andere Größe oder ein anderes Format.</translation>
    </message>
    <message>
        <source>The report template %1 cannot be read: a template must be UTF-8 text of at most 1 MB. Choose another template, or the built-in one.</source>
        <comment>report.template-unreadable</comment>
        <translation>Die Berichtsvorlage %1 ist nicht lesbar: Eine Vorlage muss ein UTF-8-Text von höchstens 1 MB sein. Wählen Sie eine andere Vorlage oder die eingebaute.</translation>
    </message>
    <message>
        <source>The report template does not contain %1. Without it, a report could omit information that must be read together with the result. Add it to the template.</source>
        <comment>report.template-lacks</comment>
        <translation>Der Berichtsvorlage fehlt %1. Ohne diese Angabe könnte ein Bericht Informationen auslassen, die mit dem Ergebnis gelesen werden müssen. Fügen Sie sie hinzu.</translation>
    </message>
    <message>
        <source>The report template contains %1, which is not a known placeholder. Known placeholders: %2.</source>
        <comment>report.template-unknown</comment>
        <translation>Die Berichtsvorlage enthält %1, das kein bekannter Platzhalter ist. Bekannte Platzhalter: %2.</translation>
    </message>
    <message>
        <source>The report template contains “%1”, which could load or run other content. Remove it.</source>
        <comment>report.template-fetches</comment>
        <translation>Die Berichtsvorlage enthält „%1“, womit sich andere Inhalte laden oder ausführen ließen. Entfernen Sie es.</translation>
    </message>
    <message>
        <source>The image %1 of the report template cannot be read. Place it next to the template, as a PNG or JPEG file of at most 16 MB and 8192 pixels per side.</source>
        <comment>report.template-picture</comment>
        <translation>Das Bild %1 der Berichtsvorlage ist nicht lesbar. Legen Sie es neben die Vorlage, als PNG oder JPEG von höchstens 16 MB und 8192 Pixeln je Seite.</translation>
    </message>
    <message>
        <source>the images together exceed the size limit of a DICOM object. Choose a smaller width or fewer frames.</source>
        <comment>object.too-large</comment>
        <translation>die Bilder überschreiten zusammen die Größe, die ein DICOM-Objekt haben darf. Wählen Sie eine kleinere Breite oder weniger Bilder.</translation>
    </message>
    <message>
        <source>this is not a PDF. Export the report as PDF first.</source>
        <comment>object.no-pdf</comment>
        <translation>das ist kein PDF. Exportieren Sie zuerst den Bericht als PDF.</translation>
    </message>
    <message>
        <source>a presentation state must reference a DICOM image, but this angiogram cannot be referenced. Open it as DICOM, or leave out the presentation state.</source>
        <comment>object.no-reference</comment>
        <translation>ein Presentation State muss auf ein DICOM-Bild verweisen, und auf dieses Angiogramm lässt sich nicht verweisen. Öffnen Sie es als DICOM, oder lassen Sie den Presentation State weg.</translation>
    </message>
    <message>
        <source>no vessels lie within the image. Move the vessels into the image first, or leave out the presentation state.</source>
        <comment>object.no-lines</comment>
        <translation>im Bild liegen keine Gefäße. Verschieben Sie sie zuerst dorthin, oder lassen Sie den Presentation State weg.</translation>
    </message>
    <message>
        <source>the pose is not a rigid transform with finite values. Reset it first.</source>
        <comment>object.pose-not-rigid</comment>
        <translation>die Lage ist keine starre Transformation mit endlichen Werten. Setzen Sie zuerst die Lage zurück.</translation>
    </message>
    <message>
        <source>no vessel lies within the scan. Check that the scan and the vessels belong to the same patient, or leave out the segmentation.</source>
        <comment>object.no-voxels</comment>
        <translation>im Scan liegt kein Gefäß. Prüfen Sie, ob Scan und Gefäße vom selben Patienten stammen, oder lassen Sie die Segmentierung weg.</translation>
    </message>
    <message>
        <source>there is neither a measurement nor a registration result. Create one of them first, or leave out the measurements.</source>
        <comment>object.nothing-measured</comment>
        <translation>es gibt weder eine Messung noch ein Registrierungsergebnis. Erstellen Sie zuerst eines davon, oder lassen Sie die Messungen weg.</translation>
    </message>
    <message>
        <source>this DICOM file contains no registration between two frames of reference. Choose a Spatial Registration object.</source>
        <comment>pose.no-registration</comment>
        <translation>diese DICOM-Datei enthält keine Registrierung zwischen zwei Bezugssystemen. Wählen Sie eine Spatial Registration.</translation>
    </message>
    <message>
        <source>a segmentation requires the scan or mask from which the vessels were traced. Open it first, or leave out the segmentation.</source>
        <comment>dicom-export.no-scan</comment>
        <translation>eine Segmentierung braucht den Scan oder die Maske, aus denen die Gefäße stammen. Öffnen Sie diese zuerst, oder lassen Sie die Segmentierung weg.</translation>
    </message>
    <message>
        <source>the program angiopose, which creates the reports, was not found at &apos;%1&apos;. Install it next to angiopose-cli, or build the target angiopose.</source>
        <comment>report.program-missing</comment>
        <translation>das Programm angiopose, das die Berichte schreibt, fehlt unter &apos;%1&apos;. Installieren Sie es neben angiopose-cli, oder bauen Sie das Ziel angiopose.</translation>
    </message>
    <message>
        <source>The program angiopose was terminated by signal %1; no report was written. Run angiopose-cli support-bundle to collect diagnostic data.</source>
        <comment>report.program-fault</comment>
        <translation>Das Programm angiopose wurde durch Signal %1 beendet; es wurde kein Bericht geschrieben. Sammeln Sie mit angiopose-cli support-bundle Diagnosedaten.</translation>
    </message>
    <message>
        <source>the report was written. It states that this pose is not reliable, and why.</source>
        <comment>report.distrusted</comment>
        <translation>der Bericht wurde geschrieben. Er gibt an, dass diese Lage nicht verlässlich ist, und warum.</translation>
    </message>
    <message>
        <source>stopped; no report was written.</source>
        <comment>report.stopped</comment>
        <translation>angehalten; es wurde kein Bericht geschrieben.</translation>
    </message>
    <message>
        <source>reports are created with `angiopose-cli report` or in the window. Pass the PDF with --report, or leave out the report.</source>
        <comment>dicom-export.no-report</comment>
        <translation>Berichte entstehen mit angiopose-cli report oder im Fenster. Geben Sie das PDF mit --report an, oder lassen Sie den Bericht weg.</translation>
    </message>
    <message>
        <source>Not exported: %1: %2</source>
        <comment>dicom-export.left-out</comment>
        <translation>Nicht exportiert: %1: %2</translation>
    </message>
    <message>
        <source>The angiogram is not a DICOM image: the exported objects form a new study without a patient.</source>
        <comment>dicom-export.new-study</comment>
        <translation>Das Angiogramm ist kein DICOM-Bild: Die exportierten Objekte bilden eine neue Studie ohne Patienten.</translation>
    </message>
    <message>
        <source>The scan is not a DICOM series: the segmentation references no series and has its own frame of reference.</source>
        <comment>dicom-export.no-scan-study</comment>
        <translation>Der Scan ist keine DICOM-Serie: Seine Segmentierung verweist auf keine Serie und hat ein eigenes Bezugssystem.</translation>
    </message>
    <message>
        <source>A Spatial Registration object contains only a rigid matrix. It cannot store the perspective camera, which an overlay requires. The camera is stored in private elements and in the accompanying file camera.json.</source>
        <comment>dicom-export.rigid-only</comment>
        <translation>Eine Spatial Registration enthält nur eine starre Matrix. Die perspektivische Kamera, die eine Überlagerung erfordert, kann sie nicht speichern. Die Kamera steht in ihren privaten Elementen und in der beiliegenden camera.json.</translation>
    </message>
    <message>
        <source>The presentation state shows the image as stored, without subtraction: its gray values differ from those shown here.</source>
        <comment>dicom-export.treated</comment>
        <translation>Der Presentation State zeigt das gespeicherte, nicht subtrahierte Bild: Seine Grauwerte weichen von den hier gezeigten ab.</translation>
    </message>
    <message>
        <source>none of these objects can be created from this case. Open vessels and an angiogram first.</source>
        <comment>dicom-export.nothing</comment>
        <translation>aus diesem Fall lässt sich keines dieser Objekte erzeugen. Öffnen Sie zuerst Gefäße und ein Angiogramm.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is unknown. Use one of these: %2.</source>
        <comment>dicom-export.kind-unknown</comment>
        <translation>„%1“ ist unbekannt. Verwenden Sie eines von diesen: %2.</translation>
    </message>
    <message>
        <source>stopped; nothing was written.</source>
        <comment>dicom-export.stopped</comment>
        <translation>angehalten; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Vessels of a registered 3-D tree overlaid on the image, with the selected window and size</source>
        <comment>dicom-export.derivation</comment>
        <translation>Gefäße eines registrierten 3-D-Baums dem Bild überlagert, mit gewähltem Fenster und gewählter Größe</translation>
    </message>
    <message>
        <source>No registration is recorded for this pose. Register first.</source>
        <comment>movie.no-history</comment>
        <translation>Für diese Lage ist keine Registrierung verzeichnet. Registrieren Sie zuerst.</translation>
    </message>
    <message>
        <source>stopped before the movie was complete; nothing was written.</source>
        <comment>movie.stopped</comment>
        <translation>angehalten, bevor der Film vollständig war. Es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>pose of frame %1</source>
        <comment>movie.pose-of-frame</comment>
        <translation>Lage des Bildes %1</translation>
    </message>
    <message>
        <source>pose tracked to this frame</source>
        <comment>movie.followed</comment>
        <translation>bis zu diesem Bild verfolgte Lage</translation>
    </message>
    <message>
        <source>pose tracked to this frame · not reliable</source>
        <comment>movie.followed-distrusted</comment>
        <translation>bis zu diesem Bild verfolgte Lage · nicht verlässlich</translation>
    </message>
    <message>
        <source>step %1 of %2 · median %3</source>
        <comment>movie.step</comment>
        <translation>Schritt %1 von %2 · Median %3</translation>
    </message>
    <message>
        <source>step %1 of %2 · median %3 · result not reliable</source>
        <comment>movie.step-distrusted</comment>
        <translation>Schritt %1 von %2 · Median %3 · Ergebnis nicht verlässlich</translation>
    </message>
    <message>
        <source>frontal view, rotated by %1</source>
        <comment>movie.turned</comment>
        <translation>Ansicht von vorn, um %1 gedreht</translation>
    </message>
    <message>
        <source>the file cannot be written: it would exceed the file size limit of the system (ulimit -f) or of the drive. Raise the limit, or choose another folder.</source>
        <comment>file.beyond-limit</comment>
        <translation>die Datei lässt sich nicht schreiben: Sie würde die Dateigrößengrenze des Systems (ulimit -f) oder des Laufwerks überschreiten. Heben Sie die Grenze an, oder wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>the case was changed elsewhere after it was opened here. Save it under another name, or reopen it.</source>
        <comment>case.changed-elsewhere</comment>
        <translation>der Fall wurde anderswo geändert, nachdem er hier geöffnet wurde. Speichern Sie ihn unter anderem Namen, oder öffnen Sie ihn erneut.</translation>
    </message>
    <message>
        <source>the case is also open elsewhere (process %1 on %2). Save it under another name, or close it there.</source>
        <comment>case.open-elsewhere</comment>
        <translation>der Fall ist auch anderswo geöffnet (Prozess %1 auf %2). Speichern Sie ihn unter anderem Namen, oder schließen Sie ihn dort.</translation>
    </message>
    <message>
        <source>the table lists no cases. Start with a header row that contains a case column and either a reference or a pairs column; add one row per case.</source>
        <comment>own.no-header</comment>
        <translation>die Tabelle führt keine Fälle auf. Beginnen Sie mit einer Kopfzeile mit der Spalte case und einer der Spalten reference und pairs; fügen Sie je Fall eine Zeile hinzu.</translation>
    </message>
    <message>
        <source>line %1 specifies no case. Enter the path of a case file in the case column.</source>
        <comment>own.no-case</comment>
        <translation>Zeile %1 nennt keinen Fall. Geben Sie in der Spalte case den Pfad einer Falldatei an.</translation>
    </message>
    <message>
        <source>line %1 has no ground truth. Specify a pose in the reference column, or a table of point pairs in the pairs column.</source>
        <comment>own.no-truth</comment>
        <translation>Zeile %1 hat keine Referenzwahrheit. Geben Sie eine Lage in der Spalte reference an oder eine Tabelle von Punktpaaren in der Spalte pairs.</translation>
    </message>
    <message>
        <source>line %1 specifies the true vessel positions in the bent column. This requires a pose in the reference column and cannot be combined with landmarks, which would also have to be deformed.</source>
        <comment>own.bent-alone</comment>
        <translation>Zeile %1 gibt in der Spalte bent die wahren Gefäßpositionen an. Das erfordert eine Lage in der Spalte reference und schließt Landmarken aus, die ebenfalls verformt werden müssten.</translation>
    </message>
    <message>
        <source>the branches or their numbers of points differ from those of the vessels of the case. Deformed vessels are evaluated point by point: create them by moving the points of the case&apos;s own vessel file.</source>
        <comment>own.bent-other</comment>
        <translation>die Äste oder deren Punktzahlen weichen von den Gefäßen des Falles ab. Verformte Gefäße werden Punkt für Punkt ausgewertet: Verschieben Sie die Punkte der Gefäßdatei des Falles.</translation>
    </message>
    <message>
        <source>line %1: &apos;%2&apos; is not a valid condition name. It is used in file names: use only letters, digits, periods, hyphens and underscores.</source>
        <comment>own.condition-name</comment>
        <translation>Zeile %1: &apos;%2&apos; ist kein gültiger Name einer Bedingung. Er wird in Dateinamen verwendet: Verwenden Sie nur Buchstaben, Ziffern, Punkte, Binde- und Unterstriche.</translation>
    </message>
    <message>
        <source>a column is named &apos;pose.&apos; without a name after the period. Add the name of the method or person that determined these poses.</source>
        <comment>own.pose-without-name</comment>
        <translation>eine Spalte heißt &apos;pose.&apos; ohne Namen nach dem Punkt. Ergänzen Sie die Methode oder Person, die diese Lagen bestimmt hat.</translation>
    </message>
    <message>
        <source>column %1 is missing. Landmarks require x, y, z (mm, LPS); point pairs also require u and v (px).</source>
        <comment>own.point-column-missing</comment>
        <translation>die Spalte %1 fehlt. Landmarken brauchen x, y, z (mm, LPS), Punktpaare zusätzlich u und v (px).</translation>
    </message>
    <message>
        <source>the table contains no points.</source>
        <comment>own.no-points</comment>
        <translation>die Tabelle enthält keine Punkte.</translation>
    </message>
    <message>
        <source>column %1 is missing: this is not a blind trial log, or it was written by an earlier version that did not store the centroid. Create a new log with Registration &gt; Blind observer trial.</source>
        <comment>observers.column-missing</comment>
        <translation>die Spalte %1 fehlt: Dies ist kein Protokoll von Blindversuchen, oder eine frühere Version, die den Schwerpunkt nicht speicherte, hat es geschrieben. Erzeugen Sie mit Registrierung &gt; Blinder Beobachterversuch ein neues Protokoll.</translation>
    </message>
    <message>
        <source>The logs contain no two finished trials of the same image, so there is nothing to compare. Have an observer repeat a trial, or have another observer perform it.</source>
        <comment>observers.too-few</comment>
        <translation>Die Protokolle enthalten keine zwei beendeten Versuche an demselben Bild, daher gibt es nichts zu vergleichen. Lassen Sie eine Person einen Versuch wiederholen oder eine andere ihn durchführen.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a valid key of %2. Valid keys: %3.</source>
        <comment>study.unknown-key</comment>
        <translation>&apos;%1&apos; ist kein gültiger Schlüssel von %2. Gültige Schlüssel: %3.</translation>
    </message>
    <message>
        <source>%1 has no &apos;%2&apos;.</source>
        <comment>study.missing-key</comment>
        <translation>%1 hat kein &apos;%2&apos;.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; of %2 has an invalid value: %3.</source>
        <comment>study.wrong-value</comment>
        <translation>&apos;%1&apos; von %2 hat einen ungültigen Wert: %3.</translation>
    </message>
    <message>
        <source>this is not a study file. A study file must begin with &quot;format&quot;: &quot;angiopose-study&quot;, &quot;version&quot;: 1.</source>
        <comment>study.no-study</comment>
        <translation>dies ist keine Studiendatei. Die Datei muss mit &quot;format&quot;: &quot;angiopose-study&quot;, &quot;version&quot;: 1 beginnen.</translation>
    </message>
    <message>
        <source>two settings are named &apos;%1&apos;. Give each setting a unique name, which is also used as its folder name.</source>
        <comment>study.name-twice</comment>
        <translation>zwei Einstellungen heißen &apos;%1&apos;. Geben Sie jeder einen eigenen Namen, der auch als Ordnername dient.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; of %2 must be between %3 and %4.</source>
        <comment>study.out-of-range</comment>
        <translation>&apos;%1&apos; von %2 muss zwischen %3 und %4 liegen.</translation>
    </message>
    <message>
        <source>`evaluate own` requires a table of cases with reference data: angiopose-cli evaluate own CASES.csv --output FOLDER.</source>
        <comment>evaluate.no-manifest</comment>
        <translation>`evaluate own` braucht eine Tabelle der Fälle mit ihren Referenzdaten: angiopose-cli evaluate own CASES.csv --output FOLDER.</translation>
    </message>
    <message>
        <source>`evaluate observers` requires a blind trial log: angiopose-cli evaluate observers TRIALS.csv --output FOLDER.</source>
        <comment>evaluate.no-log</comment>
        <translation>`evaluate observers` braucht ein Protokoll von Blindversuchen: angiopose-cli evaluate observers TRIALS.csv --output FOLDER.</translation>
    </message>
    <message>
        <source>The experiment &apos;%1&apos; generates its own trials. Omit &apos;%2&apos;, or write `evaluate own %2`.</source>
        <comment>evaluate.input-of-experiment</comment>
        <translation>Das Experiment &apos;%1&apos; erzeugt seine Versuche selbst. Lassen Sie &apos;%2&apos; weg, oder schreiben Sie `evaluate own %2`.</translation>
    </message>
    <message>
        <source>`simulate` requires --seed for one case or --study for many.</source>
        <comment>simulate.what</comment>
        <translation>`simulate` braucht --seed für einen Fall oder --study für viele.</translation>
    </message>
    <message>
        <source>Some voxel values (%1 voxels) are far outside the range of all others (%2 to %3); they are clamped to that range.</source>
        <comment>volume.stray-values</comment>
        <translation>%1 Voxel liegen weit außerhalb des Bereichs aller anderen (%2 bis %3); sie werden auf diesen Bereich begrenzt.</translation>
    </message>
    <message>
        <source>the output was not written completely: the drive or pipe used for standard output is full or closed. Free up space, or redirect the output.</source>
        <comment>run.output-not-written</comment>
        <translation>die Ausgabe wurde nicht vollständig geschrieben: Laufwerk oder Pipe hinter der Standardausgabe ist voll oder geschlossen. Schaffen Sie Platz, oder leiten Sie die Ausgabe um.</translation>
    </message>
    <message>
        <source>the audit log cannot be written (%1), so actions are not recorded. Free up space, or grant write permission.</source>
        <comment>audit.not-written</comment>
        <translation>das Audit-Protokoll lässt sich nicht schreiben (%1), daher werden Aktionen darin nicht verzeichnet. Schaffen Sie Platz, oder erlauben Sie das Schreiben.</translation>
    </message>
    <message>
        <source>The header contains no table position: the vessel position in this view is determined from its image, and only the rotation is derived from the gantry angles.</source>
        <comment>geometry.table-unknown</comment>
        <translation>Der Header enthält keine Tischposition: Die Gefäßposition in dieser Ansicht ergibt sich aus ihrem Bild, nur die Drehung aus den Winkeln.</translation>
    </message>
    <message>
        <source>The only distance in the headers is (0018,1111), and it differs between the views (%1, %2), so it is not the source-to-isocenter distance. The shift between the views is not used; enter the source-to-isocenter distance (SOD) of both views.</source>
        <comment>geometry.isocenter-unknown</comment>
        <translation>Der einzige Abstand in den Headern ist (0018,1111), und er unterscheidet sich zwischen den Ansichten (%1, %2), ist also nicht der Isozentrumsabstand. Die Verschiebung zwischen den Ansichten wird nicht verwendet; geben Sie für beide Ansichten den Abstand Fokus–Isozentrum (SOD) ein.</translation>
    </message>
    <message>
        <source>The table moved during one of the runs: the shift between the views is treated as unknown (50 mm).</source>
        <comment>geometry.table-moved-in-view</comment>
        <translation>Der Tisch bewegte sich während einer der Serien: Die Verschiebung zwischen den Ansichten wird als unbekannt behandelt (50 mm).</translation>
    </message>
    <message>
        <source>Almost all lines traced here remain stationary throughout the run, like shutter edges, leads and bones: the frame shows no contrast agent to track.</source>
        <comment>follow.stands-still</comment>
        <translation>Fast alle hier erkannten Linien stehen in der ganzen Serie still, wie Blendenränder, Kabel und Knochen: Das Bild zeigt kein Kontrastmittel, das sich verfolgen ließe.</translation>
    </message>
    <message>
        <source>Frame %1 does not exist: the image has frames 1 to %2.</source>
        <comment>frame.missing</comment>
        <translation>Bild %1 gibt es nicht: die Aufnahme hat die Bilder 1 bis %2.</translation>
    </message>
    <message>
        <source>Mask frame %1 does not exist (counted from 1). The run has frames 1 to %2.</source>
        <comment>subtraction.mask-frame-missing</comment>
        <translation>Maskenbild %1 existiert nicht (ab 1 gezählt). Die Serie hat die Bilder 1 bis %2.</translation>
    </message>
    <message>
        <source>A wide vessel that was not traced runs next to the traced vessels over %1, at %2: possibly the false lumen of a dissection. Place a seed in each lumen to trace both.</source>
        <comment>tracing.other-lumen-beside</comment>
        <translation>Neben den erfassten Gefäßen verläuft über %1 ein weites, nicht erfasstes Gefäß, bei %2: möglicherweise das falsche Lumen einer Dissektion. Setzen Sie in jedes Lumen einen Startpunkt, um beide zu erfassen.</translation>
    </message>
    <message>
        <source>frame %1 does not exist (counted from 0, as in case files). The image has frames 0 to %2.</source>
        <comment>case.frame-missing</comment>
        <translation>Bild %1 existiert nicht (ab 0 gezählt, wie in Falldateien). Die Aufnahme hat die Bilder 0 bis %2.</translation>
    </message>
    <message>
        <source>The image is shown as specified by its orientation tag (%1): rotated or mirrored relative to the stored pixels.</source>
        <comment>image.turned</comment>
        <translation>Das Bild wird gemäß seiner Orientierungsangabe (%1) dargestellt: gegenüber den gespeicherten Pixeln gedreht oder gespiegelt.</translation>
    </message>
    <message>
        <source>page %1 is %2 × %3 pixels, but the first page is %4 × %5 pixels. Export the frames of a single run, all of the same size.</source>
        <comment>image.pages-differ</comment>
        <translation>Seite %1 hat %2 × %3 Pixel, die erste Seite aber %4 × %5 Pixel. Exportieren Sie die Bilder einer einzigen Serie, alle gleich groß.</translation>
    </message>
    <message>
        <source>the file has %1 pages. Export the mask as a single image.</source>
        <comment>centreline.mask-pages</comment>
        <translation>die Datei hat %1 Seiten. Exportieren Sie die Maske als ein einziges Bild.</translation>
    </message>
    <message>
        <source>The header declares %1 frames, but the file contains %2; the frames in the file were loaded. Copy or export the file again if frames are missing.</source>
        <comment>dicom.frames-other</comment>
        <translation>Der Header nennt %1 Bilder, die Datei enthält aber %2; die in der Datei wurden geladen. Kopieren oder exportieren Sie die Datei erneut, falls Bilder fehlen.</translation>
    </message>
    <message>
        <source>The header contains contradictory frame intervals: Frame Time %1, Frame Time Vector %2. The value used is %3.</source>
        <comment>dicom.frame-times</comment>
        <translation>Der Header enthält widersprüchliche Bildabstände: Frame Time %1, Frame Time Vector %2. Verwendet wird %3.</translation>
    </message>
    <message>
        <source>a volume reconstructed from projections (modality %1)</source>
        <comment>dicom.reconstruction</comment>
        <translation>ein aus Projektionen rekonstruiertes Volumen (Modalität %1)</translation>
    </message>
    <message>
        <source>The %1 shutter in the header (0018,1600) hides the entire image (%2) and is ignored. Check that no shutter edge is traced as a vessel.</source>
        <comment>dicom.shutter-unusable</comment>
        <translation>Die Blende %1 im Header (0018,1600) verdeckt das gesamte Bild (%2) und wird ignoriert. Prüfen Sie, dass kein Blendenrand als Gefäß erkannt ist.</translation>
    </message>
    <message>
        <source>Based on %2, the image is assumed to be rotated clockwise by %1. Check the orientation markers (H, L).</source>
        <comment>dicom.image-turned</comment>
        <translation>Auf Grundlage von %2 gilt das Bild als um %1 im Uhrzeigersinn gedreht. Prüfen Sie die Orientierungsmarkierungen (H, L).</translation>
    </message>
    <message>
        <source>Patient Orientation (0020,0020) is %1, which is impossible at these gantry angles. Check the angles, and check whether the image is mirrored or rotated.</source>
        <comment>dicom.orientation-unlike-angles</comment>
        <translation>Patient Orientation (0020,0020) lautet %1, was bei diesen Winkeln unmöglich ist. Prüfen Sie die Winkel und ob das Bild gespiegelt oder gedreht ist.</translation>
    </message>
    <message>
        <source>According to the header, the object is at a distance of %1 and the isocenter at a distance of %2 from the source: the vessels are initially placed at the object distance, and the gantry rotates about the isocenter.</source>
        <comment>dicom.object-off-isocenter</comment>
        <translation>Laut Header liegt das Objekt %1 und das Isozentrum %2 vom Fokus entfernt: Die Gefäße beginnen im Objektabstand, und der C-Bogen dreht um das Isozentrum.</translation>
    </message>
    <message>
        <source>The file specifies its unit (&quot;%1&quot;): one unit is read as %2. Specify the unit if this is incorrect.</source>
        <comment>vessels.unit-stated</comment>
        <translation>Die Datei nennt ihre Einheit („%1“): eine Einheit wird als %2 gelesen. Geben Sie die Einheit an, falls das nicht stimmt.</translation>
    </message>
    <message>
        <source>The file specifies its unit (&quot;%1&quot;, that is, %2), but one unit is read as %3, as requested. Check the size.</source>
        <comment>vessels.unit-overruled</comment>
        <translation>Die Datei nennt ihre Einheit („%1“, also %2), aber eine Einheit wird wie angefordert als %3 gelesen. Prüfen Sie die Größe.</translation>
    </message>
    <message>
        <source>The file specifies two units (&quot;%1&quot; and &quot;%2&quot;). Check the size; if it is wrong, specify the unit.</source>
        <comment>vessels.units-contradict</comment>
        <translation>Die Datei nennt zwei Einheiten („%1“ und „%2“). Prüfen Sie die Größe und geben Sie die Einheit an, falls sie nicht stimmt.</translation>
    </message>
    <message>
        <source>the axes are %1, not LPS or RAS. Export the file in patient coordinates (LPS).</source>
        <comment>vessels.axes-other</comment>
        <translation>die Achsen sind %1, nicht LPS oder RAS. Exportieren Sie die Datei in Patientenkoordinaten (LPS).</translation>
    </message>
    <message>
        <source>In some lines, the first points were stored at the end and have been moved to the beginning (number of lines: %1). Check the vessels.</source>
        <comment>tree.turned-round</comment>
        <translation>In einigen Linien standen die ersten Punkte am Ende und wurden an den Anfang gesetzt (Anzahl der Linien: %1). Prüfen Sie die Gefäße.</translation>
    </message>
    <message>
        <source>The lines contain %1 jumps of up to %2, far beyond their typical point spacing, and were split there. Check the order of the points.</source>
        <comment>tree.leaps</comment>
        <translation>Die Linien springen %1-mal um bis zu %2, weit mehr als ihr typischer Punktabstand; sie wurden dort getrennt. Prüfen Sie die Reihenfolge der Punkte.</translation>
    </message>
    <message>
        <source>Curve points without a position were skipped (number: %1).</source>
        <comment>tree.markups-not-placed</comment>
        <translation>%1 Kurvenpunkte haben keine Position und wurden ausgelassen.</translation>
    </message>
    <message>
        <source>the header declares %1 triangles, but the file contains %2. Copy or export the file again.</source>
        <comment>surface.stl-too-few</comment>
        <translation>der Header nennt %1 Dreiecke, die Datei enthält aber %2. Kopieren oder exportieren Sie die Datei erneut.</translation>
    </message>
    <message>
        <source>The header declares %1 triangles, but the file size corresponds to %2; the data after the declared triangles were not read. Check that nothing is missing.</source>
        <comment>surface.stl-too-many</comment>
        <translation>Der Header nennt %1 Dreiecke, die Dateigröße entspricht aber %2; Daten nach den genannten Dreiecken wurden nicht gelesen. Prüfen Sie, ob etwas fehlt.</translation>
    </message>
    <message>
        <source>The text ends after %1 triangles without &quot;endsolid&quot; and may be truncated. Check that nothing is missing.</source>
        <comment>surface.stl-without-end</comment>
        <translation>Der Text endet nach %1 Dreiecken ohne „endsolid“ und ist möglicherweise abgeschnitten. Prüfen Sie, ob etwas fehlt.</translation>
    </message>
    <message>
        <source>the coordinates are in &quot;%1&quot;, which is not a known unit of length. Export them in mm.</source>
        <comment>tree.markups-unit</comment>
        <translation>die Koordinaten sind in „%1“, einer unbekannten Längeneinheit. Exportieren Sie sie in mm.</translation>
    </message>
    <message>
        <source>The header contains contradictory slice spacings: %1 (Spacing Between Slices) and %2 (slice positions). The slice positions are used.</source>
        <comment>series.step</comment>
        <translation>Der Header enthält widersprüchliche Schichtabstände: %1 (Spacing Between Slices), %2 nach den Schichtpositionen. Die Positionen gelten.</translation>
    </message>
    <message>
        <source>part %1 of %2 (acquisition %3)</source>
        <comment>series.acquisition</comment>
        <translation>Teil %1 von %2 (Akquisition %3)</translation>
    </message>
    <message>
        <source>%1 of %2 images of the series share an SOP Instance UID although they differ; all of them are read. Export the series again before archiving it.</source>
        <comment>series.same-uid</comment>
        <translation>%1 von %2 Bildern der Serie haben dieselbe SOP Instance UID, obwohl sie sich unterscheiden; alle werden gelesen. Exportieren Sie die Serie vor dem Archivieren neu.</translation>
    </message>
    <message>
        <source>%1 patients or studies share the UID of this series; each is listed separately.</source>
        <comment>series.of-several</comment>
        <translation>%1 Patienten oder Studien teilen sich die UID dieser Serie; jede ist einzeln aufgeführt.</translation>
    </message>
    <message>
        <source>The header specifies lengths in &quot;%1&quot;, which is not a known unit: millimeters are assumed. Check the voxel size.</source>
        <comment>volume.unit-unknown</comment>
        <translation>Der Header gibt Längen in „%1“ an, einer unbekannten Einheit: Millimeter werden angenommen. Prüfen Sie die Voxelgröße.</translation>
    </message>
    <message>
        <source>The qform and sform transforms differ by up to %1; the qform transform (scanner coordinates) is used.</source>
        <comment>volume.nifti-qform-used</comment>
        <translation>Die Transformationen qform und sform weichen um bis zu %1 voneinander ab; die qform in Gerätekoordinaten wird verwendet.</translation>
    </message>
    <message>
        <source>The qform and sform transforms differ by up to %1; the sform transform is used.</source>
        <comment>volume.nifti-sform-used</comment>
        <translation>Die Transformationen qform und sform weichen um bis zu %1 voneinander ab; die sform wird verwendet.</translation>
    </message>
    <message>
        <source>The header contains contradictory voxel sizes: %1 (pixdim) and %2 (transform). The size from the transform is used. Check which one is correct.</source>
        <comment>volume.nifti-sizes</comment>
        <translation>Der Header enthält widersprüchliche Voxelgrößen: %1 (pixdim), %2 nach seiner Transformation. Die Transformation wird verwendet. Prüfen Sie, was stimmt.</translation>
    </message>
    <message>
        <source>The header contains contradictory voxel types: %1 bits (bitpix), but %2 bits according to the datatype (%3). The datatype is used.</source>
        <comment>volume.nifti-bits</comment>
        <translation>Der Header enthält widersprüchliche Voxeltypen: %1 Bit (bitpix), aber %2 Bit nach dem Datentyp (%3), der verwendet wird.</translation>
    </message>
    <message>
        <source>The header states that the voxel data begin at byte %1, inside the header itself; they are read from byte %2 instead.</source>
        <comment>volume.nifti-start-within-header</comment>
        <translation>Laut Header beginnen die Voxel bei Byte %1, also innerhalb des Headers selbst; sie werden ab Byte %2 gelesen.</translation>
    </message>
    <message>
        <source>a voxel size of %1 mm cannot be written. Correct the spacing, origin and directions of the volume.</source>
        <comment>volume.no-size-to-write</comment>
        <translation>eine Voxelgröße von %1 mm lässt sich nicht schreiben. Korrigieren Sie Abstand, Ursprung und Richtungen des Volumens.</translation>
    </message>
    <message>
        <source>frame %1 does not exist (counted from 1). The run has frames 1 to %2.</source>
        <comment>command.frame-beyond-run</comment>
        <translation>Bild %1 existiert nicht (ab 1 gezählt). Die Serie hat die Bilder 1 bis %2.</translation>
    </message>
    <message>
        <source>NOT RELIABLE</source>
        <comment>fit.not-reliable</comment>
        <translation>NICHT VERLÄSSLICH</translation>
    </message>
    <message>
        <source>These distances cover only the %1 of the tree that is classified as opacified. Whole tree: median %2, 95th percentile %3.</source>
        <comment>fit.over-opacified</comment>
        <translation>Diese Abstände gelten nur für die %1 des Gefäßbaums, die als kontrastiert eingestuft sind. Ganzer Gefäßbaum: Median %2, 95. Perzentil %3.</translation>
    </message>
    <message>
        <source>Excluded branches: %1 (medians). With these included: median %2, 95th percentile %3.</source>
        <comment>fit.without-excluded</comment>
        <translation>Ausgeschlossene Äste: %1 (Mediane). Mit ihnen: Median %2, 95. Perzentil %3.</translation>
    </message>
    <message>
        <source>Auxiliary branches: %1 (medians).</source>
        <comment>fit.auxiliary</comment>
        <translation>Hilfsäste: %1 (Mediane).</translation>
    </message>
    <message>
        <source>at this pose, all vessels lie at or behind the X-ray source and cannot be projected. Check the pose and its direction (patient to camera).</source>
        <comment>pose.all-behind-source</comment>
        <translation>in dieser Lage liegen alle Gefäße an oder hinter dem Röntgenfokus und lassen sich nicht projizieren. Prüfen Sie die Lage und ihre Richtung (Patient → Kamera).</translation>
    </message>
    <message>
        <source>At this pose, no vessel lies inside the image. Check the pose.</source>
        <comment>pose.all-outside-image</comment>
        <translation>In dieser Lage liegt kein Gefäß im Bild. Prüfen Sie die Lage.</translation>
    </message>
    <message>
        <source>frame %1 of %2</source>
        <comment>picture.frame</comment>
        <translation>Bild %1 von %2</translation>
    </message>
    <message>
        <source>Frames %1 to %2 are not a valid range: the run has frames 1 to %3. Choose another range.</source>
        <comment>movie.frames-beyond</comment>
        <translation>Die Bilder %1 bis %2 sind kein gültiger Bereich: Die Serie hat die Bilder 1 bis %3. Wählen Sie einen anderen Bereich.</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Finds the pose of a 3-D vessel tree in a 2-D angiogram. Not for clinical use.</source>
        <translation>Findet die Lage eines 3-D-Gefäßbaums in einem 2-D-Angiogramm. Nicht für den klinischen Einsatz.</translation>
    </message>
    <message>
        <source>A case file, or a centerline and an angiogram.</source>
        <translation>Eine Falldatei, oder eine Mittellinie und ein Angiogramm.</translation>
    </message>
    <message>
        <source>Renderer of the angiogram: vtk (OpenGL), painter (CPU), or auto (vtk if a graphics card supports OpenGL).</source>
        <translation>Renderer des Angiogramms: vtk (OpenGL), painter (CPU) oder auto (vtk, wenn eine Grafikkarte OpenGL unterstützt).</translation>
    </message>
    <message>
        <source>Unknown renderer “%1”. Use auto, vtk or painter.</source>
        <translation>Unbekannter Renderer „%1“. Verwenden Sie auto, vtk oder painter.</translation>
    </message>
    <message>
        <source>No display is available for the window. Use angiopose-cli, which provides the same functions without a display.</source>
        <translation>Für das Fenster ist keine Anzeige verfügbar. Verwenden Sie angiopose-cli, das dieselben Funktionen ohne Anzeige bietet.</translation>
    </message>
    <message>
        <source>Write the report of a case (.pdf or .html) and exit; requires no display.</source>
        <translation>Den Bericht eines Falls schreiben (.pdf oder .html) und beenden; braucht keine Anzeige.</translation>
    </message>
    <message>
        <source>With --report: register the case first.</source>
        <translation>Mit --report: den Fall zuerst registrieren.</translation>
    </message>
    <message>
        <source>With --report: template to use instead of the built-in one.</source>
        <translation>Mit --report: Vorlage, die statt der eingebauten verwendet wird.</translation>
    </message>
    <message>
        <source>With --report: author to use instead of the account name.</source>
        <translation>Mit --report: Autor statt des Benutzernamens.</translation>
    </message>
    <message>
        <source>With --report: include the patient&apos;s identity (omitted by default).</source>
        <translation>Mit --report: die Patientendaten aufnehmen, die sonst fehlen.</translation>
    </message>
    <message>
        <source>With --report: language to use instead of the UI language.</source>
        <translation>Mit --report: Sprache statt der Sprache der Oberfläche.</translation>
    </message>
    <message>
        <source>Reports are available in %1, not in “%2”.</source>
        <translation>Berichte gibt es in %1, nicht in „%2“.</translation>
    </message>
    <message>
        <source>--register, --template, --author, --identity and --language require --report FILE.</source>
        <translation>--register, --template, --author, --identity und --language erfordern --report FILE.</translation>
    </message>
    <message>
        <source>Reports are written as .pdf or .html, not as “%1”.</source>
        <translation>Berichte werden als .pdf oder .html geschrieben, nicht als „%1“.</translation>
    </message>
    <message>
        <source>A report requires exactly one case: angiopose --report FILE CASE</source>
        <translation>Ein Bericht braucht genau einen Fall: angiopose --report FILE CASE</translation>
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
        <source>%1 frames earlier</source>
        <translation>%1 Bilder früher</translation>
    </message>
    <message>
        <source>none found: set them below</source>
        <translation>keine gefunden: unten festlegen</translation>
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
        <source>Peak-opacification image</source>
        <translation>Min-IP der ganzen Serie</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Chooses the frames before contrast arrival</source>
        <translation>Wählt die Bilder vor Ankunft des Kontrastmittels</translation>
    </message>
    <message>
        <source>Computes the mask shift for each frame</source>
        <translation>Berechnet die Maskenverschiebung für jedes Bild</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Manuell</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>Vorgaben</translation>
    </message>
    <message>
        <source>Restores the default tracing settings</source>
        <translation>Stellt die Standardeinstellungen der Erkennung wieder her</translation>
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
        <source>Single frames</source>
        <translation>Einzelbilder</translation>
    </message>
    <message>
        <source>Choose mask frames automatically</source>
        <translation>Maskenbilder automatisch wählen</translation>
    </message>
    <message>
        <source>Compute mask shift</source>
        <translation>Maskenverschiebung bestimmen</translation>
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
        <source>Shifts the mask to the right, px</source>
        <translation>Verschiebt die Maske nach rechts, px</translation>
    </message>
    <message>
        <source>Shifts the mask down, px</source>
        <translation>Verschiebt die Maske nach unten, px</translation>
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
        <source>Pixel shift</source>
        <translation>Pixelshift</translation>
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
        <source>Relation of the stored pixel values to the X-ray intensity (0028,1040)</source>
        <translation>Beziehung der gespeicherten Werte zur Röntgenintensität (0028,1040)</translation>
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
        <source>Sets whether the contrast agent is darker or brighter than the background</source>
        <translation>Legt fest, ob Kontrastmittel dunkler oder heller als der Hintergrund ist</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>Gefäße</translation>
    </message>
    <message>
        <source>Change the interpretation of pixel values</source>
        <translation>Deutung der Pixelwerte ändern</translation>
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
        <source>min. length</source>
        <translation>Mindestlänge</translation>
    </message>
    <message>
        <source>Removes isolated segments shorter than this length, and spurs shorter than a third of it</source>
        <translation>Entfernt isolierte Abschnitte, die kürzer sind, und Sporne unter einem Drittel davon</translation>
    </message>
    <message>
        <source>sensitivity</source>
        <translation>Empfindlichkeit</translation>
    </message>
    <message>
        <source>Above 1, fainter vessels are also traced</source>
        <translation>Über 1 werden auch schwächere Gefäße erfasst</translation>
    </message>
    <message>
        <source>max. radius</source>
        <translation>max. Radius</translation>
    </message>
    <message>
        <source>Radius of the widest vessel to trace</source>
        <translation>Radius des weitesten zu erfassenden Gefäßes</translation>
    </message>
    <message>
        <source>Restore default tracing</source>
        <translation>Standarderkennung wiederherstellen</translation>
    </message>
    <message>
        <source>Tracing</source>
        <translation>Erkennung</translation>
    </message>
    <message>
        <source>subtracting…</source>
        <translation>subtrahiert…</translation>
    </message>
    <message>
        <source>subtracted</source>
        <translation>subtrahiert</translation>
    </message>
    <message>
        <source>MinIP</source>
        <translation>MinIP</translation>
    </message>
    <message>
        <source>native</source>
        <translation>nativ</translation>
    </message>
    <message>
        <source>Shift the mask with the arrow keys or the mouse</source>
        <translation>Maske mit Pfeiltasten oder Maus verschieben</translation>
    </message>
    <message>
        <source>Subtracts structures that are also visible in the mask frames, such as bone and soft tissue</source>
        <translation>Subtrahiert Strukturen, die auch in den Maskenbildern sichtbar sind, etwa Knochen und Weichteile</translation>
    </message>
    <message>
        <source>Shows the darkest value of each pixel over the run</source>
        <translation>Zeigt den dunkelsten Wert jedes Pixels über die Serie</translation>
    </message>
    <message>
        <source>Edit vessels</source>
        <translation>Gefäße bearbeiten</translation>
    </message>
    <message>
        <source>Exclude, erase, draw and cut traced curves</source>
        <translation>Erkannte Kurven ausschließen, radieren, zeichnen und trennen</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Window (W): range of gray values between black and white</source>
        <translation>Fenster (W): Bereich der Grauwerte zwischen Schwarz und Weiß</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Zentrum</translation>
    </message>
    <message>
        <source>Level (L): gray value at the center of the window</source>
        <translation>Zentrum (L): Grauwert in der Mitte des Fensters</translation>
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
        <source>Mirrored image, mirrored back in this view</source>
        <translation>Gespiegeltes Bild, von der Ansicht zurückgespiegelt</translation>
    </message>
    <message>
        <source>View from the source: mirrored</source>
        <translation>Ansicht vom Fokus: gespiegelt</translation>
    </message>
    <message>
        <source>Mirrored image: seen from the source</source>
        <translation>Gespiegeltes Bild: vom Fokus gesehen</translation>
    </message>
    <message>
        <source>flicker %1 · swipe %2 · hide H · outline %3</source>
        <translation>Blinken %1 · Wischen %2 · Verbergen H · Umriss %3</translation>
    </message>
    <message>
        <source>No angiogram yet: drop one here, or open it (%1).</source>
        <translation>Noch kein Angiogramm: Legen Sie eines hier ab, oder öffnen Sie es (%1).</translation>
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
        <source>This method alternates between the auxiliary branches and the whole vessel tree.</source>
        <translation>Diese Methode wechselt zwischen den Hilfsästen und dem ganzen Gefäßbaum.</translation>
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
        <source>Radius at least</source>
        <translation>Radius mindestens</translation>
    </message>
    <message>
        <source>Uses the median radius of each branch.</source>
        <translation>Verwendet den medianen Radius jedes Astes.</translation>
    </message>
    <message>
        <source>Use these</source>
        <translation>Diese übernehmen</translation>
    </message>
    <message>
        <source>Selects the suggested branches as auxiliary branches.</source>
        <translation>Macht die vorgeschlagenen Äste zu Hilfsästen.</translation>
    </message>
    <message>
        <source>Auxiliary branches</source>
        <translation>Hilfsäste</translation>
    </message>
    <message>
        <source>Alternating methods solve for these branches first; choose branches that are opacified, stationary and clearly separated. In a view, a branch constrains the pose only perpendicular to its course; the table shows which branches constrain each axis at the current pose.</source>
        <translation>Alternierende Methoden lösen zuerst für diese Äste; wählen Sie kontrastierte, unbewegte und klar getrennte Äste. In einer Ansicht bestimmt ein Ast die Lage nur quer zu seinem Verlauf; die Tabelle zeigt, welche Äste bei der aktuellen Lage welche Achse festlegen.</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>All branches</source>
        <translation>Alle Äste</translation>
    </message>
    <message>
        <source>Auxiliary</source>
        <translation>Hilfsäste</translation>
    </message>
    <message>
        <source>Constrained by</source>
        <translation>Festgelegt durch</translation>
    </message>
    <message>
        <source>±: standard deviation expected for traced vessels with typical noise.</source>
        <translation>±: bei typischem Rauschen erwartete Standardabweichung der erkannten Gefäße.</translation>
    </message>
    <message>
        <source>Last generation</source>
        <translation>Letzte Generation</translation>
    </message>
    <message>
        <source>Minimum radius</source>
        <translation>Mindestradius</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Without auxiliary branches, the nodes of the vessel tree are used.</source>
        <translation>Ohne Hilfsäste werden die Knoten des Gefäßbaums verwendet.</translation>
    </message>
    <message>
        <source>A suggestion requires vessels, a camera and a pose.</source>
        <translation>Ein Vorschlag erfordert Gefäße, Kamera und Lage.</translation>
    </message>
    <message>
        <source>Suggested: %1 (nearly as informative as the whole tree).</source>
        <translation>Vorschlag: %1 (fast so aussagekräftig wie der ganze Gefäßbaum).</translation>
    </message>
    <message>
        <source>This tree has no generation data.</source>
        <translation>Dieser Gefäßbaum enthält keine Generationen.</translation>
    </message>
    <message>
        <source>This tree has no radii.</source>
        <translation>Dieser Gefäßbaum enthält keine Radien.</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Draw around the branches in the image.</source>
        <translation>Umfahren Sie die Äste im Bild.</translation>
    </message>
    <message>
        <source>In view</source>
        <translation>Im Blick</translation>
    </message>
    <message>
        <source>Selects the branches that lie completely in the view.</source>
        <translation>Wählt die Äste, die vollständig im Blickfeld liegen.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::BlindTrialDialog</name>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Max. initial shift</source>
        <translation>Max. Startverschiebung</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Max. initial rotation</source>
        <translation>Max. Startdrehung</translation>
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
        <source>The vessels start in a random pose near the current one. Until you choose “Done”, all numbers, residual colors and earlier poses are hidden. The time and the final pose are logged; the case is not changed.</source>
        <translation>Die Gefäße beginnen in einer zufälligen Lage um die aktuelle. Bis Sie „Fertig“ wählen, sind alle Zahlen, Residuenfarben und früheren Lagen verborgen. Zeit und Endlage werden protokolliert; der Fall bleibt unverändert.</translation>
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
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Trial log</source>
        <translation>Versuchsprotokoll</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Enter the observer and choose a log file.</source>
        <translation>Geben Sie einen Beobachter und eine Protokolldatei an.</translation>
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
        <source>excl.</source>
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
        <source>auxiliary branch</source>
        <translation>Hilfsast</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>ausgeschlossen</translation>
    </message>
    <message>
        <source>median residual %1 mm</source>
        <translation>medianes Residuum %1 mm</translation>
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
        <source>Use only these as auxiliary</source>
        <translation>Nur diese als Hilfsäste</translation>
    </message>
    <message>
        <source>Clear auxiliary branches</source>
        <translation>Hilfsäste aufheben</translation>
    </message>
    <message>
        <source>in tree order</source>
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
        <translation>nach Residuum</translation>
    </message>
    <message>
        <source>Find a branch</source>
        <translation>Ast suchen</translation>
    </message>
    <message>
        <source>Branch order</source>
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
        <source>Selects both branches and moves the crosshair to the gap.</source>
        <translation>Wählt beide Äste aus und setzt das Fadenkreuz auf die Lücke.</translation>
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
        <source>No vessels yet. Open a CT scan, a vessel mask or a centerline.</source>
        <translation>Noch keine Gefäße. Öffnen Sie ein CT, eine Gefäßmaske oder eine Mittellinie.</translation>
    </message>
    <message>
        <source>Bridges the gap; can be undone.</source>
        <translation>Überbrückt die Lücke; lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>%1 auxiliary · %2 exclude</source>
        <translation>%1 Hilfsast · %2 ausschließen</translation>
    </message>
    <message>
        <source>Toggle auxiliary</source>
        <translation>Hilfsast ein/aus</translation>
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
        <source>Share case as ZIP…</source>
        <translation>Fall als ZIP weitergeben…</translation>
    </message>
    <message>
        <source>Export DICOM objects…</source>
        <translation>DICOM-Objekte exportieren…</translation>
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
        <source>Play from this frame</source>
        <translation>Ab diesem Bild abspielen</translation>
    </message>
    <message>
        <source>Play to this frame</source>
        <translation>Bis zu diesem Bild abspielen</translation>
    </message>
    <message>
        <source>Play the entire run</source>
        <translation>Gesamte Serie abspielen</translation>
    </message>
    <message>
        <source>Show views side by side</source>
        <translation>Ansichten nebeneinander zeigen</translation>
    </message>
    <message>
        <source>Linked crosshair across views</source>
        <translation>Gekoppeltes Fadenkreuz in Ansichten</translation>
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
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Open DICOM folder/CD…</source>
        <translation>DICOM-Ordner/CD öffnen…</translation>
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
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Export overlay…</source>
        <translation>Überlagerung exportieren…</translation>
    </message>
    <message>
        <source>Export result…</source>
        <translation>Ergebnis exportieren…</translation>
    </message>
    <message>
        <source>Export pose…</source>
        <translation>Lage exportieren…</translation>
    </message>
    <message>
        <source>Export traced vessels…</source>
        <translation>Erkannte Gefäße exportieren…</translation>
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
        <source>Reset to initial pose</source>
        <translation>Auf Startlage zurücksetzen</translation>
    </message>
    <message>
        <source>Copy pose as matrix</source>
        <translation>Lage als Matrix kopieren</translation>
    </message>
    <message>
        <source>Toggle auxiliary for selected branches</source>
        <translation>Gewählte Äste als Hilfsäste ein/aus</translation>
    </message>
    <message>
        <source>Auxiliary: branches in view</source>
        <translation>Hilfsäste: Äste im Blickfeld</translation>
    </message>
    <message>
        <source>Auxiliary: larger vessels</source>
        <translation>Hilfsäste: größere Gefäße</translation>
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
        <source>Fit image to window</source>
        <translation>Bild in Fenster einpassen</translation>
    </message>
    <message>
        <source>Automatic window/level</source>
        <translation>Automatische Fensterung</translation>
    </message>
    <message>
        <source>Invert grayscale</source>
        <translation>Grauwerte invertieren</translation>
    </message>
    <message>
        <source>Window preset: full range</source>
        <translation>Fensterung: gesamter Bereich</translation>
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
        <source>Depth cueing</source>
        <translation>Tiefenabstufung</translation>
    </message>
    <message>
        <source>Cycle swipe / magic lens</source>
        <translation>Wischen / Lupe umschalten</translation>
    </message>
    <message>
        <source>Go to next worst branch</source>
        <translation>Zum nächstschlechtesten Ast</translation>
    </message>
    <message>
        <source>Show traced vessels</source>
        <translation>Erkannte Gefäße zeigen</translation>
    </message>
    <message>
        <source>Flicker initial / current pose</source>
        <translation>Start- und aktuelle Lage im Wechsel</translation>
    </message>
    <message>
        <source>Color by deformation</source>
        <translation>Nach Verformung einfärben</translation>
    </message>
    <message>
        <source>Show deformed vessels</source>
        <translation>Verformte Gefäße zeigen</translation>
    </message>
    <message>
        <source>Replay last registration</source>
        <translation>Letzte Registrierung wiedergeben</translation>
    </message>
    <message>
        <source>Animate pose uncertainty</source>
        <translation>Unsicherheit der Lage animieren</translation>
    </message>
    <message>
        <source>Show alternative solutions</source>
        <translation>Alternative Lösungen zeigen</translation>
    </message>
    <message>
        <source>Accept this solution</source>
        <translation>Diese Lösung übernehmen</translation>
    </message>
    <message>
        <source>Decrease overlay opacity</source>
        <translation>Deckkraft der Überlagerung verringern</translation>
    </message>
    <message>
        <source>Increase overlay opacity</source>
        <translation>Deckkraft der Überlagerung erhöhen</translation>
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
        <source>System theme</source>
        <translation>Farbschema des Systems</translation>
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
        <source>System language</source>
        <translation>Sprache des Systems</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Save screenshot…</source>
        <translation>Screenshot speichern…</translation>
    </message>
    <message>
        <source>Copy screenshot</source>
        <translation>Screenshot kopieren</translation>
    </message>
    <message>
        <source>Radiology: left-drag adjusts window/level</source>
        <translation>Radiologie: links ziehen ändert die Fensterung</translation>
    </message>
    <message>
        <source>3D Slicer: left button only selects</source>
        <translation>3D Slicer: linke Taste wählt nur aus</translation>
    </message>
    <message>
        <source>Scroll: left-drag scrolls through frames</source>
        <translation>Blättern: links ziehen wechselt Bilder</translation>
    </message>
    <message>
        <source>Context help</source>
        <translation>Kontexthilfe</translation>
    </message>
    <message>
        <source>Quick tour</source>
        <translation>Kurze Tour</translation>
    </message>
    <message>
        <source>Examples of good and bad fits</source>
        <translation>Beispiele guter und schlechter Registrierungen</translation>
    </message>
    <message>
        <source>Keyboard and mouse</source>
        <translation>Tastatur und Maus</translation>
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
        <source>Toggle DSA / native</source>
        <translation>DSA / nativ umschalten</translation>
    </message>
    <message>
        <source>Pixel shift</source>
        <translation>Pixelshift</translation>
    </message>
    <message>
        <source>Set as mask frame</source>
        <translation>Als Maskenbild festlegen</translation>
    </message>
    <message>
        <source>Peak-opacification image</source>
        <translation>Min-IP der ganzen Serie</translation>
    </message>
    <message>
        <source>Pick landmark pairs</source>
        <translation>Landmarkenpaare setzen</translation>
    </message>
    <message>
        <source>Register from landmarks</source>
        <translation>Nach Landmarken registrieren</translation>
    </message>
    <message>
        <source>Auxiliary: select with lasso</source>
        <translation>Hilfsäste: mit Lasso wählen</translation>
    </message>
    <message>
        <source>Choose auxiliary branches…</source>
        <translation>Hilfsäste wählen…</translation>
    </message>
    <message>
        <source>C-arm angles for branch…</source>
        <translation>C-Bogen-Winkel für den Ast…</translation>
    </message>
    <message>
        <source>Trace the scan again</source>
        <translation>Scan neu erfassen</translation>
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
        <source>Cut branch at crosshair</source>
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
        <source>Set root at branch end near crosshair</source>
        <translation>Wurzel am Astende beim Fadenkreuz setzen</translation>
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
        <source>Delete branches and descendants</source>
        <translation>Äste samt nachgeordneten löschen</translation>
    </message>
    <message>
        <source>Prune short or thin branches…</source>
        <translation>Kurze oder dünne Äste entfernen…</translation>
    </message>
    <message>
        <source>Bridge next gap</source>
        <translation>Nächste Lücke überbrücken</translation>
    </message>
    <message>
        <source>Save pose snapshot</source>
        <translation>Snapshot der Lage speichern</translation>
    </message>
    <message>
        <source>Switch between poses A and B</source>
        <translation>Zwischen Lage A und B wechseln</translation>
    </message>
    <message>
        <source>Compare poses and methods…</source>
        <translation>Lagen und Methoden vergleichen…</translation>
    </message>
    <message>
        <source>Blind observer trial…</source>
        <translation>Blinder Beobachterversuch…</translation>
    </message>
    <message>
        <source>Finish trial</source>
        <translation>Versuch beenden</translation>
    </message>
    <message>
        <source>Mirror view (source side)</source>
        <translation>Ansicht spiegeln (Fokusseite)</translation>
    </message>
    <message>
        <source>Opacification over time</source>
        <translation>Kontrastierung im Zeitverlauf</translation>
    </message>
    <message>
        <source>Cycle lower-left view</source>
        <translation>Ansicht unten links wechseln</translation>
    </message>
    <message>
        <source>Show scan slices</source>
        <translation>Scan-Schichten zeigen</translation>
    </message>
    <message>
        <source>Angiogram only</source>
        <translation>Nur Angiogramm</translation>
    </message>
    <message>
        <source>Ve&amp;ssels</source>
        <translation>&amp;Gefäße</translation>
    </message>
    <message>
        <source>Set initial pose from angles</source>
        <translation>Startlage aus den Winkeln setzen</translation>
    </message>
    <message>
        <source>Set as initial pose</source>
        <translation>Als Startlage festlegen</translation>
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
        <source>3-D and slices only</source>
        <translation>Nur 3-D und Schichten</translation>
    </message>
    <message>
        <source>Angiogram in separate window</source>
        <translation>Angiogramm in eigenem Fenster</translation>
    </message>
    <message>
        <source>3-D and slices in separate window</source>
        <translation>3-D und Schichten in eigenem Fenster</translation>
    </message>
    <message>
        <source>All slices in separate window</source>
        <translation>Alle Schichten in eigenem Fenster</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>Export tracked poses…</source>
        <translation>Verfolgte Lagen exportieren…</translation>
    </message>
    <message>
        <source>Add view…</source>
        <translation>Ansicht hinzufügen…</translation>
    </message>
    <message>
        <source>Show next view</source>
        <translation>Nächste Ansicht zeigen</translation>
    </message>
    <message>
        <source>Track vessels through the run</source>
        <translation>Gefäße durch die Serie verfolgen</translation>
    </message>
    <message>
        <source>Cycle vessel style (centerline / outline / tube / DRR)</source>
        <translation>Gefäßdarstellung wechseln (Mittellinie / Umriss / Röhre / DRR)</translation>
    </message>
    <message>
        <source>Window preset: vessels</source>
        <translation>Fensterung: Gefäße</translation>
    </message>
    <message>
        <source>Window preset: bone and devices</source>
        <translation>Fensterung: Knochen und Instrumente</translation>
    </message>
    <message>
        <source>Blue to amber</source>
        <translation>Blau bis Orange</translation>
    </message>
    <message>
        <source>Blue, white, red</source>
        <translation>Blau, weiß, rot</translation>
    </message>
    <message>
        <source>Brightness only</source>
        <translation>Nur Helligkeit</translation>
    </message>
    <message>
        <source>Window/level</source>
        <translation>Fensterung</translation>
    </message>
    <message>
        <source>Vessel and residual colors</source>
        <translation>Farben von Gefäßen und Residuen</translation>
    </message>
    <message>
        <source>Choose vessel labels</source>
        <translation>Gefäßlabels wählen</translation>
    </message>
    <message>
        <source>Set rotation center</source>
        <translation>Drehzentrum setzen</translation>
    </message>
    <message>
        <source>Reset rotation center</source>
        <translation>Drehzentrum zurücksetzen</translation>
    </message>
    <message>
        <source>3-D view: fit all / vessels</source>
        <translation>3-D-Ansicht: alles / Gefäße einpassen</translation>
    </message>
    <message>
        <source>Export vessel tree…</source>
        <translation>Gefäßbaum exportieren…</translation>
    </message>
    <message>
        <source>Export deformed vessels…</source>
        <translation>Verformte Gefäße exportieren…</translation>
    </message>
    <message>
        <source>Export report…</source>
        <translation>Bericht exportieren…</translation>
    </message>
    <message>
        <source>Export measurements…</source>
        <translation>Messungen exportieren…</translation>
    </message>
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
        <source>Export branch measurements…</source>
        <translation>Astmessungen exportieren…</translation>
    </message>
    <message>
        <source>Add target point</source>
        <translation>Zielpunkt setzen</translation>
    </message>
    <message>
        <source>Add ostium ring</source>
        <translation>Ostiumring setzen</translation>
    </message>
    <message>
        <source>Mark target point in image</source>
        <translation>Zielpunkt im Bild markieren</translation>
    </message>
    <message>
        <source>Draw arrow</source>
        <translation>Pfeil zeichnen</translation>
    </message>
    <message>
        <source>Add text annotation</source>
        <translation>Textanmerkung hinzufügen</translation>
    </message>
    <message>
        <source>Export target points…</source>
        <translation>Zielpunkte exportieren…</translation>
    </message>
    <message>
        <source>Export lumen mask…</source>
        <translation>Gefäßmaske exportieren…</translation>
    </message>
    <message>
        <source>Trace between two points</source>
        <translation>Zwischen zwei Punkten erfassen</translation>
    </message>
    <message>
        <source>Paint in lumen mask</source>
        <translation>In Gefäßmaske malen</translation>
    </message>
    <message>
        <source>Erase from lumen mask</source>
        <translation>Aus Gefäßmaske radieren</translation>
    </message>
    <message>
        <source>Cut lumen mask with lasso</source>
        <translation>Gefäßmaske mit Lasso schneiden</translation>
    </message>
    <message>
        <source>Trace the edited mask</source>
        <translation>Bearbeitete Maske erfassen</translation>
    </message>
    <message>
        <source>Show scan in 3-D view</source>
        <translation>Scan in der 3-D-Ansicht zeigen</translation>
    </message>
    <message>
        <source>3-D scan: vessels / vessels and bone</source>
        <translation>3-D-Scan: Gefäße / Gefäße und Knochen</translation>
    </message>
    <message>
        <source>3-D scan: only around vessels</source>
        <translation>3-D-Scan: nur um die Gefäße</translation>
    </message>
    <message>
        <source>Scan DRR on detector</source>
        <translation>DRR des Scans auf dem Detektor</translation>
    </message>
    <message>
        <source>Collapse left panel</source>
        <translation>Linke Leiste einklappen</translation>
    </message>
    <message>
        <source>Collapse right panel</source>
        <translation>Rechte Leiste einklappen</translation>
    </message>
    <message>
        <source>Change layout with step</source>
        <translation>Anordnung mit dem Schritt wechseln</translation>
    </message>
    <message>
        <source>Reset layout for this step</source>
        <translation>Anordnung dieses Schritts zurücksetzen</translation>
    </message>
    <message>
        <source>Export movie…</source>
        <translation>Film exportieren…</translation>
    </message>
    <message>
        <source>Query PACS…</source>
        <translation>PACS abfragen…</translation>
    </message>
    <message>
        <source>Send to PACS…</source>
        <translation>An PACS senden…</translation>
    </message>
    <message>
        <source>De-identify files…</source>
        <translation>Dateien de-identifizieren…</translation>
    </message>
    <message>
        <source>Private mode</source>
        <translation>Privater Modus</translation>
    </message>
    <message>
        <source>Write audit log…</source>
        <translation>Audit-Protokoll schreiben…</translation>
    </message>
    <message>
        <source>Save support bundle…</source>
        <translation>Supportpaket speichern…</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ConvergencePlot</name>
    <message>
        <source>Convergence</source>
        <translation>Konvergenz</translation>
    </message>
    <message>
        <source>shown after a registration</source>
        <translation>nach einer Registrierung sichtbar</translation>
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
        <source>vessel shift per step</source>
        <translation>Gefäßverschiebung je Schritt</translation>
    </message>
    <message>
        <source>Top: median distance of the vessel points to the traced vessels.
Bottom: displacement of the vessels in each step (root mean square over all points); the lowest line is zero.</source>
        <translation>Oben: medianer Abstand der Gefäßpunkte zu den erkannten Gefäßen.
Unten: Verschiebung der Gefäße je Schritt (quadratisches Mittel über alle Punkte); die unterste Linie ist null.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::CornerViews</name>
    <message>
        <source>3-D</source>
        <translation>3-D</translation>
    </message>
    <message>
        <source>Enlarge all slices</source>
        <translation>Alle Schichten groß zeigen</translation>
    </message>
    <message>
        <source>Show only this view, or restore</source>
        <translation>Nur diese Ansicht zeigen, oder wiederherstellen</translation>
    </message>
    <message>
        <source>Move to a separate window, or back</source>
        <translation>In eigenes Fenster verschieben, oder zurück</translation>
    </message>
    <message>
        <source>Double-click: show only this view, or restore</source>
        <translation>Doppelklick: nur diese Ansicht zeigen, oder wiederherstellen</translation>
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
        <source>Click a curve to exclude it</source>
        <translation>Kurve anklicken, um sie auszuschließen</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Brush over the parts of curves that you want to erase</source>
        <translation>Über die zu löschenden Kurventeile streichen</translation>
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
        <source>Click where to split a curve</source>
        <translation>Klicken, wo eine Kurve geteilt werden soll</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Exclude everything inside a box; Ctrl: keep only the inside</source>
        <translation>Alles im Rahmen ausschließen; Strg: nur das Innere behalten</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>Lasso</translation>
    </message>
    <message>
        <source>Exclude everything inside a lasso; Ctrl: keep only the inside</source>
        <translation>Alles im Lasso ausschließen; Strg: nur das Innere behalten</translation>
    </message>
    <message>
        <source>Trace again</source>
        <translation>Neu erfassen</translation>
    </message>
    <message>
        <source>Discard the edits of this frame and trace it automatically; can be undone</source>
        <translation>Bearbeitung dieses Bildes verwerfen und automatisch erfassen; lässt sich rückgängig machen</translation>
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
        <source>Click a catheter or guidewire to mark it as a device; devices do not count as vessels, but can be tracked</source>
        <translation>Katheter oder Führungsdraht anklicken, um ihn als Instrument zu markieren: Er ist kein Gefäß, lässt sich aber verfolgen</translation>
    </message>
    <message>
        <source>Track device</source>
        <translation>Instrument verfolgen</translation>
    </message>
    <message>
        <source>Find the path of the catheter or guidewire through the tree (method “Guidewire or catheter”)</source>
        <translation>Den Weg des Katheters oder Führungsdrahts durch den Gefäßbaum bestimmen (Methode „Führungsdraht oder Katheter“)</translation>
    </message>
    <message>
        <source>%1, devices: %2</source>
        <translation>%1, Instrumente: %2</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::EditCurvesTool</name>
    <message>
        <source>Mark as non-vessel</source>
        <translation>Als Nicht-Gefäß markieren</translation>
    </message>
    <message>
        <source>Edit vessels: tracing this frame…</source>
        <translation>Gefäße bearbeiten: Bild wird erfasst…</translation>
    </message>
    <message>
        <source>Erase: brush over curves, [ ] brush size, Esc ends</source>
        <translation>Radieren: über Kurven streichen, [ ] Pinselgröße, Esc beendet</translation>
    </message>
    <message>
        <source>Draw: click along the vessel, Enter ends, Backspace removes a point, Shift draws straight lines</source>
        <translation>Zeichnen: am Gefäß entlang klicken, Eingabe beendet, Rücktaste entfernt einen Punkt, Umschalt gerade</translation>
    </message>
    <message>
        <source>Cut: click where to split a curve, Esc ends</source>
        <translation>Trennen: klicken, wo eine Kurve geteilt werden soll, Esc beendet</translation>
    </message>
    <message>
        <source>Not a vessel: click a curve to exclude it, Esc ends</source>
        <translation>Kein Gefäß: Kurve anklicken, um sie auszuschließen, Esc beendet</translation>
    </message>
    <message>
        <source>Box: drag around non-vessels; Ctrl keeps only the inside, Esc ends</source>
        <translation>Rahmen: um Nicht-Gefäße ziehen; Strg behält nur das Innere, Esc beendet</translation>
    </message>
    <message>
        <source>Lasso: draw around non-vessels; Ctrl keeps only the inside, Esc ends</source>
        <translation>Lasso: Nicht-Gefäße umfahren; Strg behält nur das Innere, Esc beendet</translation>
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
        <source>Exclude a region</source>
        <translation>Bereich ausschließen</translation>
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
        <source>Possible catheter: A keep as vessel, W mark as catheter or guidewire, Delete exclude, S next</source>
        <translation>Möglicher Katheter: A Gefäß, W Katheter oder Führungsdraht, Entf schließt aus, S nächster</translation>
    </message>
    <message>
        <source>Catheter or guidewire: click a curve to mark or unmark it as a device, Esc ends</source>
        <translation>Katheter oder Führungsdraht: Kurve anklicken, um sie als Instrument zu markieren oder dies aufzuheben, Esc beendet</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ExportDialog</name>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Print resolution</source>
        <translation>Druckauflösung</translation>
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
        <source>Image only</source>
        <translation>Nur das Bild</translation>
    </message>
    <message>
        <source>16-bit gray values of the image</source>
        <translation>16-Bit-Grauwerte des Bildes</translation>
    </message>
    <message>
        <source>PNG (raster)</source>
        <translation>PNG (Rastergrafik)</translation>
    </message>
    <message>
        <source>SVG (vector)</source>
        <translation>SVG (Vektorgrafik)</translation>
    </message>
    <message>
        <source>PDF (vector)</source>
        <translation>PDF (Vektorgrafik)</translation>
    </message>
    <message>
        <source>same size as the frame</source>
        <translation>so groß wie das Einzelbild</translation>
    </message>
    <message>
        <source>%1 × %2 px, %3 × %4 cm</source>
        <translation>%1 × %2 px, %3 × %4 cm</translation>
    </message>
    <message>
        <source>The image is labeled “Not for clinical use”; inputs, method and pose are stored in its metadata (16-bit images carry the label in the metadata only).</source>
        <translation>Das Bild ist mit „Nicht für den klinischen Einsatz“ beschriftet; Eingaben, Methode und Lage stehen in seinen Metadaten (16-Bit-Bilder tragen die Beschriftung nur in den Metadaten).</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Residual colors with scale</source>
        <translation>Residuenfarben mit Skala</translation>
    </message>
    <message>
        <source>Burn in patient identity</source>
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
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>English labels</source>
        <translation>Englische Beschriftung</translation>
    </message>
    <message>
        <source>Swipe or lens as in the window</source>
        <translation>Wischen oder Lupe wie im Fenster</translation>
    </message>
    <message>
        <source>Side by side with initial pose</source>
        <translation>Neben der Startlage</translation>
    </message>
    <message>
        <source>two images, %1 each</source>
        <translation>zwei Bilder, je %1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::FrameBars</name>
    <message>
        <source>R wave</source>
        <translation>R-Zacke</translation>
    </message>
    <message>
        <source>Drag the ends to play part of the run; double-click to play the whole run</source>
        <translation>Enden ziehen, um einen Teil der Serie abzuspielen; Doppelklick spielt die ganze Serie ab</translation>
    </message>
    <message>
        <source>Opacification of the frames</source>
        <translation>Kontrastierung der Bilder</translation>
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
        <source>peak-opacification frame</source>
        <translation>Bild maximaler Kontrastierung</translation>
    </message>
    <message>
        <source>mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>Shift+drag marks mask frames; double-click shows the opacification curve</source>
        <translation>Umschalt+Ziehen markiert Maskenbilder; Doppelklick zeigt die Kontrastierungskurve</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::GeometryPanel</name>
    <message>
        <source>enter value</source>
        <translation>Wert eingeben</translation>
    </message>
    <message>
        <source>SID</source>
        <translation>SID</translation>
    </message>
    <message>
        <source>Source-to-detector distance</source>
        <translation>Abstand Fokus–Detektor</translation>
    </message>
    <message>
        <source>SOD</source>
        <translation>SOD</translation>
    </message>
    <message>
        <source>Source-to-isocenter distance</source>
        <translation>Abstand Fokus–Isozentrum</translation>
    </message>
    <message>
        <source>pixel spacing</source>
        <translation>Pixelgröße</translation>
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
        <translation>Sekundärwinkel: CRA positiv, CAU negativ</translation>
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
        <source>entered</source>
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
        <source>Use typical values</source>
        <translation>Typische Werte verwenden</translation>
    </message>
    <message>
        <source>Use distances and spacing instead</source>
        <translation>Stattdessen Abstände und Pixelgröße verwenden</translation>
    </message>
    <message>
        <source>Fills in missing values only: SID 1000 mm, SOD 750 mm, pixel spacing 0.3 mm, angles 0°.</source>
        <translation>Ersetzt nur fehlende Werte: SID 1000 mm, SOD 750 mm, Pixelgröße 0,3 mm, Winkel 0°.</translation>
    </message>
    <message>
        <source>Camera from the case file: f %1 px, principal point %2, %3 px, %4.</source>
        <translation>Kamera aus der Falldatei: f %1 px, Hauptpunkt %2, %3 px, %4.</translation>
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
        <source>Roll, principal point, isocenter</source>
        <translation>Rollwinkel, Hauptpunkt, Isozentrum</translation>
    </message>
    <message>
        <source>DICOM header values</source>
        <translation>DICOM-Header-Werte</translation>
    </message>
    <message>
        <source>from the detector</source>
        <translation>vom Detektor</translation>
    </message>
    <message>
        <source>Viewing side of the image</source>
        <translation>Betrachtungsseite des Bildes</translation>
    </message>
    <message>
        <source>Angiograms are normally shown as seen from the detector. In a mirrored export, left and right are swapped; the projection is then mirrored together with the image, but the vessels themselves never are.</source>
        <translation>Angiogramme werden normalerweise wie vom Detektor gesehen gezeigt. In einem gespiegelten Export sind links und rechts vertauscht; die Projektion wird dann mit dem Bild gespiegelt, die Gefäße selbst nie.</translation>
    </message>
    <message>
        <source>viewing side</source>
        <translation>Betrachtungsseite</translation>
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
        <source>The header contains no pixel spacing; this value is derived. Press Enter in the field to confirm the value, or enter another one.</source>
        <translation>Der Header enthält keine Pixelgröße; dieser Wert ist abgeleitet. Bestätigen Sie ihn im Feld mit der Eingabetaste, oder geben Sie einen anderen ein.</translation>
    </message>
    <message>
        <source>The image is assumed to be mirrored (%1). Check left and right.</source>
        <translation>Das Bild gilt als gespiegelt (%1). Prüfen Sie links und rechts.</translation>
    </message>
    <message>
        <source>The gantry rotates during this run: by %1° in LAO/RAO and %2° in CRA/CAU from the first frame to this one.</source>
        <translation>Der C-Bogen dreht sich in dieser Serie: vom ersten bis zu diesem Bild um %1° LAO/RAO und %2° CRA/CAU.</translation>
    </message>
    <message>
        <source>Pixel spacing at the detector. Press Enter to confirm a derived value.</source>
        <translation>Pixelgröße auf dem Detektor. Die Eingabetaste bestätigt einen abgeleiteten Wert.</translation>
    </message>
    <message>
        <source>detector width</source>
        <translation>Detektorbreite</translation>
    </message>
    <message>
        <source>Width of the image at the detector; determines the pixel spacing</source>
        <translation>Breite des Bildes auf dem Detektor; bestimmt die Pixelgröße</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Clockwise rotation of the image</source>
        <translation>Drehung des Bildes im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>center x</source>
        <translation>Mitte x</translation>
    </message>
    <message>
        <source>Column in which the central ray meets the detector; 0 is the center of the first column</source>
        <translation>Spalte, in der der Zentralstrahl den Detektor trifft; 0 ist die Mitte der ersten Spalte</translation>
    </message>
    <message>
        <source>center y</source>
        <translation>Mitte y</translation>
    </message>
    <message>
        <source>Row in which the central ray meets the detector; 0 is the center of the first row</source>
        <translation>Zeile, in der der Zentralstrahl den Detektor trifft; 0 ist die Mitte der ersten Zeile</translation>
    </message>
    <message>
        <source>isocenter L</source>
        <translation>Isozentrum L</translation>
    </message>
    <message>
        <source>Gantry rotation center in vessel coordinates: left</source>
        <translation>Drehzentrum des C-Bogens in Gefäßkoordinaten: links</translation>
    </message>
    <message>
        <source>isocenter P</source>
        <translation>Isozentrum P</translation>
    </message>
    <message>
        <source>Gantry rotation center in vessel coordinates: posterior</source>
        <translation>Drehzentrum des C-Bogens in Gefäßkoordinaten: posterior</translation>
    </message>
    <message>
        <source>isocenter H</source>
        <translation>Isozentrum H</translation>
    </message>
    <message>
        <source>Gantry rotation center in vessel coordinates: head</source>
        <translation>Drehzentrum des C-Bogens in Gefäßkoordinaten: Kopf</translation>
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
        <source>Bad: rotated</source>
        <translation>Schlecht: verdreht</translation>
    </message>
    <message>
        <source>Bad: wrong gantry angle</source>
        <translation>Schlecht: falscher Gantrywinkel</translation>
    </message>
    <message>
        <source>The lines follow the vessel centers and are blue throughout, including in the side branches.</source>
        <translation>Die Linien verlaufen in der Mitte ihrer Gefäße, durchgehend blau, auch in den Seitenästen.</translation>
    </message>
    <message>
        <source>Amber only where there is no contrast agent in this frame; every opacified vessel is blue.</source>
        <translation>Orange nur, wo dieses Bild kein Kontrastmittel zeigt; jedes kontrastierte Gefäß ist blau.</translation>
    </message>
    <message>
        <source>Small deviations to both sides due to heartbeat and breathing; no rigid pose fits better.</source>
        <translation>Kleine Abweichungen nach beiden Seiten durch Herzschlag und Atmung. Keine starre Lage passt besser.</translation>
    </message>
    <message>
        <source>All lines are shifted to the same side. Register again, or nudge with the arrow keys.</source>
        <translation>Alle Linien liegen zur selben Seite daneben. Registrieren Sie neu, oder justieren Sie mit den Pfeiltasten.</translation>
    </message>
    <message>
        <source>The lines fit in the center but deviate increasingly toward the edges: the pose is rotated in the image plane.</source>
        <translation>Die Linien passen in der Mitte und weichen nach außen zunehmend ab: Die Lage ist in der Bildebene verdreht.</translation>
    </message>
    <message>
        <source>The trunk fits, but the side branches run in other directions: LAO/RAO or CRA/CAU is wrong.</source>
        <translation>Der Stamm passt, aber die Seitenäste verlaufen in andere Richtungen: LAO/RAO oder CRA/CAU stimmt nicht.</translation>
    </message>
    <message>
        <source>Examples of good and bad fits</source>
        <translation>Beispiele guter und schlechter Registrierungen</translation>
    </message>
    <message>
        <source>Simulated vessels. Blue: on a vessel. Amber: off by 2 mm or more.</source>
        <translation>Simulierte Gefäße. Blau: auf einem Gefäß. Orange: 2 mm oder mehr daneben.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>drawing…</source>
        <translation>wird gezeichnet…</translation>
    </message>
    <message>
        <source>Good: everything fits</source>
        <translation>Gut: alles passt</translation>
    </message>
    <message>
        <source>Good: unopacified branches</source>
        <translation>Gut: nicht kontrastierte Äste</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::HeaderBar</name>
    <message>
        <source>Not for clinical use</source>
        <translation>Nicht für den klinischen Einsatz</translation>
    </message>
    <message>
        <source>AngioPose is research software, not a medical device.</source>
        <translation>AngioPose ist Forschungssoftware, kein Medizinprodukt.</translation>
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
        <translation>Histogramm der Residuen</translation>
    </message>
    <message>
        <source>no residuals yet</source>
        <translation>noch keine Residuen</translation>
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
        <source>move away from or toward the source</source>
        <translation>vom Fokus weg oder zu ihm hin</translation>
    </message>
    <message>
        <source>, .</source>
        <translation>, .</translation>
    </message>
    <message>
        <source>roll by 1°</source>
        <translation>um 1° rollen</translation>
    </message>
    <message>
        <source>Alt+arrows</source>
        <translation>Alt+Pfeile</translation>
    </message>
    <message>
        <source>rotate LAO/RAO and CRA/CAU by 1°</source>
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
        <source>select a branch (Ctrl adds)</source>
        <translation>Ast auswählen (Strg fügt hinzu)</translation>
    </message>
    <message>
        <source>In nudge mode</source>
        <translation>Im Justiermodus</translation>
    </message>
    <message>
        <source>In the angiogram</source>
        <translation>Im Angiogramm</translation>
    </message>
    <message>
        <source>move; drag the ring to roll; Esc reverts, then ends the mode</source>
        <translation>schieben; am Ring rollen; Esc macht rückgängig, dann endet der Modus</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Strg+Rad</translation>
    </message>
    <message>
        <source>right-click</source>
        <translation>Rechtsklick</translation>
    </message>
    <message>
        <source>context menu</source>
        <translation>Kontextmenü</translation>
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
        <source>double-click</source>
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
        <source>In the 3-D view</source>
        <translation>In der 3-D-Ansicht</translation>
    </message>
    <message>
        <source>set one pair: click in 3-D or in a slice, then in the image</source>
        <translation>in 3-D oder einer Schicht, dann im Bild: setzt ein Paar</translation>
    </message>
    <message>
        <source>drag a vessel node to its position, or move a landmark cross</source>
        <translation>Gefäßknoten an seinen Ort ziehen oder Landmarkenkreuz verschieben</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>register the vessels from the landmark pairs</source>
        <translation>Gefäße anhand der Paare registrieren</translation>
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
        <source>exclude curves that are not vessels</source>
        <translation>Kurven, die keine Gefäße sind, ausschließen</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>erase with a brush; [ ] changes its size</source>
        <translation>mit dem Pinsel radieren; [ ] ändert die Größe</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>draw: Enter ends, Backspace removes a point, Shift draws straight lines</source>
        <translation>zeichnen: Eingabe beendet, Rücktaste entfernt einen Punkt, Umschalt gerade</translation>
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
        <source>box or lasso around non-vessels; Ctrl: keep only the inside</source>
        <translation>Rahmen oder Lasso um Nicht-Gefäße; Strg: nur das Innere behalten</translation>
    </message>
    <message>
        <source>✓ ✗</source>
        <translation>✓ ✗</translation>
    </message>
    <message>
        <source>dashed curves may be catheters: keep or exclude them</source>
        <translation>gestrichelte Kurven sind möglicherweise ein Katheter: behalten oder ausschließen</translation>
    </message>
    <message>
        <source>click, left drag, Ctrl+arrows</source>
        <translation>klicken, links ziehen, Strg+Pfeile</translation>
    </message>
    <message>
        <source>crosshair, linked across all views</source>
        <translation>Fadenkreuz, mit allen Ansichten gekoppelt</translation>
    </message>
    <message>
        <source>pick the point at the crosshair (same as a click)</source>
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
        <source>window and level; right-click opens the menu</source>
        <translation>Fensterung; Rechtsklick öffnet das Menü</translation>
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
        <source>enlarge all slices, or restore</source>
        <translation>alle Schichten groß zeigen, oder wiederherstellen</translation>
    </message>
    <message>
        <source>While picking landmarks</source>
        <translation>Beim Setzen von Landmarken</translation>
    </message>
    <message>
        <source>While editing vessels</source>
        <translation>Beim Bearbeiten der Gefäße</translation>
    </message>
    <message>
        <source>In a slice</source>
        <translation>In einer Schicht</translation>
    </message>
    <message>
        <source>show only this view, or restore</source>
        <translation>nur diese Ansicht zeigen, oder wiederherstellen</translation>
    </message>
    <message>
        <source>S, then A or Del</source>
        <translation>S, dann A oder Entf</translation>
    </message>
    <message>
        <source>next dashed curve: keep or exclude</source>
        <translation>nächste gestrichelte Kurve: behalten oder ausschließen</translation>
    </message>
    <message>
        <source>While setting the rotation center</source>
        <translation>Beim Setzen des Drehzentrums</translation>
    </message>
    <message>
        <source>a point on the vessels, in the image, in 3-D or in a slice</source>
        <translation>ein Punkt auf den Gefäßen, im Bild, in 3-D oder in einer Schicht</translation>
    </message>
    <message>
        <source>← →</source>
        <translation>← →</translation>
    </message>
    <message>
        <source>next bifurcation or branch end</source>
        <translation>nächste Bifurkation oder nächstes Astende</translation>
    </message>
    <message>
        <source>accept the point shown</source>
        <translation>gezeigten Punkt übernehmen</translation>
    </message>
    <message>
        <source>reset to the centroid</source>
        <translation>auf den Schwerpunkt zurücksetzen</translation>
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
        <source>set a point, or move an existing one</source>
        <translation>Punkt setzen oder vorhandenen verschieben</translation>
    </message>
    <message>
        <source>Enter, double-click</source>
        <translation>Eingabe, Doppelklick</translation>
    </message>
    <message>
        <source>close an area</source>
        <translation>Fläche schließen</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Rücktaste</translation>
    </message>
    <message>
        <source>remove the last point</source>
        <translation>letzten Punkt entfernen</translation>
    </message>
    <message>
        <source>remove the selected measurement or the last one</source>
        <translation>entfernt die gewählte Messung oder die letzte</translation>
    </message>
    <message>
        <source>While marking</source>
        <translation>Beim Markieren</translation>
    </message>
    <message>
        <source>add a target point or ring to the vessels, here, in 3-D or in a slice</source>
        <translation>setzt Zielpunkt oder Ring auf die Gefäße, hier, in 3-D oder in einer Schicht</translation>
    </message>
    <message>
        <source>draw an arrow or move an existing mark</source>
        <translation>zeichnet einen Pfeil oder verschiebt eine Markierung</translation>
    </message>
    <message>
        <source>finish the text; Esc discards it</source>
        <translation>beendet einen Text; Esc verwirft ihn</translation>
    </message>
    <message>
        <source>remove the selected mark or the last one</source>
        <translation>entfernt die gewählte Markierung oder die letzte</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::KeySheet</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Search shortcuts and commands</source>
        <translation>Tastenkürzel und Befehle suchen</translation>
    </message>
    <message>
        <source>Search shortcuts</source>
        <translation>Tastenkürzel suchen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>No shortcut for “%1”.</source>
        <translation>Kein Tastenkürzel für „%1“.</translation>
    </message>
    <message>
        <source>Shortcuts and their commands</source>
        <translation>Tastenkürzel und ihre Befehle</translation>
    </message>
    <message>
        <source>Reset all shortcuts</source>
        <translation>Alle Kürzel zurücksetzen</translation>
    </message>
    <message>
        <source>Double-click a command or press Enter to assign a shortcut.</source>
        <translation>Doppelklick auf einen Befehl oder Eingabetaste weist ein Tastenkürzel zu.</translation>
    </message>
    <message>
        <source>This shortcut is fixed.</source>
        <translation>Dieses Tastenkürzel ist fest vorgegeben.</translation>
    </message>
    <message>
        <source>Press the new shortcut for “%1”. Esc keeps the old shortcut; Delete removes it.</source>
        <translation>Drücken Sie das neue Tastenkürzel für „%1“. Esc behält das alte, Entf entfernt es.</translation>
    </message>
    <message>
        <source>The old shortcut is kept.</source>
        <translation>Das alte Tastenkürzel bleibt.</translation>
    </message>
    <message>
        <source>“%1” is reserved. Press another key.</source>
        <translation>„%1“ ist reserviert. Drücken Sie eine andere Taste.</translation>
    </message>
    <message>
        <source>“%1” is assigned to “%2”. Press it again to reassign it, or press another key.</source>
        <translation>„%1“ ist „%2“ zugewiesen. Drücken Sie es nochmals, um es neu zuzuweisen, oder eine andere Taste.</translation>
    </message>
    <message>
        <source>Shortcut removed.</source>
        <translation>Tastenkürzel entfernt.</translation>
    </message>
    <message>
        <source>The shortcut is now “%1”.</source>
        <translation>Das Tastenkürzel ist jetzt „%1“.</translation>
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
        <source>Selects all labels in the list</source>
        <translation>Wählt alle Labels der Liste aus</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Deselects all labels in the list</source>
        <translation>Hebt die Auswahl aller Labels auf</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>Gefäße</translation>
    </message>
    <message>
        <source>Selects the labels whose names indicate vessels</source>
        <translation>Wählt die Labels aus, deren Namen Gefäße bezeichnen</translation>
    </message>
    <message>
        <source>Find a label</source>
        <translation>Label suchen</translation>
    </message>
    <message>
        <source>Vessel labels</source>
        <translation>Gefäßlabels</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>Reading the labels…</source>
        <translation>Labels werden gelesen…</translation>
    </message>
    <message>
        <source>%1 of %2 selected, %3</source>
        <translation>%1 von %2 ausgewählt, %3</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::LandmarkPanel</name>
    <message>
        <source>Landmarks</source>
        <translation>Landmarken</translation>
    </message>
    <message>
        <source>Compute pose</source>
        <translation>Lage berechnen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Landmarks and their residuals</source>
        <translation>Landmarken und ihre Residuen</translation>
    </message>
    <message>
        <source>Computes the initial pose from the pairs, as does pressing Enter while picking. Undo restores the previous pose.</source>
        <translation>Berechnet die Startlage aus den Paaren, ebenso die Eingabetaste beim Setzen. Rückgängig stellt die vorige wieder her.</translation>
    </message>
    <message>
        <source>Removes the selected pairs (Delete)</source>
        <translation>Entfernt die gewählten Paare (Entf)</translation>
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
        <source>Pick pairs</source>
        <translation>Paare setzen</translation>
    </message>
    <message>
        <source>Click a point on the vessels in 3-D (or a slice), then the same point in the image.</source>
        <translation>Klicken Sie auf eine Stelle der Gefäße in 3-D (oder in einer Schicht), dann auf dieselbe im Bild.</translation>
    </message>
    <message>
        <source>%1: click pairs, then compute</source>
        <translation>%1: Paare klicken, dann berechnen</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::LandmarkTool</name>
    <message>
        <source>Landmarks: now click the same point in the image</source>
        <translation>Landmarken: jetzt dieselbe Stelle im Bild anklicken</translation>
    </message>
    <message>
        <source>Landmarks: now click the same point on the vessels in 3-D</source>
        <translation>Landmarken: jetzt dieselbe Stelle der Gefäße in 3-D anklicken</translation>
    </message>
    <message>
        <source>Landmarks: click in 3-D and here, or drag a node · Enter computes the pose</source>
        <translation>Landmarken: in 3-D und hier klicken oder Knoten ziehen · Eingabe berechnet die Lage</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::LassoTool</name>
    <message>
        <source>Lasso: draw around the auxiliary branches · Shift adds · Ctrl removes · Esc ends</source>
        <translation>Lasso: Hilfsäste umfahren · Umschalt fügt hinzu · Strg entfernt · Esc beendet</translation>
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
        <source>Pixel shift: arrow keys or drag, Shift 1 px, Ctrl 0.05 px, Esc ends · right %1, down %2 px</source>
        <translation>Pixelshift: Pfeiltasten oder Ziehen, Umschalt 1 px, Strg 0,05 px, Esc beendet · rechts %1, unten %2 px</translation>
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
        <source>Inputs not found</source>
        <translation>Eingaben nicht gefunden</translation>
    </message>
    <message>
        <source>“%1” refers to files that have been moved or deleted. The files were not found next to the case or in the folders of recent cases. The case file itself is intact.</source>
        <translation>„%1“ verweist auf Dateien, die verschoben oder gelöscht wurden. Die Dateien wurden weder neben dem Fall noch in den Ordnern der letzten Fälle gefunden. Die Falldatei selbst ist unbeschädigt.</translation>
    </message>
    <message>
        <source>formerly in %1</source>
        <translation>war in %1</translation>
    </message>
    <message>
        <source>Locate…</source>
        <translation>Suchen…</translation>
    </message>
    <message>
        <source>Locate %1</source>
        <translation>%1 suchen</translation>
    </message>
    <message>
        <source>Search a folder…</source>
        <translation>Ordner durchsuchen…</translation>
    </message>
    <message>
        <source>Searches the folder and its subfolders by file name and contents.</source>
        <translation>Durchsucht den Ordner und seine Unterordner nach Dateiname und Inhalt.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>now: %1</source>
        <translation>jetzt: %1</translation>
    </message>
    <message>
        <source>Search a folder</source>
        <translation>Ordner durchsuchen</translation>
    </message>
    <message>
        <source>Open anyway</source>
        <translation>Trotzdem öffnen</translation>
    </message>
    <message>
        <source>Only an additional scan or another view is missing. Everything else can be opened.</source>
        <translation>Es fehlt nur ein zusätzlicher Scan oder eine weitere Ansicht. Alles andere lässt sich öffnen.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MotionPlot</name>
    <message>
        <source>Vessel motion by frame</source>
        <translation>Gefäßbewegung je Bild</translation>
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
        <source>frame %1: %2 mm in plane, %3 mm in depth, %4°</source>
        <translation>Bild %1: %2 mm in der Bildebene, %3 mm in der Tiefe, %4°</translation>
    </message>
    <message>
        <source>%1 (not explained by the vessels)</source>
        <translation>%1 (durch die Gefäße nicht erklärt)</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::NudgeTool</name>
    <message>
        <source>Nudge: drag to move · ring to roll · arcs to tilt · slider for depth · Ctrl = fine · Esc cancels</source>
        <translation>Justieren: Ziehen verschiebt · Ring rollt · Bögen kippen · Regler Tiefe · Strg = fein · Esc bricht ab</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::OpacificationPlot</name>
    <message>
        <source>Opacification by frame</source>
        <translation>Kontrastierung je Bild</translation>
    </message>
    <message>
        <source>%1 · %2 s</source>
        <translation>%1 · %2 s</translation>
    </message>
    <message>
        <source>The curve requires a run with several frames</source>
        <translation>Die Kurve erfordert eine Serie mit mehreren Bildern</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PivotMark</name>
    <message>
        <source>rotation center</source>
        <translation>Drehzentrum</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PivotTool</name>
    <message>
        <source>Rotation center: click the vessels, here or in 3-D · ← → and Enter: bifurcations · Del: centroid</source>
        <translation>Drehzentrum: Gefäße anklicken, hier oder in 3-D · ← → und Eingabe: Verzweigungen · Entf: Schwerpunkt</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PortDialog</name>
    <message>
        <source>Encrypted (TLS)</source>
        <translation>Verschlüsselt (TLS)</translation>
    </message>
    <message>
        <source>Local certificate (PEM)</source>
        <translation>Eigenes Zertifikat (PEM)</translation>
    </message>
    <message>
        <source>Private key of the local certificate (PEM)</source>
        <translation>Privater Schlüssel des eigenen Zertifikats (PEM)</translation>
    </message>
    <message>
        <source>Trusted certificates (PEM)</source>
        <translation>Vertrauenswürdige Zertifikate (PEM)</translation>
    </message>
    <message>
        <source>Security of the receiving port</source>
        <translation>Sicherheit des Empfangsports</translation>
    </message>
    <message>
        <source>With TLS, both the calling application and this program must present a valid certificate.</source>
        <translation>Mit TLS müssen die aufrufende Anwendung und dieses Programm ein gültiges Zertifikat vorlegen.</translation>
    </message>
    <message>
        <source>anyone</source>
        <translation>jeder</translation>
    </message>
    <message>
        <source>Allowed calling AE titles</source>
        <translation>Zugelassene rufende AE-Titel</translation>
    </message>
    <message>
        <source>Comma-separated; leave empty to allow any</source>
        <translation>Durch Kommas getrennt; leer: alle</translation>
    </message>
    <message>
        <source>Allowed addresses</source>
        <translation>Zugelassene Adressen</translation>
    </message>
    <message>
        <source>Comma-separated IP addresses, such as 10.0.0.7; leave empty to allow any</source>
        <translation>IP-Adressen, durch Kommas getrennt, z. B. 10.0.0.7; leer: alle</translation>
    </message>
    <message>
        <source>Local certificate</source>
        <translation>Eigenes Zertifikat</translation>
    </message>
    <message>
        <source>PEM file presented to calling applications</source>
        <translation>PEM-Datei, die aufrufenden Anwendungen vorgelegt wird</translation>
    </message>
    <message>
        <source>Private key</source>
        <translation>Privater Schlüssel</translation>
    </message>
    <message>
        <source>PEM file; only its path is stored</source>
        <translation>PEM-Datei; nur ihr Pfad wird gespeichert</translation>
    </message>
    <message>
        <source>Trusted certificates</source>
        <translation>Vertrauenswürdige Zertifikate</translation>
    </message>
    <message>
        <source>PEM file used to verify the certificates of calling applications; if empty, the certificates trusted by the system are used</source>
        <translation>PEM-Datei zum Prüfen der Zertifikate aufrufender Anwendungen; leer: die vom System als vertrauenswürdig eingestuften</translation>
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
        <source>depth</source>
        <translation>Tiefe</translation>
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
        <source>Equivalent to rotating the C-arm toward LAO (+) or RAO (−). Nudge: Alt+← Alt+→</source>
        <translation>Entspricht einer Drehung des C-Bogens nach LAO (+) oder RAO (−). Justieren: Alt+← Alt+→</translation>
    </message>
    <message>
        <source>Equivalent to rotating the C-arm cranially (+) or caudally (−). Nudge: Alt+↑ Alt+↓</source>
        <translation>Entspricht einer Drehung des C-Bogens nach kranial (+) oder kaudal (−). Justieren: Alt+↑ Alt+↓</translation>
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
        <source>Reset to initial pose</source>
        <translation>Auf Startlage zurücksetzen</translation>
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
        <source>Locks this value: nudging, dragging, typing and registration do not change it.</source>
        <translation>Sperrt diesen Wert: Justieren, Ziehen, Eingeben und Registrieren ändern ihn nicht.</translation>
    </message>
    <message>
        <source>Undo restores the pose.</source>
        <translation>Rückgängig stellt die Lage wieder her.</translation>
    </message>
    <message>
        <source>nudging · arrow keys · %1 to exit</source>
        <translation>Justieren · Pfeiltasten · %1 beendet</translation>
    </message>
    <message>
        <source>%1: nudge (Ctrl fine, Shift coarse)</source>
        <translation>%1: justieren (Strg fein, Umschalt grob)</translation>
    </message>
    <message>
        <source>Rotations and translations refer to the selected rotation center. %1 resets it to the centroid.</source>
        <translation>Drehungen und Verschiebungen beziehen sich auf das gewählte Drehzentrum. %1 setzt es auf den Schwerpunkt zurück.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PoseTable</name>
    <message>
        <source>Run</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Runs the selected methods one after another from the current pose.</source>
        <translation>Startet die gewählten Methoden nacheinander von der aktuellen Lage aus.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Stops the running method and skips the rest; finished results are kept.</source>
        <translation>Hält die laufende Methode an und überspringt den Rest; fertige Ergebnisse bleiben erhalten.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Moves the vessels to this pose; can be undone.</source>
        <translation>Bringt die Gefäße in diese Lage; lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>Use as reference</source>
        <translation>Als Referenz verwenden</translation>
    </message>
    <message>
        <source>Shows differences relative to this pose.</source>
        <translation>Zeigt Unterschiede relativ zu dieser Lage.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Deletes the snapshots; can be undone.</source>
        <translation>Löscht die Snapshots; lässt sich rückgängig machen.</translation>
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
        <source>Median (mm)</source>
        <translation>Median (mm)</translation>
    </message>
    <message>
        <source>P95 (mm)</source>
        <translation>P95 (mm)</translation>
    </message>
    <message>
        <source>Coverage (%)</source>
        <translation>Abdeckung (%)</translation>
    </message>
    <message>
        <source>Δ in-plane (mm)</source>
        <translation>Δ Bildebene (mm)</translation>
    </message>
    <message>
        <source>Δ depth (mm)</source>
        <translation>Δ Tiefe (mm)</translation>
    </message>
    <message>
        <source>Δ rot. (°)</source>
        <translation>Δ Rot. (°)</translation>
    </message>
    <message>
        <source>Time (ms)</source>
        <translation>Zeit (ms)</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Autor</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>CSV exportieren…</translation>
    </message>
    <message>
        <source>Writes the table to a CSV file, with the poses as matrices.</source>
        <translation>Schreibt die Tabelle in eine CSV-Datei, die Lagen als Matrizen.</translation>
    </message>
    <message>
        <source>Run several methods</source>
        <translation>Mehrere Methoden ausführen</translation>
    </message>
    <message>
        <source>Results are added to the table; the case is unchanged</source>
        <translation>Ergebnisse kommen in die Tabelle; der Fall bleibt unverändert</translation>
    </message>
    <message>
        <source>Current pose</source>
        <translation>Aktuelle Lage</translation>
    </message>
    <message>
        <source>This registration is not reliable.</source>
        <translation>Diese Registrierung ist nicht verlässlich.</translation>
    </message>
    <message>
        <source>Differences are relative to “%1”, about the center of the tree. Amber: not reliable.</source>
        <translation>Unterschiede relativ zu „%1“, um die Mitte des Gefäßbaums. Orange: nicht verlässlich.</translation>
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
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove terminal branches that are</source>
        <translation>Endäste entfernen, die</translation>
    </message>
    <message>
        <source>shorter than</source>
        <translation>kürzer sind als</translation>
    </message>
    <message>
        <source>thinner than (mean radius)</source>
        <translation>dünner sind als (mittlerer Radius)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>No branch would remain. Lower the limits.</source>
        <translation>Es bliebe kein Ast übrig. Senken Sie die Grenzen.</translation>
    </message>
    <message>
        <source>Nothing to remove.</source>
        <translation>Nichts zu entfernen.</translation>
    </message>
    <message>
        <source>1 branch will be removed.</source>
        <translation>1 Ast wird entfernt.</translation>
    </message>
    <message>
        <source>%1 branches will be removed.</source>
        <translation>%1 Äste werden entfernt.</translation>
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
        <translation>Ungespeicherte Arbeit wiederherstellen?</translation>
    </message>
    <message>
        <source>AngioPose ended unexpectedly. These cases had unsaved changes. “Recover” opens the copy and leaves the saved case unchanged.</source>
        <translation>AngioPose wurde unerwartet beendet. Diese Fälle hatten ungespeicherte Änderungen. „Wiederherstellen“ öffnet die Kopie und lässt den gespeicherten Fall unverändert.</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Nicht jetzt</translation>
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
        <source>Stops the registration and keeps the best pose so far.</source>
        <translation>Hält die Registrierung an und behält die bisher beste Lage.</translation>
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
        <source>Explains which cost this method minimizes, when the method fails, and where it was published.</source>
        <translation>Erklärt, welche Kosten diese Methode minimiert, wann sie versagt und wo sie veröffentlicht ist.</translation>
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
        <source>Registering…</source>
        <translation>Wird registriert…</translation>
    </message>
    <message>
        <source>Registration keeps the locked degree of freedom fixed.</source>
        <translation>Die Registrierung hält den gesperrten Freiheitsgrad fest.</translation>
    </message>
    <message>
        <source>Registration keeps the %1 locked degrees of freedom fixed.</source>
        <translation>Die Registrierung hält die %1 gesperrten Freiheitsgrade fest.</translation>
    </message>
    <message>
        <source>Register all %1 views jointly</source>
        <translation>Alle %1 Ansichten gemeinsam</translation>
    </message>
    <message>
        <source>Finds the pose that aligns the vessels with the angiogram.</source>
        <translation>Findet die Lage, die die Gefäße mit dem Angiogramm zur Deckung bringt.</translation>
    </message>
    <message>
        <source>Uses one pose for all views. Moving the vessels manually moves them in every view. Registration fits all views jointly with the method AngioPose: the depth in one view is then determined by the in-plane translation in another. If off, only the displayed view is used.</source>
        <translation>Verwendet eine Lage für alle Ansichten. Manuelles Verschieben bewegt die Gefäße in jeder Ansicht. Die Registrierung passt alle Ansichten gemeinsam mit der Methode AngioPose an: Die Tiefe der einen Ansicht wird dann durch die Verschiebung in der Bildebene der anderen bestimmt. Ohne Haken wird nur die gezeigte Ansicht verwendet.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ResultPanel</name>
    <message>
        <source>%1 · from an earlier registration</source>
        <translation>%1 · aus einer früheren Registrierung</translation>
    </message>
    <message>
        <source>The inputs have changed since this registration. Press R to update.</source>
        <translation>Eingaben haben sich seit dieser Registrierung geändert. R registriert neu.</translation>
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
        <source>%1 · moved manually</source>
        <translation>%1 · manuell verschoben</translation>
    </message>
    <message>
        <source>%1 · initial pose</source>
        <translation>%1 · Startlage</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>Residuen</translation>
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
        <source>P95, mm</source>
        <translation>P95, mm</translation>
    </message>
    <message>
        <source>coverage</source>
        <translation>Abdeckung</translation>
    </message>
    <message>
        <source>Share of the traced vessel length that lies within 3 px of the tree.</source>
        <translation>Anteil der erkannten Gefäßlänge, der höchstens 3 px vom Gefäßbaum entfernt ist.</translation>
    </message>
    <message>
        <source>± is one standard deviation.</source>
        <translation>± ist eine Standardabweichung.</translation>
    </message>
    <message>
        <source>nothing to assess yet</source>
        <translation>noch nichts zu beurteilen</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Initial pose, not registered yet. Press R to register, N to nudge.</source>
        <translation>Startlage, noch nicht registriert. R registriert, N justiert.</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>in-plane (mm), by frame</source>
        <translation>mm in der Bildebene, je Bild</translation>
    </message>
    <message>
        <source>%1 · tracked</source>
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
        <source>median %1 mm over the %2 % classified as opacified, %3 mm over the whole tree</source>
        <translation>Median %1 mm über die als kontrastiert eingestuften %2 %, ganzer Gefäßbaum %3 mm</translation>
    </message>
    <message>
        <source>median %1 mm</source>
        <translation>Median %1 mm</translation>
    </message>
    <message>
        <source>Moved manually, not registered</source>
        <translation>Manuell verschoben, nicht registriert</translation>
    </message>
    <message>
        <source>Inputs have changed since this registration</source>
        <translation>Eingaben seit dieser Registrierung geändert</translation>
    </message>
    <message>
        <source>Initial pose, not registered</source>
        <translation>Startlage, nicht registriert</translation>
    </message>
    <message>
        <source>NOT RELIABLE · %1</source>
        <translation>NICHT VERLÄSSLICH · %1</translation>
    </message>
    <message>
        <source>All checks passed · %1</source>
        <translation>Alle Prüfungen bestanden · %1</translation>
    </message>
    <message>
        <source>Median distance of the vessel points classified as opacified.</source>
        <translation>Medianer Abstand der als kontrastiert eingestuften Gefäßpunkte.</translation>
    </message>
    <message>
        <source>95th percentile of the distances of the vessel points classified as opacified.</source>
        <translation>95. Perzentil der Abstände der als kontrastiert eingestuften Gefäßpunkte.</translation>
    </message>
    <message>
        <source>mm, points classified as opacified</source>
        <translation>mm, als kontrastiert eingestufte Punkte</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ResultSentences</name>
    <message>
        <source>%1 of %2 branches agree within %3 mm.</source>
        <translation>%1 von %2 Ästen stimmen auf %3 mm überein.</translation>
    </message>
    <message>
        <source>Depth ±%1 mm: not determined by a single view.</source>
        <translation>Tiefe ±%1 mm: mit einer einzelnen Ansicht nicht bestimmbar.</translation>
    </message>
    <message>
        <source>The overlay is within 2 mm of the vessels with a probability of %1 %.</source>
        <translation>Überlagerung mit %1 % Wahrscheinlichkeit höchstens 2 mm neben den Gefäßen.</translation>
    </message>
    <message>
        <source>Depth is the least certain: ±%1 mm.</source>
        <translation>Am unsichersten ist die Tiefe: ±%1 mm.</translation>
    </message>
    <message>
        <source>%1 is %2 mm off: possibly unopacified in this frame, or displaced.</source>
        <translation>%1 weicht um %2 mm ab: in diesem Bild möglicherweise nicht kontrastiert oder verlagert.</translation>
    </message>
    <message>
        <source>%1 branches are up to %2 mm off: unopacified in this frame, or the pose is wrong.</source>
        <translation>%1 Äste weichen um bis zu %2 mm ab: in diesem Bild nicht kontrastiert, oder die Lage ist falsch.</translation>
    </message>
    <message>
        <source>%1 and %2 are up to %3 mm off: possibly unopacified in this frame, or displaced.</source>
        <translation>%1 und %2 weichen um bis zu %3 mm ab: in diesem Bild möglicherweise nicht kontrastiert oder verlagert.</translation>
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
        <source>3-D uncertainty incl. geometry: depth ±%1 mm, lateral ±%2 mm.</source>
        <translation>3-D-Unsicherheit inkl. Geometrie: Tiefe ±%1 mm, lateral ±%2 mm.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::Section</name>
    <message>
        <source>Collapse or expand %1</source>
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
        <source>%1 contains %n series.</source>
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
        <source>Series in the folder</source>
        <translation>Serien im Ordner</translation>
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
        <source>Spacing (mm)</source>
        <translation>Abstand (mm)</translation>
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
        <translation>Kein Scan</translation>
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
        <source>manual</source>
        <translation>manuell</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SnapshotPanel</name>
    <message>
        <source>median %1 mm, 95th percentile %2 mm, coverage %3 %</source>
        <translation>Median %1 mm, 95. Perzentil %2 mm, Abdeckung %3 %</translation>
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
        <source>Compare…</source>
        <translation>Vergleichen…</translation>
    </message>
    <message>
        <source>Snapshots</source>
        <translation>Snapshots</translation>
    </message>
    <message>
        <source>Registrations (%1)</source>
        <translation>Registrierungen (%1)</translation>
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
        <source>%1 saves the pose; %2 toggles A/B. Each registration is listed here.</source>
        <translation>%1 speichert die Lage; %2 wechselt A/B. Jede Registrierung wird hier aufgeführt.</translation>
    </message>
    <message>
        <source>Save pose</source>
        <translation>Lage speichern</translation>
    </message>
    <message>
        <source>Saves this pose and its values as a named snapshot.</source>
        <translation>Speichert diese Lage und ihre Werte als benannten Snapshot.</translation>
    </message>
    <message>
        <source>Compares poses and methods in a table.</source>
        <translation>Vergleicht Lagen und Methoden in einer Tabelle.</translation>
    </message>
    <message>
        <source>median (mm) · %1: A ⇄ B</source>
        <translation>Median (mm) · %1: A ⇄ B</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SolutionStrip</name>
    <message>
        <source>Solutions</source>
        <translation>Lösungen</translation>
    </message>
    <message>
        <source>Solutions of this registration</source>
        <translation>Lösungen dieser Registrierung</translation>
    </message>
    <message>
        <source>%1: next · %2: accept</source>
        <translation>%1: nächste · %2: übernehmen</translation>
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
        <source>Initial pose</source>
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
        <source>check</source>
        <translation>prüfen</translation>
    </message>
    <message>
        <source>to do</source>
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
        <source>Click vessels in a slice. Only vessels connected to a seed are traced.</source>
        <translation>Klicken Sie auf Gefäße in einer Schicht. Nur mit einem Startpunkt verbundene Gefäße werden erfasst.</translation>
    </message>
    <message>
        <source>Avoid</source>
        <translation>Meiden</translation>
    </message>
    <message>
        <source>Click the heart, veins or bone in a slice. Regions with a wider connection to these points than to the seeds are excluded.</source>
        <translation>Klicken Sie auf Herz, Venen oder Knochen in einer Schicht. Bereiche, die mit diesen Punkten breiter verbunden sind als mit den Startpunkten, entfallen.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Seeds and points to avoid</source>
        <translation>Startpunkte und zu meidende Punkte</translation>
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
        <source>Preview threshold</source>
        <translation>Schwellenvorschau</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Voxels above this scan intensity are treated as vessel lumen.</source>
        <translation>Voxel oberhalb dieser Intensität des Scans gelten als Gefäßlumen.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::TracingPanel</name>
    <message>
        <source>Thin vessels only (requires seeds)</source>
        <translation>Nur dünne Gefäße (mit Startpunkten)</translation>
    </message>
    <message>
        <source>For coronary arteries next to opacified chambers or hepatic arteries next to the portal vein: tracing stops at structures wider than 1 cm. Requires seeds.</source>
        <translation>Für Koronararterien neben kontrastierten Herzhöhlen oder Leberarterien neben der Pfortader: Die Erfassung endet an Strukturen, die breiter als 1 cm sind. Braucht Startpunkte.</translation>
    </message>
    <message>
        <source>Trace between two points</source>
        <translation>Zwischen zwei Punkten erfassen</translation>
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
        <source>Min. length</source>
        <translation>Min. Länge</translation>
    </message>
    <message>
        <source>Removes branches that extend less than this beyond the wall of their parent vessel.</source>
        <translation>Entfernt Äste, die weniger als diesen Wert über die Wand ihres Stammgefäßes hinausragen.</translation>
    </message>
    <message>
        <source>Min. mean radius</source>
        <translation>Min. mittl. Radius</translation>
    </message>
    <message>
        <source>Removes branches with a smaller mean radius.</source>
        <translation>Entfernt Äste mit kleinerem mittlerem Radius.</translation>
    </message>
    <message>
        <source>Keep loops</source>
        <translation>Schleifen behalten</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Komponenten</translation>
    </message>
    <message>
        <source>Used only if there are no seeds. Default: in a mask, all components; in a scan, the component of the aorta or main artery. All: in a scan, the components of all great vessels.</source>
        <translation>Gilt nur, wenn es keine Startpunkte gibt. Standard: in einer Maske alle Komponenten, im Scan die der Aorta oder Hauptarterie. Alle: im Scan die Komponenten aller großen Gefäße.</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größte</translation>
    </message>
    <message>
        <source>Keeps vessel loops closed; otherwise, each loop is cut at its narrowest point.</source>
        <translation>Lässt Gefäßschleifen geschlossen; sonst wird jede Schleife an der engsten Stelle getrennt.</translation>
    </message>
    <message>
        <source>Cancels tracing; the vessels stay unchanged.</source>
        <translation>Bricht die Erfassung ab; die Gefäße bleiben unverändert.</translation>
    </message>
    <message>
        <source>Tracing…</source>
        <translation>Erfassung…</translation>
    </message>
    <message>
        <source>Click in a slice to place a point; Esc ends.</source>
        <translation>Klicken Sie in eine Schicht, um einen Punkt zu setzen; Esc beendet.</translation>
    </message>
    <message>
        <source>The traced vessels replace the current tree; can be undone.</source>
        <translation>Die erfassten Gefäße ersetzen den aktuellen Gefäßbaum; das lässt sich rückgängig machen.</translation>
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
        <source>Shows the untraced vessel in the slices.</source>
        <translation>Zeigt das nicht erfasste Gefäß in den Schichten.</translation>
    </message>
    <message>
        <source>Places a seed in this vessel and one in the traced vessel next to it.</source>
        <translation>Setzt einen Startpunkt in dieses Gefäß und einen in das erfasste daneben.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::TreeView</name>
    <message>
        <source>No vessels yet: drop them here, open them (%1), or trace a scan in its slices (%2).</source>
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
        <source>Ends the trial and logs it as abandoned.</source>
        <translation>Beendet den Versuch und protokolliert ihn als abgebrochen.</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Blind trial by %1: align the vessels with the image. Values are shown again when you are done.</source>
        <translation>Blindversuch von %1: Bringen Sie die Gefäße mit dem Bild zur Deckung. Die Werte erscheinen danach wieder.</translation>
    </message>
    <message>
        <source>Logs the time and the pose, and shows the values again.</source>
        <translation>Protokolliert Zeit und Lage und zeigt die Werte wieder.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ViewFrame</name>
    <message>
        <source>Shown in a separate window</source>
        <translation>In einem eigenen Fenster</translation>
    </message>
    <message>
        <source>Bring back</source>
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
        <source>Shows all views side by side or only the current one</source>
        <translation>Zeigt alle Ansichten nebeneinander oder nur die aktuelle</translation>
    </message>
    <message>
        <source>Crosshair</source>
        <translation>Fadenkreuz</translation>
    </message>
    <message>
        <source>Shows the point under the mouse pointer as an epipolar line in the other views and as a point on the vessels</source>
        <translation>Zeigt die Stelle unter dem Zeiger in den anderen Ansichten als Epipolarlinie und auf den Gefäßen als Punkt</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>Add a view</source>
        <translation>Ansicht hinzufügen</translation>
    </message>
    <message>
        <source>Adds another angiogram of the same vessels (Ctrl+Shift+V)</source>
        <translation>Fügt ein weiteres Angiogramm derselben Gefäße hinzu (Strg+Umschalt+V)</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::VtkView</name>
    <message>
        <source>The 3-D view requires OpenGL 3.2, which this display does not support. Everything else works. Try LIBGL_ALWAYS_SOFTWARE=1, or install libgl1-mesa-dri.</source>
        <translation>Die 3-D-Ansicht braucht OpenGL 3.2, das diese Anzeige nicht unterstützt. Alles andere funktioniert. Versuchen Sie LIBGL_ALWAYS_SOFTWARE=1, oder installieren Sie libgl1-mesa-dri.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::WelcomePage</name>
    <message>
        <source>Register a vessel tree to an angiogram</source>
        <translation>Einen Gefäßbaum auf ein Angiogramm registrieren</translation>
    </message>
    <message>
        <source>Open the sample case</source>
        <translation>Beispielfall öffnen</translation>
    </message>
    <message>
        <source>Drop a case here, or vessels together with an angiogram.</source>
        <translation>Legen Sie hier einen Fall ab, oder Gefäße zusammen mit einem Angiogramm.</translation>
    </message>
    <message>
        <source>Vessels: CT as DICOM folder, NIfTI, NRRD or MetaImage, masks, centerlines (VTP, VTK, CSV, SWC).  Angiograms: DICOM XA, PNG, TIFF.</source>
        <translation>Gefäße: CT als DICOM-Ordner, NIfTI, NRRD oder MetaImage, Masken, Mittellinien (VTP, VTK, CSV, SWC).  Angiogramme: DICOM XA, PNG, TIFF.</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Open DICOM folder/CD…</source>
        <translation>DICOM-Ordner/CD öffnen…</translation>
    </message>
    <message>
        <source>Lists the patients, studies and series in a folder, on a CD or in a DICOMDIR.</source>
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
        <source>Anywhere in the window</source>
        <translation>Überall im Fenster</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::WindowBar</name>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Pop out</source>
        <translation>Abdocken</translation>
    </message>
    <message>
        <source>Show angiogram</source>
        <translation>Angiogramm zeigen</translation>
    </message>
    <message>
        <source>Opens the slices in a separate window and brings them back (F9)</source>
        <translation>Öffnet die Schichten in einem eigenen Fenster und holt sie zurück (F9)</translation>
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
        <source>Sets the window automatically from the values of this scan; right-drag in a slice to adjust it manually.</source>
        <translation>Setzt das Fenster automatisch aus den Werten dieses Scans; Ziehen mit rechts in einer Schicht ändert es manuell.</translation>
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
        <source>No messages yet.</source>
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
        <source>Move measurement point</source>
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
        <source>Enter image scale</source>
        <translation>Bildmaßstab eingeben</translation>
    </message>
    <message>
        <source>Open an angiogram or a scan first.</source>
        <translation>Öffnen Sie zuerst ein Angiogramm oder einen Scan.</translation>
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
        <source>Table…</source>
        <translation>Tabelle…</translation>
    </message>
    <message>
        <source>Measurement basis</source>
        <translation>Messbezug</translation>
    </message>
    <message>
        <source>Measures lengths at the depth of the vessels, at the detector, or in pixels.</source>
        <translation>Misst Längen in der Tiefe der Gefäße, auf dem Detektor oder in Pixeln.</translation>
    </message>
    <message>
        <source>Removes the selected measurements (Delete)</source>
        <translation>Entfernt die gewählten Messungen (Entf)</translation>
    </message>
    <message>
        <source>Writes all measurements and their basis to a CSV file.</source>
        <translation>Schreibt alle Messungen mit ihrer Grundlage in eine CSV-Datei.</translation>
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
        <source>by entered scale</source>
        <translation>nach eingegebenem Maßstab</translation>
    </message>
    <message>
        <source> mm per pixel</source>
        <translation> mm pro Pixel</translation>
    </message>
    <message>
        <source>no scale entered</source>
        <translation>kein Maßstab eingegeben</translation>
    </message>
    <message>
        <source>Image scale</source>
        <translation>Bildmaßstab</translation>
    </message>
    <message>
        <source>Pixel size in the patient, if known from another source.</source>
        <translation>Pixelgröße im Patienten, falls aus anderer Quelle bekannt.</translation>
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
        <source>measured: %1</source>
        <translation>gemessen: %1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MeasureTool</name>
    <message>
        <source>Length: drag or click both ends · points can be moved</source>
        <translation>Länge: ziehen oder beide Enden anklicken · Punkte lassen sich verschieben</translation>
    </message>
    <message>
        <source>Angle: click one end, the vertex, the other end · points can be moved</source>
        <translation>Winkel: ein Ende, den Scheitel, das andere Ende anklicken · Punkte lassen sich verschieben</translation>
    </message>
    <message>
        <source>Area: click along the outline; double-click or Enter closes it · points can be moved</source>
        <translation>Fläche: Umriss klicken; Doppelklick oder Eingabe schließt · Punkte lassen sich verschieben</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ProfileController</name>
    <message>
        <source>Select a branch in the list or in a view.</source>
        <translation>Wählen Sie einen Ast in der Liste oder in einer Ansicht.</translation>
    </message>
    <message>
        <source>Open the vessels first.</source>
        <translation>Öffnen Sie zuerst die Gefäße.</translation>
    </message>
    <message>
        <source>Export branch measurements</source>
        <translation>Astmessungen exportieren</translation>
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
        <source>All branches…</source>
        <translation>Alle Äste…</translation>
    </message>
    <message>
        <source>Profile…</source>
        <translation>Profil…</translation>
    </message>
    <message>
        <source>Writes the length, diameters, stenosis and curvature of every branch to a CSV file.</source>
        <translation>Schreibt Länge, Durchmesser, Stenose und Krümmung jedes Astes in eine CSV-Datei.</translation>
    </message>
    <message>
        <source>Writes the diameter and curvature along this branch to a CSV file.</source>
        <translation>Schreibt Durchmesser und Krümmung entlang dieses Astes in eine CSV-Datei.</translation>
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
        <source>Min. diameter</source>
        <translation>Min. Durchmesser</translation>
    </message>
    <message>
        <source>Narrowest point</source>
        <translation>Engste Stelle</translation>
    </message>
    <message>
        <source>Tortuosity</source>
        <translation>Tortuosität</translation>
    </message>
    <message>
        <source>Sharpest bend</source>
        <translation>Stärkste Krümmung</translation>
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
        <source>Diameters are twice the radii of the tree; the narrowest point is determined relative to the rest of the branch.</source>
        <translation>Durchmesser sind die doppelten Radien des Gefäßbaums; die engste Stelle gilt relativ zum Rest des Astes.</translation>
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
        <source>curvature %1/mm</source>
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
        <source>Stops at the current frame. Esc returns to the frame shown before playback.</source>
        <translation>Hält beim gezeigten Bild an. Esc kehrt zum Bild vor der Wiedergabe zurück.</translation>
    </message>
    <message>
        <source>Plays the run</source>
        <translation>Spielt die Serie ab</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Endlosschleife</translation>
    </message>
    <message>
        <source>Back and forth</source>
        <translation>Vor und zurück</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>%1 · %2 fps</source>
        <translation>%1 · %2 fps</translation>
    </message>
    <message>
        <source>The header contains no frame rate: 1× corresponds to an assumed rate of %1 frames per second</source>
        <translation>Der Header enthält keine Bildrate: 1× entspricht angenommenen %1 Bildern pro Sekunde</translation>
    </message>
    <message>
        <source>1×: acquisition frame rate, %1 frames per second</source>
        <translation>1×: Bildrate der Aufnahme, %1 Bilder pro Sekunde</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MarkPanel</name>
    <message>
        <source>Target point</source>
        <translation>Zielpunkt</translation>
    </message>
    <message>
        <source>Ostium ring</source>
        <translation>Ostiumring</translation>
    </message>
    <message>
        <source>Mark in image</source>
        <translation>Im Bild markieren</translation>
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
        <source>Target points and marks</source>
        <translation>Zielpunkte und Markierungen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Table…</source>
        <translation>Tabelle…</translation>
    </message>
    <message>
        <source>Removes the selected marks (Delete)</source>
        <translation>Entfernt die gewählten Markierungen (Entf)</translation>
    </message>
    <message>
        <source>Writes all target points and ostium rings with their errors to a CSV file.</source>
        <translation>Schreibt alle Zielpunkte und Ostiumringe mit ihren Fehlern in eine CSV-Datei.</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Markierungen</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MarkTool</name>
    <message>
        <source>Target point: click the vessels, here, in 3-D or in a slice · points can be moved</source>
        <translation>Zielpunkt: auf die Gefäße klicken, hier, in 3-D oder in einer Schicht · Punkte lassen sich verschieben</translation>
    </message>
    <message>
        <source>Ostium ring: click the vessels, here, in 3-D or in a slice · rings can be moved</source>
        <translation>Ostiumring: auf die Gefäße klicken, hier, in 3-D oder in einer Schicht · Ringe lassen sich verschieben</translation>
    </message>
    <message>
        <source>Mark in image: click where the selected target point appears, or drag it there</source>
        <translation>Im Bild markieren: dorthin klicken, wo der gewählte Zielpunkt zu sehen ist, oder ihn dorthin ziehen</translation>
    </message>
    <message>
        <source>Arrow: drag from tail to tip, then type a label · ends can be moved</source>
        <translation>Pfeil: vom Ende zur Spitze ziehen, dann schreiben · Enden lassen sich verschieben</translation>
    </message>
    <message>
        <source>Text: click where the text should start, then type · text can be moved</source>
        <translation>Text: Anfang anklicken, dann schreiben · Texte lassen sich verschieben</translation>
    </message>
    <message>
        <source>Text on the image</source>
        <translation>Text auf dem Bild</translation>
    </message>
    <message>
        <source>Text, then Enter</source>
        <translation>Text, dann Eingabetaste</translation>
    </message>
</context>
<context>
    <name>angiopose::app::MarkController</name>
    <message>
        <source>Open the vessels first.</source>
        <translation>Öffnen Sie zuerst die Gefäße.</translation>
    </message>
    <message>
        <source>Open an angiogram first.</source>
        <translation>Öffnen Sie zuerst ein Angiogramm.</translation>
    </message>
    <message>
        <source>Add target point</source>
        <translation>Zielpunkt hinzufügen</translation>
    </message>
    <message>
        <source>Add ostium ring</source>
        <translation>Ostiumring hinzufügen</translation>
    </message>
    <message>
        <source>Add a target point on the vessels first.</source>
        <translation>Setzen Sie zuerst einen Zielpunkt auf die Gefäße.</translation>
    </message>
    <message>
        <source>Mark target point in image</source>
        <translation>Zielpunkt im Bild markieren</translation>
    </message>
    <message>
        <source>Draw arrow</source>
        <translation>Pfeil zeichnen</translation>
    </message>
    <message>
        <source>Add text</source>
        <translation>Text hinzufügen</translation>
    </message>
    <message>
        <source>Move mark</source>
        <translation>Markierung verschieben</translation>
    </message>
    <message>
        <source>Rename mark</source>
        <translation>Markierung umbenennen</translation>
    </message>
    <message>
        <source>Remove mark</source>
        <translation>Markierung entfernen</translation>
    </message>
    <message>
        <source>Named points on the vessels, with the distance between their projection and their position in the image; arrows and text annotations for exported images.</source>
        <translation>Benannte Punkte auf den Gefäßen, mit dem Abstand ihrer Projektion von ihrer Position im Bild; Pfeile und Textanmerkungen für exportierte Bilder.</translation>
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
        <source>Shown on frame %1 of this view and in every image exported from it.</source>
        <translation>Erscheint auf Bild %1 dieser Ansicht und in jedem daraus exportierten Bild.</translation>
    </message>
    <message>
        <source>Ostium %1</source>
        <translation>Ostium %1</translation>
    </message>
    <message>
        <source>Target point %1</source>
        <translation>Zielpunkt %1</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PathController</name>
    <message>
        <source>Trace one vessel</source>
        <translation>Ein Gefäß erfassen</translation>
    </message>
    <message>
        <source>Traced: one vessel, %1 mm.</source>
        <translation>Erfasst: ein Gefäß, %1 mm.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PathTool</name>
    <message>
        <source>One vessel: click its end point · Esc starts over</source>
        <translation>Ein Gefäß: Ende anklicken · Esc beginnt von vorn</translation>
    </message>
    <message>
        <source>One vessel: click its start point, then its end point</source>
        <translation>Ein Gefäß: Anfang anklicken, dann Ende</translation>
    </message>
</context>
<context>
    <name>angiopose::app::MaskController</name>
    <message>
        <source>Stopped: the vessels are unchanged</source>
        <translation>Angehalten: Die Gefäße sind unverändert</translation>
    </message>
    <message>
        <source>Tracing the mask… %1 %</source>
        <translation>Maske wird erfasst … %1 %</translation>
    </message>
    <message>
        <source>Open a scan or a label image first.</source>
        <translation>Öffnen Sie zuerst einen Scan oder ein Labelbild.</translation>
    </message>
    <message>
        <source>A registration is running. Stop it before editing.</source>
        <translation>Eine Registrierung läuft. Halten Sie sie vor dem Bearbeiten an.</translation>
    </message>
    <message>
        <source>Paint mask</source>
        <translation>Maske malen</translation>
    </message>
    <message>
        <source>Erase mask</source>
        <translation>Maske radieren</translation>
    </message>
    <message>
        <source>There is no mask at this position.</source>
        <translation>An dieser Stelle ist keine Maske.</translation>
    </message>
    <message>
        <source>Cut the mask</source>
        <translation>Maske schneiden</translation>
    </message>
    <message>
        <source>Tracing the mask…</source>
        <translation>Maske wird erfasst…</translation>
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
        <source>Saved without the latest mask changes: trace the mask, then save again.</source>
        <translation>Ohne die letzten Änderungen der Maske gespeichert: Erfassen Sie die Maske, dann speichern Sie noch einmal.</translation>
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
        <source>Shift+wheel, + and − change the brush size</source>
        <translation>Umschalt+Rad, + und − ändern die Pinselgröße</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MaskCutTool</name>
    <message>
        <source>Scissors: draw around the region to remove · Shift keeps only the inside</source>
        <translation>Schere: zu entfernenden Bereich umfahren · Umschalt behält das Innere</translation>
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
        <source>3-D brush</source>
        <translation>3-D-Pinsel</translation>
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
        <source>Save mask…</source>
        <translation>Maske speichern…</translation>
    </message>
    <message>
        <source>Lumen mask</source>
        <translation>Gefäßmaske</translation>
    </message>
    <message>
        <source>Recreates the vessels from the current mask.</source>
        <translation>Erzeugt die Gefäße neu aus der aktuellen Maske.</translation>
    </message>
    <message>
        <source>Writes the mask as a label image.</source>
        <translation>Schreibt die Maske als Labelbild.</translation>
    </message>
    <message>
        <source>this slice</source>
        <translation>diese Schicht</translation>
    </message>
    <message>
        <source>neighboring slices</source>
        <translation>Nachbarschichten</translation>
    </message>
    <message>
        <source>all slices</source>
        <translation>alle Schichten</translation>
    </message>
    <message>
        <source>Mask over the slices</source>
        <translation>Maske über den Schichten</translation>
    </message>
    <message>
        <source>Sets the opacity of the mask over the slices.</source>
        <translation>Stellt die Deckkraft der Maske über den Schichten ein.</translation>
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
        <source>Scissors depth</source>
        <translation>Tiefe der Schere</translation>
    </message>
    <message>
        <source>Depth on both sides of the slice</source>
        <translation>Tiefe beiderseits der Schicht</translation>
    </message>
    <message>
        <source>Tracing the mask…</source>
        <translation>Maske wird erfasst…</translation>
    </message>
    <message>
        <source>1 mask change is not yet reflected in the vessels: trace the mask.</source>
        <translation>1 Änderung der Maske ist noch nicht in den Gefäßen: Erfassen Sie die Maske.</translation>
    </message>
    <message>
        <source>%1 mask changes are not yet reflected in the vessels: trace the mask.</source>
        <translation>%1 Änderungen der Maske sind noch nicht in den Gefäßen: Erfassen Sie die Maske.</translation>
    </message>
    <message>
        <source>The vessels come from a manually edited mask.</source>
        <translation>Die Gefäße stammen aus einer manuell bearbeiteten Maske.</translation>
    </message>
    <message>
        <source>Paint and cut, then trace the mask. Each stroke can be undone.</source>
        <translation>Malen und schneiden Sie, dann erfassen Sie die Maske. Jeder Strich lässt sich rückgängig machen.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SliceMeasureTool</name>
    <message>
        <source>Length: drag or click both ends · points can be moved</source>
        <translation>Länge: ziehen oder beide Enden anklicken · Punkte lassen sich verschieben</translation>
    </message>
    <message>
        <source>Angle: click one end, the vertex, the other end · points can be moved</source>
        <translation>Winkel: ein Ende, den Scheitel, das andere Ende anklicken · Punkte lassen sich verschieben</translation>
    </message>
    <message>
        <source>Area: click along the outline; double-click or Enter closes it · points can be moved</source>
        <translation>Fläche: Umriss klicken; Doppelklick oder Eingabe schließt · Punkte lassen sich verschieben</translation>
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
        <source>Expand panel: %1</source>
        <translation>Bereich ausklappen: %1</translation>
    </message>
    <message>
        <source>Expand: %1</source>
        <translation>Ausklappen: %1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::FoldButton</name>
    <message>
        <source>Collapse panel: %1</source>
        <translation>Bereich einklappen: %1</translation>
    </message>
    <message>
        <source>Collapse: %1</source>
        <translation>Einklappen: %1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ScanBar</name>
    <message>
        <source>Display of the scan behind the vessels</source>
        <translation>Darstellung des Scans hinter den Gefäßen</translation>
    </message>
    <message>
        <source>Opacity of the scan</source>
        <translation>Deckkraft des Scans</translation>
    </message>
</context>
<context>
    <name>angiopose::app::RecentController</name>
    <message>
        <source>Clear list</source>
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
        <source>The folder could not be opened</source>
        <translation>Der Ordner konnte nicht geöffnet werden</translation>
    </message>
    <message>
        <source>Searching %1…</source>
        <translation>%1 wird durchsucht…</translation>
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
        <source>The folder contains too many files to list. Choose the folder of a single study.</source>
        <translation>Der Ordner enthält zu viele Dateien für die Liste: Wählen Sie den Ordner einer einzelnen Studie.</translation>
    </message>
    <message>
        <source>The DICOMDIR is unusable (%1); the files were read directly.</source>
        <translation>Das DICOMDIR ist unbrauchbar (%1); die Dateien wurden direkt gelesen.</translation>
    </message>
    <message>
        <source>Files listed in the DICOMDIR but missing: %1.</source>
        <translation>Im DICOMDIR aufgeführte, aber fehlende Dateien: %1.</translation>
    </message>
    <message>
        <source>The DICOMDIR lists %1 series; 1 more file is not listed.</source>
        <translation>Das DICOMDIR nennt %1 Serien; 1 weitere Datei ist nicht aufgeführt.</translation>
    </message>
    <message>
        <source>The DICOMDIR lists %1 series; %2 more files are not listed.</source>
        <translation>Das DICOMDIR nennt %1 Serien; %2 weitere Dateien sind nicht aufgeführt.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::StudyRows</name>
    <message>
        <source>Patient %1 (identity hidden)</source>
        <translation>Patient %1 (Identität verborgen)</translation>
    </message>
    <message>
        <source>No name</source>
        <translation>Kein Name</translation>
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
        <translation>Anforderungsnr. %1</translation>
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
        <source>Files listed in the DICOMDIR but missing: %1.</source>
        <translation>Im DICOMDIR aufgeführte, aber fehlende Dateien: %1.</translation>
    </message>
    <message>
        <source>Not all files have been read yet, so it is not yet known which part of the series this is.</source>
        <translation>Noch wurden nicht alle Dateien gelesen; welcher Teil der Serie dies ist, steht daher noch nicht fest.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::RecentList</name>
    <message>
        <source>No recent case matches this name or folder.</source>
        <translation>Kein letzter Fall stimmt in Name oder Ordner überein.</translation>
    </message>
    <message>
        <source>Thumbnails</source>
        <translation>Vorschaubilder</translation>
    </message>
    <message>
        <source>Clear list</source>
        <translation>Liste leeren</translation>
    </message>
    <message>
        <source>Search recent cases</source>
        <translation>Letzte Fälle durchsuchen</translation>
    </message>
    <message>
        <source>Stores a thumbnail of each recent case in the program&apos;s cache folder.</source>
        <translation>Speichert ein Vorschaubild jedes letzten Falls im Cache-Ordner des Programms.</translation>
    </message>
    <message>
        <source>Removes these cases and their thumbnails from the list. Pinned cases and all files are kept.</source>
        <translation>Entfernt diese Fälle und ihre Vorschaubilder aus der Liste. Angeheftete Fälle und alle Dateien bleiben erhalten.</translation>
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
        <source>Remove from the list; the file is kept</source>
        <translation>Aus der Liste entfernen; die Datei bleibt erhalten</translation>
    </message>
    <message>
        <source>Remove %1 from the list</source>
        <translation>%1 aus der Liste entfernen</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::StudyBrowser</name>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Also read them</source>
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
        <source>Select the scan that shows the vessels and one or more angiographic runs, or double-click an entry to open it.</source>
        <translation>Wählen Sie den Scan, der die Gefäße zeigt, und eine oder mehrere Angiographieserien aus, oder doppelklicken Sie auf eine Zeile, um sie zu öffnen.</translation>
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
        <source>Spacing, rate</source>
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
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
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
        <source>Another task is running. Wait for it to finish.</source>
        <translation>Eine andere Aufgabe läuft. Warten Sie, bis sie beendet ist.</translation>
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
        <source>Writing the movie…</source>
        <translation>Der Film wird geschrieben…</translation>
    </message>
    <message>
        <source>Frames %1 to %2, back and forth</source>
        <translation>Bilder %1 bis %2, vor und zurück</translation>
    </message>
    <message>
        <source>Frames %1 to %2</source>
        <translation>Bilder %1 bis %2</translation>
    </message>
    <message>
        <source>pose of this frame for all frames</source>
        <translation>Lage dieses Bildes für alle</translation>
    </message>
    <message>
        <source>tracked pose of each frame</source>
        <translation>verfolgte Lage jedes Bildes</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ReportController</name>
    <message>
        <source>Nothing to report yet. Open vessels and an angiogram first.</source>
        <translation>Noch nichts zu berichten. Öffnen Sie zuerst Gefäße und ein Angiogramm.</translation>
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
        <source>frames per second</source>
        <translation>Bilder pro Sekunde</translation>
    </message>
    <message>
        <source>Residual colors with scale</source>
        <translation>Residuenfarben mit Skala</translation>
    </message>
    <message>
        <source>Burn in patient identity</source>
        <translation>Patientendaten in den Bildern</translation>
    </message>
    <message>
        <source>English labels</source>
        <translation>Englische Beschriftung</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
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
        <source>GIF, for web pages; loops automatically</source>
        <translation>GIF, für Webseiten; läuft in Endlosschleife</translation>
    </message>
    <message>
        <source>Each frame is labeled “Not for clinical use” and shows the origin of its pose and whether the pose is reliable.</source>
        <translation>Jedes Bild trägt den Hinweis „Nicht für den klinischen Einsatz“, die Herkunft der Lage und ob sie verlässlich ist.</translation>
    </message>
    <message>
        <source>Overlay through the run</source>
        <translation>Überlagerung über die Serie</translation>
    </message>
    <message>
        <source>Convergence of the registration</source>
        <translation>Konvergenz der Registrierung</translation>
    </message>
    <message>
        <source>Vessels only, one full rotation</source>
        <translation>Nur Gefäße, eine volle Drehung</translation>
    </message>
    <message>
        <source>Movie</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
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
        <source>%1 frames, %2 s, %3 × %4 px</source>
        <translation>%1 Bilder, %2 s, %3 × %4 px</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ReportDialog</name>
    <message>
        <source>Use built-in</source>
        <translation>Eingebaute</translation>
    </message>
    <message>
        <source>Patient identity in the report</source>
        <translation>Patientendaten im Bericht</translation>
    </message>
    <message>
        <source>Export report</source>
        <translation>Bericht exportieren</translation>
    </message>
    <message>
        <source>Leave this off if the report will be shared: it is then anonymous.</source>
        <translation>Ausgeschaltet lassen, wenn der Bericht weitergegeben wird: Er ist dann anonym.</translation>
    </message>
    <message>
        <source>Templates are HTML pages with your letterhead and logo. Save a copy of the built-in template and edit the copy; it contains instructions.</source>
        <translation>Vorlagen sind HTML-Seiten mit Ihrem Briefkopf und Logo. Speichern Sie eine Kopie der eingebauten Vorlage und bearbeiten Sie sie; die Anleitung steht darin.</translation>
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
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Save a copy…</source>
        <translation>Kopie speichern…</translation>
    </message>
    <message>
        <source>Saves the built-in template for editing</source>
        <translation>Speichert die eingebaute Vorlage zum Bearbeiten</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>built-in</source>
        <translation>eingebaut</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::DicomDialog</name>
    <message>
        <source>Overlay image (Secondary Capture)</source>
        <translation>Überlagerungsbild (Secondary Capture)</translation>
    </message>
    <message>
        <source>Images of the run (Secondary Capture)</source>
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
        <source>Patient identity in images and report</source>
        <translation>Patientendaten in Bildern und Bericht</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Export DICOM objects</source>
        <translation>DICOM-Objekte exportieren</translation>
    </message>
    <message>
        <source>A Spatial Registration contains only a rigid matrix. The perspective camera is written to camera.json in the same folder.</source>
        <translation>Eine Spatial Registration enthält nur eine starre Matrix. Die perspektivische Kamera wird in camera.json im selben Ordner geschrieben.</translation>
    </message>
    <message>
        <source>DICOM headers contain the patient&apos;s identity even if the images do not show it. Each object is a new instance in the study of its image.</source>
        <translation>DICOM-Header enthalten die Patientendaten, auch wenn die Bilder sie nicht zeigen. Jedes Objekt ist eine neue Instanz in der Studie seines Bildes.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Choose PACS…</source>
        <translation>PACS wählen…</translation>
    </message>
    <message>
        <source>Send to PACS</source>
        <translation>An PACS senden</translation>
    </message>
    <message>
        <source>A Spatial Registration contains only a rigid matrix. The perspective camera is stored in private elements. The file camera.json is not sent.</source>
        <translation>Eine Spatial Registration enthält nur eine starre Matrix. Die perspektivische Kamera steht in ihren privaten Elementen. Die Datei camera.json wird nicht gesendet.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::DicomController</name>
    <message>
        <source>There is nothing to export yet. Open a vessel tree and an angiogram first.</source>
        <translation>Es gibt noch nichts zu exportieren. Öffnen Sie zuerst einen Gefäßbaum und ein Angiogramm.</translation>
    </message>
    <message>
        <source>Folder for the DICOM objects</source>
        <translation>Ordner für die DICOM-Objekte</translation>
    </message>
    <message>
        <source>Nothing to send yet. Open a vessel tree and an angiogram first.</source>
        <translation>Noch nichts zu senden. Öffnen Sie zuerst einen Gefäßbaum und ein Angiogramm.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PackController</name>
    <message>
        <source>Nothing to share yet. Open a vessel tree and an angiogram first.</source>
        <translation>Noch nichts weiterzugeben. Öffnen Sie zuerst einen Gefäßbaum und ein Angiogramm.</translation>
    </message>
    <message>
        <source>Share case as ZIP</source>
        <translation>Fall als ZIP weitergeben</translation>
    </message>
    <message>
        <source>ZIP archives (*.zip)</source>
        <translation>ZIP-Archive (*.zip)</translation>
    </message>
    <message>
        <source>A case is already being packed. Wait for it to finish, or stop it.</source>
        <translation>Es wird bereits ein Fall gepackt. Warten Sie das Ende ab, oder halten Sie es an.</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Packing…</source>
        <translation>Wird gepackt…</translation>
    </message>
    <message>
        <source>Packing: %1 %</source>
        <translation>Wird gepackt: %1 %</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PackDialog</name>
    <message>
        <source>De-identify</source>
        <translation>De-identifizieren</translation>
    </message>
    <message>
        <source>Shift dates instead of removing them</source>
        <translation>Datumsangaben verschieben statt entfernen</translation>
    </message>
    <message>
        <source>Mask burned-in text</source>
        <translation>Eingebrannten Text maskieren</translation>
    </message>
    <message>
        <source>Share case as ZIP</source>
        <translation>Fall als ZIP weitergeben</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>Pseudonym</source>
        <translation>Pseudonym</translation>
    </message>
    <message>
        <source>Creates one archive with the case, its inputs and its results. De-identification removes names, IDs, dates, private elements and notes, and replaces UIDs. Branch names are kept. Review every image before sharing.</source>
        <translation>Erstellt ein Archiv mit dem Fall, seinen Eingaben und Ergebnissen. Die De-Identifizierung entfernt Namen, IDs, Datumsangaben, private Elemente und Notizen und ersetzt UIDs. Astnamen bleiben erhalten. Prüfen Sie vor der Weitergabe jedes Bild.</translation>
    </message>
    <message>
        <source>Pack…</source>
        <translation>Packen…</translation>
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
        <source>Cache emptied. Objects deleted: %1.</source>
        <translation>Zwischenspeicher geleert. Gelöschte Objekte: %1.</translation>
    </message>
    <message>
        <source>Reduce the cache below its current size?</source>
        <translation>Zwischenspeicher unter die aktuelle Größe verkleinern?</translation>
    </message>
    <message>
        <source>The cache contains %1. The least recently used objects will be deleted until %2 remain.</source>
        <translation>Der Zwischenspeicher enthält %1. Die am längsten unbenutzten Objekte werden gelöscht, bis %2 übrig sind.</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
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
        <source>All retrieved objects will be deleted. When you open a case whose images were in the cache, AngioPose will ask for the location of the images. “Share case as ZIP” keeps case and images together.</source>
        <translation>Alle abgerufenen Objekte werden gelöscht. Beim Öffnen eines Falls, dessen Bilder im Zwischenspeicher lagen, fragt AngioPose nach ihrem Ort. „Fall als ZIP weitergeben“ hält Fall und Bilder zusammen.</translation>
    </message>
    <message>
        <source>Empty</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Emptying the cache…</source>
        <translation>Zwischenspeicher wird geleert…</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveController</name>
    <message>
        <source>objects received on port %1</source>
        <translation>an Port %1 empfangene Objekte</translation>
    </message>
    <message>
        <source>Objects received: %1</source>
        <translation>Empfangene Objekte: %1</translation>
    </message>
    <message>
        <source>Nothing received yet</source>
        <translation>Noch nichts empfangen</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveEcho</name>
    <message>
        <source>Stopped.</source>
        <translation>Angehalten.</translation>
    </message>
    <message>
        <source>Contacting %1…</source>
        <translation>%1 wird kontaktiert…</translation>
    </message>
    <message>
        <source>%1 responded and accepted the connection.</source>
        <translation>%1 hat geantwortet und die Verbindung angenommen.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveFinder</name>
    <message>
        <source>Stopped.</source>
        <translation>Angehalten.</translation>
    </message>
    <message>
        <source>Search, select studies or series, then retrieve them.</source>
        <translation>Suchen Sie, wählen Sie Studien oder Serien aus, und rufen Sie sie ab.</translation>
    </message>
    <message>
        <source>“%1” is not a date. Enter year, month and day: 2024-01-31.</source>
        <translation>„%1“ ist kein Datum. Geben Sie Jahr, Monat und Tag ein: 2024-01-31.</translation>
    </message>
    <message>
        <source>Searching %1…</source>
        <translation>%1 wird durchsucht…</translation>
    </message>
    <message>
        <source>%1 has no matching study. Broaden the search: use a shorter name, a wider date range or any modality.</source>
        <translation>%1 enthält keine passende Studie. Erweitern Sie die Suche: kürzerer Name, längerer Zeitraum, beliebige Modalität.</translation>
    </message>
    <message>
        <source>Search to list the studies in %1.</source>
        <translation>Suchen Sie, um die Studien auf %1 aufzulisten.</translation>
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
        <source>Select studies, or expand one to select its series; Ctrl selects several.</source>
        <translation>Wählen Sie Studien, oder klappen Sie eine auf, um ihre Serien zu wählen; Strg wählt mehrere.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveNodes</name>
    <message>
        <source>A PACS with this name already exists. Choose another name.</source>
        <translation>Ein PACS mit diesem Namen gibt es bereits. Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Remove %1 from the list?</source>
        <translation>%1 aus der Liste entfernen?</translation>
    </message>
    <message>
        <source>The PACS itself and the objects retrieved from it are not affected.</source>
        <translation>Das PACS selbst und die daraus abgerufenen Objekte sind nicht betroffen.</translation>
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
        <source>Contacting %1…</source>
        <translation>%1 wird kontaktiert…</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Wird angehalten…</translation>
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
        <source>%1 of %2 objects were retrieved.</source>
        <translation>%1 von %2 Objekten wurden abgerufen.</translation>
    </message>
    <message>
        <source>Retrieve again to get the rest.</source>
        <translation>Rufen Sie noch einmal ab, um die übrigen zu erhalten.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveSender</name>
    <message>
        <source>Stopping…</source>
        <translation>Wird angehalten…</translation>
    </message>
    <message>
        <source>Creating the objects…</source>
        <translation>Objekte werden erzeugt…</translation>
    </message>
    <message>
        <source>Sent: %1 of %2 objects, %3</source>
        <translation>Gesendet: %1 von %2 Objekten, %3</translation>
    </message>
    <message>
        <source>%1 received all objects: %2 (%3).</source>
        <translation>%1 hat alle Objekte erhalten: %2 (%3).</translation>
    </message>
    <message>
        <source>%1 of %2 objects were delivered.</source>
        <translation>%1 von %2 Objekten wurden zugestellt.</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Angehalten.</translation>
    </message>
    <message>
        <source>Send again to transfer the rest.</source>
        <translation>Senden Sie noch einmal, um die übrigen zu übertragen.</translation>
    </message>
    <message>
        <source>Stopped. Nothing was sent.</source>
        <translation>Angehalten. Nichts wurde gesendet.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveWords</name>
    <message>
        <source>No name</source>
        <translation>Kein Name</translation>
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
        <source>Number of further errors: %1.</source>
        <translation>Anzahl weiterer Fehler: %1.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ArchiveDialog</name>
    <message>
        <source>Open retrieved</source>
        <translation>Abgerufene öffnen</translation>
    </message>
    <message>
        <source>Retrieve</source>
        <translation>Abrufen</translation>
    </message>
    <message>
        <source>Query PACS</source>
        <translation>PACS abfragen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Select from the received objects</source>
        <translation>Aus den empfangenen Objekten auswählen</translation>
    </message>
    <message>
        <source>Retrieves the selected studies and series, from which you then choose the vessels and views</source>
        <translation>Ruft die gewählten Studien und Serien ab; wählen Sie danach Gefäße und Ansichten</translation>
    </message>
    <message>
        <source>No PACS configured. Add one (ask your PACS administrator for host, port and AE title).</source>
        <translation>Kein PACS konfiguriert. Fügen Sie eines hinzu (Host, Port und AE-Titel nennt Ihnen Ihre PACS-Administration).</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::CacheLine</name>
    <message>
        <source>Empty…</source>
        <translation>Leeren…</translation>
    </message>
    <message>
        <source>Maximum cache size</source>
        <translation>Maximale Größe des Zwischenspeichers</translation>
    </message>
    <message>
        <source>The least recently used objects are deleted first</source>
        <translation>Die am längsten unbenutzten Objekte werden zuerst gelöscht</translation>
    </message>
    <message>
        <source>Deletes all retrieved objects</source>
        <translation>Löscht alle abgerufenen Objekte</translation>
    </message>
    <message>
        <source>of max.</source>
        <translation>von max.</translation>
    </message>
    <message>
        <source>Cache: %1</source>
        <translation>Zwischenspeicher: %1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MatchList</name>
    <message>
        <source>Studies and series in the PACS</source>
        <translation>Studien und Serien im PACS</translation>
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
        <source>Searching…</source>
        <translation>Wird gesucht…</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::NodeBar</name>
    <message>
        <source>Test connection</source>
        <translation>Verbindung testen</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Hinzufügen…</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>Bearbeiten…</translation>
    </message>
    <message>
        <source>Remove…</source>
        <translation>Entfernen…</translation>
    </message>
    <message>
        <source>PACS</source>
        <translation>PACS</translation>
    </message>
    <message>
        <source>No PACS yet</source>
        <translation>Noch kein PACS</translation>
    </message>
    <message>
        <source>Checks whether the PACS responds and accepts this program</source>
        <translation>Prüft, ob das PACS antwortet und dieses Programm zulässt</translation>
    </message>
    <message>
        <source>Adds a PACS to the list; the command line uses the same list</source>
        <translation>Fügt der Liste ein PACS hinzu; die Befehlszeile benutzt dieselbe Liste</translation>
    </message>
    <message>
        <source>Edits host, port, AE titles and security</source>
        <translation>Bearbeitet Host, Port, AE-Titel und Sicherheit</translation>
    </message>
    <message>
        <source>Removes the PACS from the list</source>
        <translation>Entfernt das PACS aus der Liste</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::NodeDialog</name>
    <message>
        <source>Authorization file</source>
        <translation>Autorisierungsdatei</translation>
    </message>
    <message>
        <source>Encrypted (TLS)</source>
        <translation>Verschlüsselt (TLS)</translation>
    </message>
    <message>
        <source>CA certificates (PEM)</source>
        <translation>CA-Zertifikate (PEM)</translation>
    </message>
    <message>
        <source>Local certificate (PEM)</source>
        <translation>Eigenes Zertifikat (PEM)</translation>
    </message>
    <message>
        <source>Private key of the local certificate (PEM)</source>
        <translation>Privater Schlüssel des eigenen Zertifikats (PEM)</translation>
    </message>
    <message>
        <source>Verify host name in certificate</source>
        <translation>Hostnamen im Zertifikat prüfen</translation>
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
        <source>Add PACS</source>
        <translation>PACS hinzufügen</translation>
    </message>
    <message>
        <source>Edit PACS</source>
        <translation>PACS bearbeiten</translation>
    </message>
    <message>
        <source>Ask your PACS administrator for these values, and have the calling AE title registered in the PACS.</source>
        <translation>Erfragen Sie diese Angaben bei Ihrer PACS-Administration, und lassen Sie den rufenden AE-Titel dort eintragen.</translation>
    </message>
    <message>
        <source>Radiology PACS</source>
        <translation>PACS der Radiologie</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name shown in this program</source>
        <translation>In diesem Programm angezeigter Name</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Host</translation>
    </message>
    <message>
        <source>Host name or IP address; leave empty if only DICOMweb is used</source>
        <translation>Hostname oder IP-Adresse; leer, wenn nur DICOMweb benutzt wird</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Usually 104 or 11112</source>
        <translation>Üblicherweise 104 oder 11112</translation>
    </message>
    <message>
        <source>Called AE title</source>
        <translation>Gerufener AE-Titel</translation>
    </message>
    <message>
        <source>AE title of the PACS</source>
        <translation>AE-Titel des PACS</translation>
    </message>
    <message>
        <source>Calling AE title</source>
        <translation>Rufender AE-Titel</translation>
    </message>
    <message>
        <source>AE title under which the PACS knows this program</source>
        <translation>AE-Titel, unter dem das PACS dieses Programm kennt</translation>
    </message>
    <message>
        <source>CA certificates</source>
        <translation>CA-Zertifikate</translation>
    </message>
    <message>
        <source>PEM file; if empty, the CAs trusted by the system are used</source>
        <translation>PEM-Datei; leer: vom System als vertrauenswürdig eingestufte CAs</translation>
    </message>
    <message>
        <source>Local certificate</source>
        <translation>Eigenes Zertifikat</translation>
    </message>
    <message>
        <source>PEM file (optional)</source>
        <translation>PEM-Datei (optional)</translation>
    </message>
    <message>
        <source>Private key</source>
        <translation>Privater Schlüssel</translation>
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
        <source>Used if no host is specified</source>
        <translation>Wird benutzt, wenn kein Host angegeben ist</translation>
    </message>
    <message>
        <source>Authorization</source>
        <translation>Autorisierung</translation>
    </message>
    <message>
        <source>File whose first line is sent as the Authorization header; only its path is stored</source>
        <translation>Datei, deren erste Zeile als Authorization-Header gesendet wird; nur ihr Pfad wird gespeichert</translation>
    </message>
    <message>
        <source>Port for C-MOVE</source>
        <translation>Port für C-MOVE</translation>
    </message>
    <message>
        <source>Local port to which the PACS sends images if it does not support C-GET. 0: not used</source>
        <translation>Lokaler Port, an den das PACS sendet, wenn es kein C-GET unterstützt. 0: unbenutzt</translation>
    </message>
    <message>
        <source>Response timeout</source>
        <translation>Antwort-Timeout</translation>
    </message>
    <message>
        <source>After this time, the PACS is considered unreachable</source>
        <translation>Nach dieser Zeit gilt das PACS als nicht erreichbar</translation>
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
        <source>Show objects</source>
        <translation>Anzeigen</translation>
    </message>
    <message>
        <source>Accepts objects sent to this computer by modalities and PACS until receiving is turned off or the window is closed</source>
        <translation>Nimmt Objekte an, die Modalitäten und PACS an diesen Rechner senden, bis der Empfang ausgeschaltet oder das Fenster geschlossen wird</translation>
    </message>
    <message>
        <source>Receiving port</source>
        <translation>Empfangsport</translation>
    </message>
    <message>
        <source>Receiving AE title</source>
        <translation>AE-Titel für den Empfang</translation>
    </message>
    <message>
        <source>Calling applications must use this called AE title</source>
        <translation>Aufrufende Anwendungen müssen diesen gerufenen AE-Titel benutzen</translation>
    </message>
    <message>
        <source>Select from the received objects</source>
        <translation>Aus den empfangenen Objekten auswählen</translation>
    </message>
    <message>
        <source>as AE title</source>
        <translation>als AE-Titel</translation>
    </message>
    <message>
        <source>Security…</source>
        <translation>Sicherheit…</translation>
    </message>
    <message>
        <source>Sets which applications may connect to this port, and encryption (TLS)</source>
        <translation>Legt fest, welche Anwendungen sich mit diesem Port verbinden dürfen, und die Verschlüsselung (TLS)</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SearchFields</name>
    <message>
        <source>Meier, or *mei*</source>
        <translation>Meier, oder *mei*</translation>
    </message>
    <message>
        <source>Beginning of the name; * and ? are wildcards</source>
        <translation>Anfang des Namens; * und ? sind Platzhalter</translation>
    </message>
    <message>
        <source>Patient ID; * and ? are wildcards</source>
        <translation>Patienten-ID; * und ? sind Platzhalter</translation>
    </message>
    <message>
        <source>2024-01-31</source>
        <translation>2024-01-31</translation>
    </message>
    <message>
        <source>Studies on or after this date; leave empty for no limit</source>
        <translation>Studien ab diesem Datum; leer: unbegrenzt</translation>
    </message>
    <message>
        <source>Studies on or before this date; leave empty for today</source>
        <translation>Studien bis zu diesem Datum; leer: bis heute</translation>
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
        <translation>XA: Angiogramme, CT: Scans</translation>
    </message>
    <message>
        <source>Lists the studies that match all criteria</source>
        <translation>Listet die Studien auf, die allen Kriterien entsprechen</translation>
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
        <source>Send to PACS</source>
        <translation>An PACS senden</translation>
    </message>
    <message>
        <source>The objects are created once. Sending again after an error transfers the same objects, so none is stored twice.</source>
        <translation>Die Objekte werden einmal erzeugt. Erneutes Senden nach einem Fehler sendet dieselben Objekte, sodass keines doppelt gespeichert wird.</translation>
    </message>
    <message>
        <source>No PACS configured. Add one (ask your PACS administrator for host, port and AE title).</source>
        <translation>Kein PACS konfiguriert. Fügen Sie eines hinzu (Host, Port und AE-Titel nennt Ihnen Ihre PACS-Administration).</translation>
    </message>
    <message>
        <source>The objects are sent to %1 when you click “Send”.</source>
        <translation>Die Objekte werden an %1 gesendet, wenn Sie auf „Senden“ klicken.</translation>
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
        <source>Stops the transfer; objects already transferred in full are kept</source>
        <translation>Hält die Übertragung an; bereits vollständig übertragene Objekte bleiben erhalten</translation>
    </message>
</context>
<context>
    <name>angiopose::app::DeidentifyController</name>
    <message>
        <source>De-identifying: %1 %</source>
        <translation>De-Identifizierung: %1 %</translation>
    </message>
    <message>
        <source>A de-identification is already running. Wait for it to finish, or stop it.</source>
        <translation>Eine De-Identifizierung läuft bereits. Warten Sie ihr Ende ab, oder halten Sie sie an.</translation>
    </message>
    <message>
        <source>Files to de-identify</source>
        <translation>Dateien zum De-Identifizieren</translation>
    </message>
    <message>
        <source>Folder to de-identify</source>
        <translation>Ordner zum De-Identifizieren</translation>
    </message>
    <message>
        <source>Output folder</source>
        <translation>Ausgabeordner</translation>
    </message>
    <message>
        <source>De-identifying…</source>
        <translation>De-Identifizierung…</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>De-identified files: %1, in %2.</source>
        <translation>De-identifizierte Dateien: %1, in %2.</translation>
    </message>
    <message>
        <source>%1 files were de-identified; %2 were not, for the reasons listed below. The output folder is %3.</source>
        <translation>%1 Dateien wurden de-identifiziert, %2 nicht; die Gründe stehen unten. Der Ausgabeordner ist %3.</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PrivacyController</name>
    <message>
        <source>Stores no list or thumbnails of recent cases and no folders, and shows no names in the title bar.</source>
        <translation>Speichert keine Liste und keine Vorschaubilder letzter Fälle und keine Ordner und zeigt keine Namen in der Titelleiste.</translation>
    </message>
    <message>
        <source>Turn on private mode?</source>
        <translation>Privaten Modus einschalten?</translation>
    </message>
    <message>
        <source>The list of recent cases (including pinned ones), their thumbnails, and all stored folders and names will be permanently deleted. No such data will be stored until private mode is turned off. Unsaved work is still autosaved; the copies are deleted when the case is closed.</source>
        <translation>Die Liste der letzten Fälle (auch der angehefteten), ihre Vorschaubilder und alle gespeicherten Ordner und Namen werden endgültig gelöscht. Nichts dergleichen wird gespeichert, bis der private Modus ausgeschaltet wird. Ungespeicherte Arbeit wird weiterhin automatisch gesichert; die Kopien werden beim Schließen des Falls gelöscht.</translation>
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
        <source>Writes one line for each file opened, saved or exported: time, user, and SHA-256 of the file.</source>
        <translation>Protokolliert eine Zeile je geöffneter, gespeicherter oder exportierter Datei: Zeit, Benutzer und SHA-256 der Dateien.</translation>
    </message>
    <message>
        <source>Written to %1</source>
        <translation>Geschrieben in %1</translation>
    </message>
    <message>
        <source>Write audit log</source>
        <translation>Audit-Protokoll schreiben</translation>
    </message>
    <message>
        <source>Audit logs (*.jsonl)</source>
        <translation>Audit-Protokolle (*.jsonl)</translation>
    </message>
</context>
<context>
    <name>angiopose::app::SupportController</name>
    <message>
        <source>Save support bundle</source>
        <translation>Supportpaket speichern</translation>
    </message>
    <message>
        <source>ZIP archives (*.zip)</source>
        <translation>ZIP-Archive (*.zip)</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::FaultBar</name>
    <message>
        <source>Save support bundle…</source>
        <translation>Supportpaket speichern…</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>AngioPose crashed during its last session. A report of where in the program it crashed, without case data, was saved to %1.</source>
        <translation>AngioPose ist in der letzten Sitzung abgestürzt. Ein Bericht über die Absturzstelle im Programm, ohne Falldaten, liegt in %1.</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SupportDialog</name>
    <message>
        <source>Save support bundle</source>
        <translation>Supportpaket speichern</translation>
    </message>
    <message>
        <source>The archive contains only the text shown here, no images or vessel data. Names, numbers, dates and paths known from the cases of this session and from this computer have been removed. Review the text before sharing it.</source>
        <translation>Das Archiv enthält nur den hier gezeigten Text, keine Bilder oder Gefäßdaten. Namen, Nummern, Datumsangaben und Pfade, die aus den Fällen dieser Sitzung und von diesem Computer bekannt sind, wurden entfernt. Prüfen Sie den Text vor der Weitergabe.</translation>
    </message>
    <message>
        <source>Files in the bundle</source>
        <translation>Dateien im Paket</translation>
    </message>
    <message>
        <source>Text to be written</source>
        <translation>Zu schreibender Text</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
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
        <source>Shift dates instead of removing them</source>
        <translation>Datumsangaben verschieben statt entfernen</translation>
    </message>
    <message>
        <source>Mask burned-in text</source>
        <translation>Eingebrannten Text maskieren</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>De-identify files</source>
        <translation>Dateien de-identifizieren</translation>
    </message>
    <message>
        <source>DICOM images and objects and PNG, JPEG and TIFF files are copied without names, IDs, dates, private elements and free text; UIDs are replaced. Other files are skipped and listed. Review every image before sharing.</source>
        <translation>DICOM-Bilder und -Objekte sowie PNG-, JPEG- und TIFF-Dateien werden ohne Namen, IDs, Datumsangaben, private Elemente und Freitext kopiert; UIDs werden ersetzt. Andere Dateien werden übersprungen und aufgelistet. Prüfen Sie vor der Weitergabe jedes Bild.</translation>
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
        <source>Add files…</source>
        <translation>Dateien hinzufügen…</translation>
    </message>
    <message>
        <source>Add folder…</source>
        <translation>Ordner hinzufügen…</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>a new or empty folder</source>
        <translation>ein neuer oder leerer Ordner</translation>
    </message>
    <message>
        <source>Output folder</source>
        <translation>Ausgabeordner</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Pseudonym</source>
        <translation>Pseudonym</translation>
    </message>
    <message>
        <source>Write to</source>
        <translation>Schreiben nach</translation>
    </message>
</context>
</TS>
