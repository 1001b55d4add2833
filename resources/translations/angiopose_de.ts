<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>app::BranchController</name>
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
    <message>
        <source>%1 branches</source>
        <translation>%1 Äste</translation>
    </message>
</context>
<context>
    <name>app::CaseController</name>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
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
    <message>
        <source>A registration is running. Stop it to edit.</source>
        <translation>Eine Registrierung läuft. Zum Bearbeiten anhalten.</translation>
    </message>
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
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>Use distances and spacing</source>
        <translation>Abstände und Pixelgröße verwenden</translation>
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
        <source>Stopped: the best pose so far is kept, undo takes it back</source>
        <translation>Angehalten: die bisher beste Lage bleibt, Rückgängig nimmt sie zurück</translation>
    </message>
    <message>
        <source>Registered: median %1 mm</source>
        <translation>Registriert: Median %1 mm</translation>
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
</context>
<context>
    <name>app::ExportController</name>
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
        <source>Poses (*.json *.tfm)</source>
        <translation>Lagen (*.json *.tfm)</translation>
    </message>
    <message>
        <source>No vessels have been traced in this frame yet.</source>
        <translation>In diesem Bild sind noch keine Gefäße erkannt.</translation>
    </message>
    <message>
        <source>Export traced vessels</source>
        <translation>Erkannte Gefäße exportieren</translation>
    </message>
    <message>
        <source>2-D centrelines (*.csv)</source>
        <translation>2-D-Mittellinien (*.csv)</translation>
    </message>
</context>
<context>
    <name>app::HelpController</name>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop a case, or vessels and an angiogram, anywhere. “Open the sample case” works without own data.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The way to a result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each step has a tick, or says in its tool tip what is missing. Click any of them, in any order.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The vessel tree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its branches with length and distance to the image. A takes a branch into the auxiliary set, X leaves it out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The angiogram</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The projected tree lies over it, coloured by distance. Wheel: frames. N: move the tree with arrows or mouse. H: hide it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Register</source>
        <translation type="unfinished">Registrieren</translation>
    </message>
    <message>
        <source>R finds the pose. Stop keeps the best one so far, Ctrl+Z brings the old one back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Can it be trusted?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers in mm, and sentences on what the image cannot tell. Shift+F1 shows good and bad fits.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help is never far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F1 explains what the mouse points at, ? lists and changes all keys. This tour is under Help.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::InputKind</name>
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
    <name>app::JudgementController</name>
    <message>
        <source>nothing to judge yet</source>
        <translation type="unfinished">noch nichts zu beurteilen</translation>
    </message>
</context>
<context>
    <name>app::LanguageController</name>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>The new language holds from the next start of AngioPose.</source>
        <translation>Die neue Sprache gilt ab dem nächsten Start von AngioPose.</translation>
    </message>
</context>
<context>
    <name>app::LookController</name>
    <message>
        <source>Near vessels bright, far ones dim</source>
        <translation>Nahe Gefäße hell, ferne dunkel</translation>
    </message>
    <message>
        <source>Depth cue off</source>
        <translation>Tiefenhinweis aus</translation>
    </message>
    <message>
        <source>This tree knows no radii: only centrelines can be shown.</source>
        <translation>Dieser Gefäßbaum kennt keine Radien: nur Mittellinien sind darstellbar.</translation>
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
</context>
<context>
    <name>app::Notices</name>
    <message>
        <source>Ready</source>
        <translation type="unfinished">Bereit</translation>
    </message>
    <message>
        <source>AngioPose %1</source>
        <translation type="unfinished">AngioPose %1</translation>
    </message>
</context>
<context>
    <name>app::OpenController</name>
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
</context>
<context>
    <name>app::PictureController</name>
    <message>
        <source>The window is in the clipboard as a picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save picture of the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation type="unfinished">PNG-Bilder (*.png)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation type="unfinished">Geschrieben: %1</translation>
    </message>
    <message>
        <source>Could not save the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be written. Choose another folder.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::PoseController</name>
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
</context>
<context>
    <name>app::RegistrationController</name>
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
</context>
<context>
    <name>app::ReplayController</name>
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
        <source>The image hardly tells these apart: ±%1 mm, mostly %2</source>
        <translation>Das Bild unterscheidet diese kaum: ±%1 mm, vor allem %2</translation>
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
        <source>Other solution %1 of %2, score %3 · Shift+J takes it</source>
        <translation>Andere Lösung %1 von %2, Güte %3 · Umschalt+J übernimmt</translation>
    </message>
    <message>
        <source>J shows the other solutions first.</source>
        <translation>J zeigt zuerst die anderen Lösungen.</translation>
    </message>
    <message>
        <source>Take solution %1</source>
        <translation>Lösung %1 übernehmen</translation>
    </message>
</context>
<context>
    <name>app::ReviewController</name>
    <message>
        <source>Choose another frame</source>
        <translation>Anderes Bild wählen</translation>
    </message>
    <message>
        <source>Before: start pose</source>
        <translation>Vorher: Startlage</translation>
    </message>
    <message>
        <source>After: pose as it is</source>
        <translation>Nachher: jetzige Lage</translation>
    </message>
</context>
<context>
    <name>app::SaveController</name>
    <message>
        <source>Save case</source>
        <translation>Fall speichern</translation>
    </message>
    <message>
        <source>Cases (*.angiopose)</source>
        <translation>Fälle (*.angiopose)</translation>
    </message>
    <message>
        <source>a case that was never saved</source>
        <translation>einem nie gespeicherten Fall</translation>
    </message>
    <message>
        <source>Recover unsaved work?</source>
        <translation>Nicht Gespeichertes wiederherstellen?</translation>
    </message>
    <message>
        <source>AngioPose ended unexpectedly. There is a copy of %1 from %2.</source>
        <translation>AngioPose wurde unerwartet beendet. Es gibt eine Kopie von %1 vom %2.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Delete the copy</source>
        <translation>Kopie löschen</translation>
    </message>
    <message>
        <source>Decide later</source>
        <translation>Später entscheiden</translation>
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
</context>
<context>
    <name>app::SeriesRows</name>
    <message>
        <source>Series %1</source>
        <translation type="unfinished">Serie %1</translation>
    </message>
</context>
<context>
    <name>app::SessionController</name>
    <message>
        <source>Not for clinical use</source>
        <translation type="unfinished">Nicht für den klinischen Einsatz</translation>
    </message>
    <message>
        <source>AngioPose is a research program. It is not a medical device: do not use it for diagnosis, treatment or navigation. Results can be wrong; one projection cannot tell everything about depth.</source>
        <translation type="unfinished">AngioPose ist ein Forschungsprogramm und kein Medizinprodukt: nicht für Diagnose, Behandlung oder Navigation verwenden. Ergebnisse können falsch sein; eine einzelne Projektion verrät nicht alles über die Tiefe.</translation>
    </message>
    <message>
        <source>I understand</source>
        <translation type="unfinished">Verstanden</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation type="unfinished">Bereit</translation>
    </message>
    <message>
        <source>Opened</source>
        <translation type="unfinished">Geöffnet</translation>
    </message>
    <message>
        <source>Could not open the file</source>
        <translation type="unfinished">Die Datei ließ sich nicht öffnen</translation>
    </message>
    <message>
        <source>Could not open the files</source>
        <translation type="unfinished">Die Dateien ließen sich nicht öffnen</translation>
    </message>
    <message>
        <source>Could not save</source>
        <translation type="unfinished">Speichern nicht möglich</translation>
    </message>
    <message>
        <source>Saving …</source>
        <translation type="unfinished">Wird gespeichert …</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation type="unfinished">Gespeichert</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation type="unfinished">Wird geschrieben …</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation type="unfinished">Geschrieben: %1</translation>
    </message>
    <message>
        <source>Could not export</source>
        <translation type="unfinished">Export nicht möglich</translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished">Öffnen</translation>
    </message>
    <message>
        <source>Open DICOM folder</source>
        <translation type="unfinished">DICOM-Ordner öffnen</translation>
    </message>
    <message>
        <source>Making the sample case …</source>
        <translation type="unfinished">Beispielfall wird erzeugt …</translation>
    </message>
    <message>
        <source>Could not make the sample case</source>
        <translation type="unfinished">Der Beispielfall ließ sich nicht erzeugen</translation>
    </message>
    <message>
        <source>Save the open case first?</source>
        <translation type="unfinished">Den offenen Fall zuerst speichern?</translation>
    </message>
    <message>
        <source>“%1” has changes that are not saved.</source>
        <translation type="unfinished">„%1“ hat ungespeicherte Änderungen.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished">Speichern</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation type="unfinished">Änderungen verwerfen</translation>
    </message>
    <message>
        <source>Keep the open case</source>
        <translation type="unfinished">Beim offenen Fall bleiben</translation>
    </message>
    <message>
        <source>A registration is running</source>
        <translation type="unfinished">Eine Registrierung läuft</translation>
    </message>
    <message>
        <source>Stop it and close? Changes of this case are lost unless they are saved.</source>
        <translation type="unfinished">Anhalten und schließen? Änderungen an diesem Fall gehen ohne Speichern verloren.</translation>
    </message>
    <message>
        <source>Save before closing?</source>
        <translation type="unfinished">Vor dem Schließen speichern?</translation>
    </message>
    <message>
        <source>Stop, save and close</source>
        <translation type="unfinished">Anhalten, speichern, schließen</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation type="unfinished">Anhalten und schließen</translation>
    </message>
    <message>
        <source>Keep running</source>
        <translation type="unfinished">Weiterlaufen lassen</translation>
    </message>
    <message>
        <source>Save and close</source>
        <translation type="unfinished">Speichern und schließen</translation>
    </message>
    <message>
        <source>Close without saving</source>
        <translation type="unfinished">Ohne Speichern schließen</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation type="unfinished">Bleiben</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation type="unfinished">%1 (fehlt)</translation>
    </message>
</context>
<context>
    <name>app::StepStates</name>
    <message>
        <source>Open a centreline: VTP, VTK, CSV or SWC.</source>
        <translation>Eine Mittellinie öffnen: VTP, VTK, CSV oder SWC.</translation>
    </message>
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
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>look closely</source>
        <translation>genau ansehen</translation>
    </message>
    <message>
        <source>%1 mm median</source>
        <translation>Median %1 mm</translation>
    </message>
    <message>
        <source>written</source>
        <translation>geschrieben</translation>
    </message>
</context>
<context>
    <name>app::ViewSync</name>
    <message>
        <source>Opacification by frame · frame %1 of 0–%2 · fullest: %3 · play C</source>
        <translation>Kontrastfüllung je Bild · Bild %1 von 0–%2 · vollstes: %3 · Abspielen C</translation>
    </message>
    <message>
        <source>Single frame</source>
        <translation>Einzelbild</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>Adds the prior chosen above to the attraction.</source>
        <translation>Addiert den oben gewählten Prior zur Anziehung.</translation>
    </message>
    <message>
        <source>All branches of the vessel tree are excluded. Include at least one branch.</source>
        <translation>Alle Äste des Gefäßbaums sind ausgeschlossen. Mindestens einen einschließen.</translation>
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
        <source>An overlay needs a vessel tree and an angiogram. Open both first.</source>
        <translation>Eine Überlagerung braucht Gefäßbaum und Angiogramm. Zuerst beide öffnen.</translation>
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
        <source>Another pose explains the image nearly as well: compare the alternatives.</source>
        <translation>Eine andere Lage erklärt das Bild fast ebenso gut: die Alternativen vergleichen.</translation>
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
        <source>Branch %1 cannot be cut so near to its end. Delete it instead, or cut farther in.</source>
        <translation>Ast %1 lässt sich so nah am Ende nicht trennen. Stattdessen löschen oder weiter innen trennen.</translation>
    </message>
    <message>
        <source>Branch %1 is chosen as %2 but the vessel tree has no such branch. Choose among its branches.</source>
        <translation>Ast %1 ist als %2 gewählt, aber der Gefäßbaum hat ihn nicht. Unter seinen Ästen wählen.</translation>
    </message>
    <message>
        <source>Brightness under the vessels at their own width, evolution strategy (Jomier 2006; re-implementation, parameters ours).</source>
        <translation>Helligkeit unter den Gefäßen in ihrer eigenen Breite, Evolutionsstrategie (Jomier 2006; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Cases, vessels and angiograms (%1)</source>
        <translation>Fälle, Gefäße und Angiogramme (%1)</translation>
    </message>
    <message>
        <source>Choose a centreline file: .vtp, .vtk, .vtu, .csv, .swc or .mrk.json.</source>
        <translation>Eine Mittelliniendatei wählen: .vtp, .vtk, .vtu, .csv, .swc oder .mrk.json.</translation>
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
        <source>Colour image converted to grey.</source>
        <translation>Farbbild in Graustufen umgewandelt.</translation>
    </message>
    <message>
        <source>Covariance matrix adaptation, or one parent and one child at a time.</source>
        <translation>Anpassung der Kovarianzmatrix, oder je ein Elter und ein Kind.</translation>
    </message>
    <message>
        <source>Curve %1 of the 2-D centreline has a coordinate that is not a number (NaN or infinite).</source>
        <translation>Kurve %1 der 2-D-Mittellinie hat eine Koordinate, die keine Zahl ist (NaN oder unendlich).</translation>
    </message>
    <message>
        <source>DICOM series</source>
        <translation>DICOM-Serie</translation>
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
        <source>Every branch hangs on branch %1: nothing would be left.</source>
        <translation>Alle Äste hängen an Ast %1: nichts bliebe übrig.</translation>
    </message>
    <message>
        <source>Every branch is shorter or thinner than asked: nothing would be left. Lower the limits.</source>
        <translation>Jeder Ast ist kürzer oder dünner als verlangt: nichts bliebe übrig. Grenzen senken.</translation>
    </message>
    <message>
        <source>Failed to validate</source>
        <translation>Prüfung fehlgeschlagen</translation>
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
        <source>Frame %1 does not exist: the image has frames 0 to %2.</source>
        <translation>Bild %1 gibt es nicht: die Aufnahme hat die Bilder 0 bis %2.</translation>
    </message>
    <message>
        <source>GDCM could not write the DICOM file. Choose another format.</source>
        <translation>GDCM konnte die DICOM-Datei nicht schreiben. Anderes Format wählen.</translation>
    </message>
    <message>
        <source>Gradient ascent of the mean kernel between tree and traced vessels, or of the image&apos;s brightness (Aylward 2003; re-implementation, parameters ours).</source>
        <translation>Gradientenaufstieg des mittleren Kerns zwischen Gefäßbaum und erkannten Gefäßen, oder der Bildhelligkeit (Aylward 2003; nachgebaut, eigene Parameter).</translation>
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
        <source>How far across the ray the search reaches.</source>
        <translation>Wie weit die Suche quer zum Strahl reicht.</translation>
    </message>
    <message>
        <source>How far along the vessel walls&apos; normals edges are sought at first.</source>
        <translation>Wie weit anfangs längs der Normalen der Gefäßwände gesucht wird.</translation>
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
        <source>Its slices are stored with different scales or as float. %1</source>
        <translation>Ihre Schichten sind verschieden skaliert oder als Gleitkomma gespeichert. %1</translation>
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
        <source>Least Huber loss of the distances to the nearest traced vessel (Rivest-Hénault 2012; re-implementation, parameters ours).</source>
        <translation>Kleinster Huber-Verlust der Abstände zum nächsten erkannten Gefäß (Rivest-Hénault 2012; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>Least squares on nearest pairs by OpenCV&apos;s SQPNP, repeated: what library parts make in an afternoon.</source>
        <translation>Kleinste Quadrate auf nächsten Paaren mit OpenCVs SQPNP, wiederholt: was Bibliotheksteile an einem Nachmittag ergeben.</translation>
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
        <source>Mask frame %1 does not exist. The run has frames 0 to %2.</source>
        <translation>Maskenbild %1 gibt es nicht. Die Serie hat die Bilder 0 bis %2.</translation>
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
        <source>Missing required property</source>
        <translation>Pflichtangabe fehlt</translation>
    </message>
    <message>
        <source>NICP inside the alternating search (Song, Ghaffari; re-implementation, parameters ours).</source>
        <translation>NICP in der wechselnden Suche (Song, Ghaffari; nachgebaut, eigene Parameter).</translation>
    </message>
    <message>
        <source>NIfTI holds at most 32767 voxels along an axis. Write .nrrd or .mha.</source>
        <translation>NIfTI fasst höchstens 32767 Voxel je Achse. .nrrd oder .mha schreiben.</translation>
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
        <source>No contrast-filled blood stands out in the volume. If it shows vessels, give the threshold at which they begin.</source>
        <translation>Im Volumen hebt sich kein kontrastiertes Blut ab. Falls Gefäße zu sehen sind, die Schwelle angeben, ab der sie beginnen.</translation>
    </message>
    <message>
        <source>Nothing in the volume is like a vessel: no branch is long enough. Lower the threshold or the shortest branch length.</source>
        <translation>Nichts im Volumen gleicht einem Gefäß: kein Ast ist lang genug. Schwelle oder kürzeste Astlänge senken.</translation>
    </message>
    <message>
        <source>Nothing lies inside the surface: it is too open, or thinner than a voxel. Close its holes, or choose a smaller voxel size.</source>
        <translation>In der Oberfläche liegt nichts: sie ist zu offen oder dünner als ein Voxel. Löcher schließen oder kleinere Voxel wählen.</translation>
    </message>
    <message>
        <source>Nothing like a vessel was found in the angiogram frame. Choose a frame with more contrast, raise the sensitivity, or check whether vessels are dark or bright.</source>
        <translation>Im Angiogrammbild wurde nichts Gefäßartiges gefunden. Ein Bild mit mehr Kontrast wählen, die Empfindlichkeit erhöhen, oder prüfen, ob Gefäße dunkel oder hell sind.</translation>
    </message>
    <message>
        <source>One view does not tell the depth here: the distance from the source stays close to the start pose.</source>
        <translation>Eine Projektion allein verrät die Tiefe hier nicht: der Abstand vom Fokus bleibt nahe der Startlage.</translation>
    </message>
    <message>
        <source>Only %1 of the vessel tree lies inside the image.</source>
        <translation>Nur %1 des Gefäßbaums liegen im Bild.</translation>
    </message>
    <message>
        <source>Only %1 of the vessel tree lies on a traced vessel, and it explains %2 of the traced vessels.</source>
        <translation>Nur %1 des Gefäßbaums liegen auf einem erkannten Gefäß, und er erklärt %2 der erkannten Gefäße.</translation>
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
        <source>Processor threads; never changes the result.</source>
        <translation>Prozessor-Threads; ändern nie das Ergebnis.</translation>
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
        <source>SHA-256 cannot be computed. Check the OpenSSL installation.</source>
        <translation>SHA-256 lässt sich nicht berechnen. Die OpenSSL-Installation prüfen.</translation>
    </message>
    <message>
        <source>SID / (0018,1114) magnification %1</source>
        <translation>SID / (0018,1114) Vergrößerung %1</translation>
    </message>
    <message>
        <source>SID is more than three times SOD: the magnification is implausible.</source>
        <translation>SID ist mehr als das Dreifache von SOD: die Vergrößerung ist unplausibel.</translation>
    </message>
    <message>
        <source>SOD is not smaller than SID: the patient would lie behind the detector.</source>
        <translation>SOD ist nicht kleiner als SID: der Patient läge hinter dem Detektor.</translation>
    </message>
    <message>
        <source>Scan and angiogram seem to be of different patients (%1 differ). Check that both are the right ones.</source>
        <translation>CT und Angiogramm scheinen von verschiedenen Patienten zu sein (verschieden: %1). Prüfen, ob beide stimmen.</translation>
    </message>
    <message>
        <source>Scans and surfaces (%1 *.dcm)</source>
        <translation>CT-Daten und Oberflächen (%1 *.dcm)</translation>
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
        <source>Spreads the points evenly before matching; off takes them as they are.</source>
        <translation>Verteilt die Punkte vor dem Zuordnen gleichmäßig; aus nimmt sie, wie sie sind.</translation>
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
        <source>Start depth ±</source>
        <translation>Starttiefe ±</translation>
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
        <source>The %1 voxels are rounded to 16 bit, in steps of %2.</source>
        <translation>Die %1-Voxel werden auf 16 Bit gerundet, in Schritten von %2.</translation>
    </message>
    <message>
        <source>The 2-D centreline is empty: no vessel was found in the image. Choose another frame or a higher sensitivity, or give a centreline file.</source>
        <translation>Die 2-D-Mittellinie ist leer: im Bild wurde kein Gefäß gefunden. Anderes Bild oder höhere Empfindlichkeit wählen, oder eine Mittelliniendatei angeben.</translation>
    </message>
    <message>
        <source>The C-arm moved during this run: the angles are those of the first frame.</source>
        <translation>Der C-Bogen hat sich während der Serie bewegt: die Winkel sind die des ersten Bildes.</translation>
    </message>
    <message>
        <source>The angiogram frame has pixels that are not a number (NaN or infinite). Choose another frame, or export the image again.</source>
        <translation>Das Angiogrammbild hat Pixel, die keine Zahl sind (NaN oder unendlich). Anderes Bild wählen oder neu exportieren.</translation>
    </message>
    <message>
        <source>The angiogram frame is empty. Choose another frame or file.</source>
        <translation>Das Angiogrammbild ist leer. Anderes Bild oder andere Datei wählen.</translation>
    </message>
    <message>
        <source>The angiogram frame is of one colour: there is nothing to trace. Choose another frame or file.</source>
        <translation>Das Angiogrammbild ist einfarbig: es gibt nichts zu erkennen. Anderes Bild oder andere Datei wählen.</translation>
    </message>
    <message>
        <source>The camera needs the image size: width and height must be positive.</source>
        <translation>Die Kamera braucht die Bildgröße: Breite und Höhe müssen positiv sein.</translation>
    </message>
    <message>
        <source>The detector is tilted by %1° (0018,1530): the principal point is uncertain.</source>
        <translation>Der Detektor ist um %1° gekippt (0018,1530): der Hauptpunkt ist unsicher.</translation>
    </message>
    <message>
        <source>The detector pixel spacing</source>
        <translation>Die Pixelgröße des Detektors</translation>
    </message>
    <message>
        <source>The detector pixel spacing lies outside 0.05 to 2 mm.</source>
        <translation>Die Pixelgröße des Detektors liegt außerhalb 0.05 bis 2 mm.</translation>
    </message>
    <message>
        <source>The distance source to detector (SID)</source>
        <translation>Der Abstand Fokus–Detektor (SID)</translation>
    </message>
    <message>
        <source>The distance source to patient (SOD)</source>
        <translation>Der Abstand Fokus–Patient (SOD)</translation>
    </message>
    <message>
        <source>The end of the file is damaged (%1); the image is complete.</source>
        <translation>Das Dateiende ist beschädigt (%1); das Bild ist vollständig.</translation>
    </message>
    <message>
        <source>The focal lengths fx and fy must be finite and not zero.</source>
        <translation>Die Brennweiten fx und fy müssen endlich und ungleich null sein.</translation>
    </message>
    <message>
        <source>The frames of the run differ in size and cannot be subtracted.</source>
        <translation>Die Bilder der Serie sind verschieden groß und lassen sich nicht subtrahieren.</translation>
    </message>
    <message>
        <source>The geometry of view %1 is far from its header: check angles and distances.</source>
        <translation>Die Geometrie der Projektion %1 weicht weit von ihrem Header ab: Winkel und Abstände prüfen.</translation>
    </message>
    <message>
        <source>The header does not say how the axes lie in the patient: i to the left, j to the back and k to the head are assumed. Check left and right.</source>
        <translation>Der Header sagt nicht, wie die Achsen im Patienten liegen: i nach links, j nach hinten, k zum Kopf angenommen. Links und rechts prüfen.</translation>
    </message>
    <message>
        <source>The header does not say how the voxels lie in the patient: +x right to left, +y front to back and +z up are assumed to be i, j reversed and k. Check left and right.</source>
        <translation>Der Header sagt nicht, wie die Voxel im Patienten liegen: +x rechts nach links, +y vorn nach hinten und +z aufwärts als i, umgekehrtes j und k angenommen. Links und rechts prüfen.</translation>
    </message>
    <message>
        <source>The header gives no imager pixel spacing (0018,1164): %1 mm is derived from the field of view. Check it in the geometry.</source>
        <translation>Der Header nennt keine Imager Pixel Spacing (0018,1164): %1 mm aus dem Bildfeld abgeleitet. In der Geometrie prüfen.</translation>
    </message>
    <message>
        <source>The header gives no imager pixel spacing (0018,1164): enter it in the geometry.%1</source>
        <translation>Der Header nennt keine Imager Pixel Spacing (0018,1164): in der Geometrie eintragen.%1</translation>
    </message>
    <message>
        <source>The header gives no imager pixel spacing: %1 mm is derived from the calibrated pixel spacing. Check it in the geometry.</source>
        <translation>Der Header nennt keine Imager Pixel Spacing: %1 mm aus der kalibrierten Pixelgröße abgeleitet. In der Geometrie prüfen.</translation>
    </message>
    <message>
        <source>The header gives no voxel size: 1 x 1 x 1 mm is assumed.</source>
        <translation>Der Header nennt keine Voxelgröße: 1 x 1 x 1 mm angenommen.</translation>
    </message>
    <message>
        <source>The header gives only isocentre angles (0018,9463), whose signs are not certain: enter LAO/RAO and CRA/CAU in the geometry.</source>
        <translation>Der Header nennt nur Isozentrumswinkel (0018,9463), deren Vorzeichen unsicher sind: LAO/RAO und CRA/CAU in der Geometrie eintragen.</translation>
    </message>
    <message>
        <source>The image hardly tells how the vessels are tilted out of the image plane.</source>
        <translation>Das Bild verrät kaum, wie die Gefäße aus der Bildebene gekippt sind.</translation>
    </message>
    <message>
        <source>The image hardly tells how the vessels are turned in the image plane.</source>
        <translation>Das Bild verrät kaum, wie die Gefäße in der Bildebene gedreht sind.</translation>
    </message>
    <message>
        <source>The image hardly tells where along the vessels the tree lies.</source>
        <translation>Das Bild verrät kaum, wo längs der Gefäße der Gefäßbaum liegt.</translation>
    </message>
    <message>
        <source>The image is not of the size that the camera takes. Use the camera that belongs to the image.</source>
        <translation>Das Bild hat nicht die Größe der Kamera. Die zum Bild gehörende Kamera verwenden.</translation>
    </message>
    <message>
        <source>The image is taken as mirrored, after %1. Check that left and right are where they belong.</source>
        <translation>Das Bild gilt als gespiegelt, nach %1. Prüfen, ob links und rechts stimmen.</translation>
    </message>
    <message>
        <source>The image leaves the pose uncertain by about %1.</source>
        <translation>Das Bild lässt die Lage um etwa %1 unsicher.</translation>
    </message>
    <message>
        <source>The imager pixel spacing (%1 mm) does not fit the field of view (%2 mm per pixel): the image may be zoomed or resampled. Check the pixel spacing.</source>
        <translation>Die Imager Pixel Spacing (%1 mm) passt nicht zum Bildfeld (%2 mm je Pixel): das Bild ist vielleicht gezoomt oder umgerechnet. Die Pixelgröße prüfen.</translation>
    </message>
    <message>
        <source>The option %1 is out of range. Give a number from %2 to %3.</source>
        <translation>Die Option %1 liegt außerhalb des Bereichs. Eine Zahl von %2 bis %3 angeben.</translation>
    </message>
    <message>
        <source>The pose to judge is not a rigid motion: its rotation must be orthonormal with determinant +1 and all numbers finite.</source>
        <translation>Die zu beurteilende Lage ist keine starre Bewegung: die Drehung muss orthonormal mit Determinante +1 sein, alle Zahlen endlich.</translation>
    </message>
    <message>
        <source>The positioner angles (LAO/RAO, CRA/CAU) are missing. Enter them in the geometry of the case.</source>
        <translation>Die Durchleuchtungswinkel (LAO/RAO, CRA/CAU) fehlen. In der Geometrie des Falls eintragen.</translation>
    </message>
    <message>
        <source>The primary angle lies outside ±180°.</source>
        <translation>Der Primärwinkel liegt außerhalb ±180°.</translation>
    </message>
    <message>
        <source>The principal point cx, cy must be finite.</source>
        <translation>Der Hauptpunkt cx, cy muss endlich sein.</translation>
    </message>
    <message>
        <source>The refinement ends after so many steps.</source>
        <translation>Die Verfeinerung endet nach so vielen Schritten.</translation>
    </message>
    <message>
        <source>The registration was stopped before its end.</source>
        <translation>Die Registrierung wurde vor ihrem Ende angehalten.</translation>
    </message>
    <message>
        <source>The run has one frame: there is nothing to subtract. Choose a run with frames before the contrast.</source>
        <translation>Die Serie hat nur ein Bild: nichts zu subtrahieren. Eine Serie mit Bildern vor dem Kontrastmittel wählen.</translation>
    </message>
    <message>
        <source>The run shows contrast medium from its first frame on, so no frame serves as mask. Name the mask frames, or trace without subtraction.</source>
        <translation>Die Serie zeigt vom ersten Bild an Kontrastmittel, kein Bild taugt als Maske. Maskenbilder nennen oder ohne Subtraktion erkennen.</translation>
    </message>
    <message>
        <source>The secondary angle lies outside ±90°.</source>
        <translation>Der Sekundärwinkel liegt außerhalb ±90°.</translation>
    </message>
    <message>
        <source>The seed %1 mm (LPS) lies in no vessel. Place it inside one, or lower the threshold.</source>
        <translation>Der Startpunkt %1 mm (LPS) liegt in keinem Gefäß. In eines setzen oder die Schwelle senken.</translation>
    </message>
    <message>
        <source>The series mixes images of %1 sizes or orientations; each is listed by itself.</source>
        <translation>Die Serie mischt Bilder in %1 Größen oder Ausrichtungen; jede ist einzeln aufgeführt.</translation>
    </message>
    <message>
        <source>The slices are not stacked upright (%1° off, as with a tilted gantry): shifted within their planes to where they lie.</source>
        <translation>Die Schichten sind nicht gerade gestapelt (%1°, wie bei geneigter Gantry): in ihren Ebenen an ihren Ort verschoben.</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced (%1 to %2 mm): resampled to %3 mm.</source>
        <translation>Die Schichten sind ungleich beabstandet (%1 bis %2 mm): auf %3 mm umgerechnet.</translation>
    </message>
    <message>
        <source>The spread narrows by a quarter in each.</source>
        <translation>Die Streuung nimmt in jeder um ein Viertel ab.</translation>
    </message>
    <message>
        <source>The start pose is not a rigid motion: its rotation must be orthonormal with determinant +1 and all numbers finite. Correct cameraFromPatient or derive the start pose from the angles.</source>
        <translation>Die Startlage ist keine starre Bewegung: die Drehung muss orthonormal mit Determinante +1 sein, alle Zahlen endlich. cameraFromPatient berichtigen oder die Startlage aus den Winkeln ableiten.</translation>
    </message>
    <message>
        <source>The start pose puts the whole vessel tree behind the X-ray source, where nothing projects. Check the source-to-patient distance and the direction of the start pose.</source>
        <translation>Die Startlage setzt den ganzen Gefäßbaum hinter den Röntgenfokus, wo nichts projiziert. Abstand Fokus–Patient und Richtung der Startlage prüfen.</translation>
    </message>
    <message>
        <source>The surface has no triangles, or the voxel size is not positive. Choose another surface.</source>
        <translation>Die Oberfläche hat keine Dreiecke, oder die Voxelgröße ist nicht positiv. Andere Oberfläche wählen.</translation>
    </message>
    <message>
        <source>The surface is %1 mm across, which is unusual: if its unit is not the millimetre, give the unit.</source>
        <translation>Die Oberfläche misst %1 mm, das ist ungewöhnlich: wenn ihre Einheit nicht Millimeter ist, die Einheit angeben.</translation>
    </message>
    <message>
        <source>The surface is flat: it bounds no inside. Choose the wall of a vessel.</source>
        <translation>Die Oberfläche ist flach: sie umschließt nichts. Eine Gefäßwand wählen.</translation>
    </message>
    <message>
        <source>The surface is not closed (%1 open and %2 crowded edges): its inside is decided by majority. Check the result, or close the holes.</source>
        <translation>Die Oberfläche ist nicht geschlossen (%1 offene und %2 mehrfache Kanten): ihr Inneres entscheidet die Mehrheit. Ergebnis prüfen oder Löcher schließen.</translation>
    </message>
    <message>
        <source>The traced vessels, or the brightness of the image at each vessel&apos;s own width.</source>
        <translation>Die erkannten Gefäße, oder die Bildhelligkeit in der Breite jedes Gefäßes.</translation>
    </message>
    <message>
        <source>The transparency of the image is ignored.</source>
        <translation>Die Transparenz des Bildes bleibt unbeachtet.</translation>
    </message>
    <message>
        <source>The triangles do not agree on inside and outside; overlapping parts may cancel out.</source>
        <translation>Die Dreiecke sind sich über innen und außen uneins; überlappende Teile können sich aufheben.</translation>
    </message>
    <message>
        <source>The vessel mask has no vessel of at least %1 px in it. Draw longer vessels, or lower the shortest length.</source>
        <translation>Die Gefäßmaske enthält kein Gefäß von mindestens %1 px. Längere Gefäße zeichnen oder die kürzeste Länge senken.</translation>
    </message>
    <message>
        <source>The vessel tree has no branch %1.</source>
        <translation>Der Gefäßbaum hat keinen Ast %1.</translation>
    </message>
    <message>
        <source>The vessel tree has no branches. Load a centreline with at least one branch.</source>
        <translation>Der Gefäßbaum hat keine Äste. Eine Mittellinie mit mindestens einem Ast laden.</translation>
    </message>
    <message>
        <source>The vessels fit better %1 aside.</source>
        <translation>Die Gefäße passen %1 daneben besser.</translation>
    </message>
    <message>
        <source>The volume has more than 4 billion voxels. Crop or resample it first.</source>
        <translation>Das Volumen hat mehr als 4 Milliarden Voxel. Zuerst zuschneiden oder umrechnen.</translation>
    </message>
    <message>
        <source>The volume has no valid voxel spacing. Give the spacing in mm, or export the volume again.</source>
        <translation>Das Volumen hat keinen gültigen Voxelabstand. Abstand in mm angeben oder neu exportieren.</translation>
    </message>
    <message>
        <source>The volume holds labels: its vessels are taken as they are marked.</source>
        <translation>Das Volumen enthält Labels: die Gefäße gelten, wie sie markiert sind.</translation>
    </message>
    <message>
        <source>The volume is empty. Choose another series or file.</source>
        <translation>Das Volumen ist leer. Andere Serie oder Datei wählen.</translation>
    </message>
    <message>
        <source>The volume is of one value: there is nothing to trace. Choose another series or file.</source>
        <translation>Das Volumen hat nur einen Wert: nichts zu erkennen. Andere Serie oder Datei wählen.</translation>
    </message>
    <message>
        <source>The voxel size is given as 1 x 1 x 1 mm: check that it was not lost on the way.</source>
        <translation>Die Voxelgröße ist mit 1 x 1 x 1 mm angegeben: prüfen, ob sie unterwegs verloren ging.</translation>
    </message>
    <message>
        <source>The voxel size is too fine for a surface of this extent. Choose a larger one.</source>
        <translation>Die Voxelgröße ist für eine so große Oberfläche zu fein. Größere wählen.</translation>
    </message>
    <message>
        <source>There are places to avoid, but no seed. Place at least one seed in the vessels.</source>
        <translation>Es gibt zu meidende Stellen, aber keinen Startpunkt. Mindestens einen in die Gefäße setzen.</translation>
    </message>
    <message>
        <source>There is no angiogram yet. Open an image first.</source>
        <translation>Noch kein Angiogramm. Zuerst ein Bild öffnen.</translation>
    </message>
    <message>
        <source>There is no method &apos;%1&apos;. Choose one of: %2.</source>
        <translation>Es gibt keine Methode „%1“. Wählbar: %2.</translation>
    </message>
    <message>
        <source>There is no vessel in the volume: nothing is set. Lower the threshold, or load another file.</source>
        <translation>Im Volumen ist kein Gefäß: nichts ist gesetzt. Schwelle senken oder andere Datei laden.</translation>
    </message>
    <message>
        <source>There is no vessel tree yet. Open a centreline first.</source>
        <translation>Noch kein Gefäßbaum. Zuerst eine Mittellinie öffnen.</translation>
    </message>
    <message>
        <source>There is not enough memory for this. Close other programs or use smaller inputs.</source>
        <translation>Dafür reicht der Speicher nicht. Andere Programme schließen oder kleinere Daten verwenden.</translation>
    </message>
    <message>
        <source>This is %1, not X-ray angiography: it has no C-arm geometry.</source>
        <translation>Das ist %1, keine Röntgenangiographie: ohne C-Bogen-Geometrie.</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>Tracing was stopped; nothing was kept.</source>
        <translation>Die Erkennung wurde angehalten; nichts wurde behalten.</translation>
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
        <source>View %1 does not agree with the joint pose.</source>
        <translation>Projektion %1 passt nicht zur gemeinsamen Lage.</translation>
    </message>
    <message>
        <source>View %1 uses another vessel tree or other branches than view 1. Give all views the same.</source>
        <translation>Projektion %1 verwendet einen anderen Gefäßbaum oder andere Äste als Projektion 1. Allen dasselbe geben.</translation>
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
        <source>an HDF5 file</source>
        <translation>eine HDF5-Datei</translation>
    </message>
    <message>
        <source>an MRtrix tractogram</source>
        <translation>ein MRtrix-Traktogramm</translation>
    </message>
    <message>
        <source>an NRRD volume</source>
        <translation>ein NRRD-Volumen</translation>
    </message>
    <message>
        <source>an STL surface</source>
        <translation>eine STL-Oberfläche</translation>
    </message>
    <message>
        <source>an XML file</source>
        <translation>eine XML-Datei</translation>
    </message>
    <message>
        <source>an image without modality</source>
        <translation>ein Bild ohne Modalität</translation>
    </message>
    <message>
        <source>angiogram.frame: %1 does not exist. The image has frames 0 to %2.</source>
        <translation>angiogram.frame: %1 gibt es nicht. Die Aufnahme hat die Bilder 0 bis %2.</translation>
    </message>
    <message>
        <source>angiogram.trace: maxVesselRadiusPx is below minVesselRadiusPx. Exchange them.</source>
        <translation>angiogram.trace: maxVesselRadiusPx liegt unter minVesselRadiusPx. Beide vertauschen.</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>auxiliary</source>
        <translation>Hilfsäste</translation>
    </message>
    <message>
        <source>birth date</source>
        <translation>Geburtsdatum</translation>
    </message>
    <message>
        <source>cameraFromPatient has an entry that is not a finite number.</source>
        <translation>cameraFromPatient enthält einen Eintrag, der keine endliche Zahl ist.</translation>
    </message>
    <message>
        <source>cameraFromPatient is a reflection (determinant below 0). A mirrored image belongs into the sign of fx, never into the rotation.</source>
        <translation>cameraFromPatient ist eine Spiegelung (Determinante unter 0). Ein gespiegeltes Bild gehört ins Vorzeichen von fx, nie in die Drehung.</translation>
    </message>
    <message>
        <source>cameraFromPatient must have four rows of four numbers.</source>
        <translation>cameraFromPatient muss vier Zeilen zu vier Zahlen haben.</translation>
    </message>
    <message>
        <source>converged</source>
        <translation>konvergiert</translation>
    </message>
    <message>
        <source>derived</source>
        <translation>abgeleitet</translation>
    </message>
    <message>
        <source>frame %1 cannot be decoded (transfer syntax %2): damaged, cut short, or a compression this program does not read. Export the run again, uncompressed if possible.</source>
        <translation>Bild %1 lässt sich nicht dekodieren (Transfersyntax %2): beschädigt, unvollständig oder unbekannte Kompression. Serie neu exportieren, möglichst unkomprimiert.</translation>
    </message>
    <message>
        <source>full</source>
        <translation>alle Punkte</translation>
    </message>
    <message>
        <source>geometry.camera: it is for an image of %1 x %2 pixels, but the angiogram has %3 x %4. Give the camera of this image.</source>
        <translation>geometry.camera: gilt für ein Bild mit %1 x %2 Pixeln, das Angiogramm hat aber %3 x %4. Die Kamera dieses Bildes angeben.</translation>
    </message>
    <message>
        <source>header</source>
        <translation>Header</translation>
    </message>
    <message>
        <source>identity hidden</source>
        <translation>Patientendaten verborgen</translation>
    </message>
    <message>
        <source>it cannot be opened (%1). Check that you may read it.</source>
        <translation>lässt sich nicht öffnen (%1). Leserechte prüfen.</translation>
    </message>
    <message>
        <source>it cannot be reached (%1). Check the path.</source>
        <translation>ist nicht erreichbar (%1). Pfad prüfen.</translation>
    </message>
    <message>
        <source>it cannot be read (%1). Copy it to a local disk.</source>
        <translation>lässt sich nicht lesen (%1). Auf eine lokale Platte kopieren.</translation>
    </message>
    <message>
        <source>it cannot be read. Copy it to a local disk.</source>
        <translation>lässt sich nicht lesen. Auf eine lokale Platte kopieren.</translation>
    </message>
    <message>
        <source>it cannot be written (%1). Choose another folder or make room.</source>
        <translation>lässt sich nicht schreiben (%1). Anderen Ordner wählen oder Platz schaffen.</translation>
    </message>
    <message>
        <source>it declares %1 frames of %2 x %3 pixels, more than this program holds. Export fewer frames.</source>
        <translation>nennt %1 Bilder mit %2 x %3 Pixeln, mehr als dieses Programm fasst. Weniger Bilder exportieren.</translation>
    </message>
    <message>
        <source>it declares %1, more than this program holds. Crop the scan to the vessels.</source>
        <translation>nennt %1, mehr als dieses Programm fasst. Den Scan auf die Gefäße zuschneiden.</translation>
    </message>
    <message>
        <source>it declares more data than memory holds. The file is damaged; export it again.</source>
        <translation>nennt mehr Daten, als in den Speicher passen. Die Datei ist beschädigt; neu exportieren.</translation>
    </message>
    <message>
        <source>it does not begin like a VTK file. Export the centrelines again.</source>
        <translation>beginnt nicht wie eine VTK-Datei. Die Mittellinien neu exportieren.</translation>
    </message>
    <message>
        <source>it does not follow the published schema. Compare it with a case that loads.</source>
        <translation>folgt nicht dem veröffentlichten Schema. Mit einem ladbaren Fall vergleichen.</translation>
    </message>
    <message>
        <source>it does not hold one ITK transform as text. Export a single rigid transform.</source>
        <translation>enthält nicht eine ITK-Transformation als Text. Eine einzelne starre Transformation exportieren.</translation>
    </message>
    <message>
        <source>it does not say where its voxels are (ElementDataFile). Export it again.</source>
        <translation>sagt nicht, wo die Voxel liegen (ElementDataFile). Neu exportieren.</translation>
    </message>
    <message>
        <source>it has %1 dimensions (4-D or more). Save the one volume to use and open that.</source>
        <translation>hat %1 Dimensionen (4-D oder mehr). Das gewünschte Volumen einzeln speichern und öffnen.</translation>
    </message>
    <message>
        <source>it has %1 dimensions, but a volume has three. Choose the whole scan.</source>
        <translation>hat %1 Dimensionen, ein Volumen aber drei. Den ganzen Scan wählen.</translation>
    </message>
    <message>
        <source>it has %1 points; a centreline tree has at most %2. Resample the centrelines.</source>
        <translation>hat %1 Punkte; ein Gefäßbaum hat höchstens %2. Die Mittellinien ausdünnen.</translation>
    </message>
    <message>
        <source>it has %1 separate lines; a centreline tree has at most %2. Keep the vessels of interest.</source>
        <translation>hat %1 getrennte Linien; ein Gefäßbaum hat höchstens %2. Nur die wichtigen Gefäße behalten.</translation>
    </message>
    <message>
        <source>it has %1 values per voxel. Choose the scan itself, in grey values.</source>
        <translation>hat %1 Werte je Voxel. Den Scan selbst in Grauwerten wählen.</translation>
    </message>
    <message>
        <source>it has %1: a single slice is no volume. Choose the whole scan.</source>
        <translation>hat %1: eine einzelne Schicht ist kein Volumen. Den ganzen Scan wählen.</translation>
    </message>
    <message>
        <source>it has a column z: this is a 3-D centreline. Choose the centreline traced in the image.</source>
        <translation>hat eine Spalte z: das ist eine 3-D-Mittellinie. Die im Bild erkannte Mittellinie wählen.</translation>
    </message>
    <message>
        <source>it has more than a million points. Resample the centreline.</source>
        <translation>hat über eine Million Punkte. Die Mittellinie ausdünnen.</translation>
    </message>
    <message>
        <source>it has more triangles than this program holds. Decimate the surface.</source>
        <translation>hat mehr Dreiecke, als dieses Programm fasst. Die Oberfläche vereinfachen.</translation>
    </message>
    <message>
        <source>it has no matrix `cameraFromPatient` of four rows of four numbers, at the top or in `pose`. Give one.</source>
        <translation>hat keine Matrix `cameraFromPatient` mit vier Zeilen zu vier Zahlen, weder oben noch in `pose`. Eine angeben.</translation>
    </message>
    <message>
        <source>it holds %1 volumes or values per voxel (4-D). Extract the one to use and open that.</source>
        <translation>enthält %1 Volumen oder Werte je Voxel (4-D). Das gewünschte herauslösen und öffnen.</translation>
    </message>
    <message>
        <source>it holds %1 volumes, layers or values per voxel (4-D). Save the one to use and open that.</source>
        <translation>enthält %1 Volumen, Lagen oder Werte je Voxel (4-D). Das gewünschte einzeln speichern und öffnen.</translation>
    </message>
    <message>
        <source>it holds %1, not POLYDATA or UNSTRUCTURED_GRID. Export the centrelines as poly-lines.</source>
        <translation>enthält %1, nicht POLYDATA oder UNSTRUCTURED_GRID. Die Mittellinien als Polylinien exportieren.</translation>
    </message>
    <message>
        <source>it holds %1, which is no label: labels are whole numbers from 0. Choose a label image.</source>
        <translation>enthält %1, kein Label: Labels sind ganze Zahlen ab 0. Ein Labelbild wählen.</translation>
    </message>
    <message>
        <source>it holds a %1, not an image. Choose the scan.</source>
        <translation>enthält ein %1, kein Bild. Den Scan wählen.</translation>
    </message>
    <message>
        <source>it holds a surface, not centrelines. Extract the centrelines first (e.g. with VMTK or Slicer) and open those.</source>
        <translation>enthält eine Oberfläche, keine Mittellinien. Diese zuerst berechnen (etwa mit VMTK oder Slicer) und öffnen.</translation>
    </message>
    <message>
        <source>it holds more than 50000 files. Choose the folder of one study.</source>
        <translation>enthält über 50000 Dateien. Den Ordner einer einzelnen Untersuchung wählen.</translation>
    </message>
    <message>
        <source>it holds no lines. Choose a file with vessel centrelines.</source>
        <translation>enthält keine Linien. Eine Datei mit Gefäß-Mittellinien wählen.</translation>
    </message>
    <message>
        <source>it holds no triangles. Choose the surface of a vessel.</source>
        <translation>enthält keine Dreiecke. Die Oberfläche eines Gefäßes wählen.</translation>
    </message>
    <message>
        <source>it is a DICOM segmentation. Export it as a NIfTI or NRRD label image.</source>
        <translation>ist eine DICOM-Segmentierung. Als NIfTI- oder NRRD-Labelbild exportieren.</translation>
    </message>
    <message>
        <source>it is a colour image. Choose the scan itself, in grey values.</source>
        <translation>ist ein Farbbild. Den Scan selbst in Grauwerten wählen.</translation>
    </message>
    <message>
        <source>it is a single slice, not a volume. Copy all slices of the series, or choose another one.</source>
        <translation>ist eine einzelne Schicht, kein Volumen. Alle Schichten der Serie kopieren oder eine andere wählen.</translation>
    </message>
    <message>
        <source>it is not VTK XML PolyData or UnstructuredGrid. Export the centrelines as .vtp.</source>
        <translation>ist weder VTK-XML-PolyData noch UnstructuredGrid. Die Mittellinien als .vtp exportieren.</translation>
    </message>
    <message>
        <source>it is not a Slicer markups file with curves. Export the centrelines as .mrk.json curves, .vtp, .vtk, .csv or .swc.</source>
        <translation>ist keine Slicer-Markups-Datei mit Kurven. Die Mittellinien als .mrk.json-Kurven, .vtp, .vtk, .csv oder .swc exportieren.</translation>
    </message>
    <message>
        <source>it is not valid JSON at line %1. Correct it there.</source>
        <translation>ist in Zeile %1 kein gültiges JSON. Dort berichtigen.</translation>
    </message>
    <message>
        <source>it is only %1 x %2 pixels. Choose the angiogram at its full size.</source>
        <translation>hat nur %1 x %2 Pixel. Das Angiogramm in voller Größe wählen.</translation>
    </message>
    <message>
        <source>it is stored in palette colours. Export the angiogram in grey.</source>
        <translation>ist in Palettenfarben gespeichert. Das Angiogramm in Graustufen exportieren.</translation>
    </message>
    <message>
        <source>it is too large for a case file. Choose an .angiopose file.</source>
        <translation>ist zu groß für eine Falldatei. Eine .angiopose-Datei wählen.</translation>
    </message>
    <message>
        <source>it is too large for a pose. Choose a .json or .tfm file.</source>
        <translation>ist zu groß für eine Lage. Eine .json- oder .tfm-Datei wählen.</translation>
    </message>
    <message>
        <source>it looks like a list of graph nodes (column id), which has no order along the vessels. Give a branch column, or export the centrelines themselves.</source>
        <translation>sieht nach einer Liste von Graphknoten aus (Spalte id) ohne Reihenfolge längs der Gefäße. Eine Spalte branch angeben oder die Mittellinien selbst exportieren.</translation>
    </message>
    <message>
        <source>it skips lines of another file. Save header and voxels as one file.</source>
        <translation>überspringt Zeilen einer anderen Datei. Header und Voxel als eine Datei speichern.</translation>
    </message>
    <message>
        <source>iteration limit</source>
        <translation>Iterationsgrenze</translation>
    </message>
    <message>
        <source>its DimSize makes no sense. The file is damaged; export it again.</source>
        <translation>die DimSize ergibt keinen Sinn. Die Datei ist beschädigt; neu exportieren.</translation>
    </message>
    <message>
        <source>its HeaderSize makes no sense. Correct the header.</source>
        <translation>die HeaderSize ergibt keinen Sinn. Den Header berichtigen.</translation>
    </message>
    <message>
        <source>its JSON is nested more than %1 levels deep. This is no file of this program.</source>
        <translation>das JSON ist mehr als %1 Ebenen tief. Das ist keine Datei dieses Programms.</translation>
    </message>
    <message>
        <source>its PLY data are damaged or cut short. Export it again.</source>
        <translation>die PLY-Daten sind beschädigt oder unvollständig. Neu exportieren.</translation>
    </message>
    <message>
        <source>its PLY header is damaged or cut short. Export it again.</source>
        <translation>der PLY-Header ist beschädigt oder unvollständig. Neu exportieren.</translation>
    </message>
    <message>
        <source>its PLY header is damaged: the element &quot;%1&quot; has no properties. Export it again.</source>
        <translation>der PLY-Header ist beschädigt: das Element &quot;%1&quot; hat keine Eigenschaften. Neu exportieren.</translation>
    </message>
    <message>
        <source>its axes are %1° apart instead of 90°. Resample the volume to perpendicular axes.</source>
        <translation>die Achsen stehen %1° statt 90° zueinander. Das Volumen auf senkrechte Achsen umrechnen.</translation>
    </message>
    <message>
        <source>its bits per pixel contradict each other. The header is damaged; export the run again.</source>
        <translation>die Angaben der Bits je Pixel widersprechen sich. Der Header ist beschädigt; Serie neu exportieren.</translation>
    </message>
    <message>
        <source>its centre is not finite. Export the transform again.</source>
        <translation>der Mittelpunkt ist nicht endlich. Die Transformation neu exportieren.</translation>
    </message>
    <message>
        <source>its compressed pixels are cut short. Copy or export it again.</source>
        <translation>die komprimierten Pixel sind unvollständig. Neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>its coordinates are in %1. Export the curves in mm.</source>
        <translation>die Koordinaten sind in %1. Die Kurven in mm exportieren.</translation>
    </message>
    <message>
        <source>its deflated content is damaged or cut short. Copy or export it again.</source>
        <translation>der gepackte Inhalt ist beschädigt oder unvollständig. Neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>its first axis has %1 entries: this is a colour picture, not a volume. Choose the scan.</source>
        <translation>die erste Achse hat %1 Einträge: das ist ein Farbbild, kein Volumen. Den Scan wählen.</translation>
    </message>
    <message>
        <source>its header gives %1. The file is damaged; export it again.</source>
        <translation>der Header nennt %1. Die Datei ist beschädigt; neu exportieren.</translation>
    </message>
    <message>
        <source>its header gives no image size. The file is damaged; export the run again.</source>
        <translation>der Header nennt keine Bildgröße. Die Datei ist beschädigt; Serie neu exportieren.</translation>
    </message>
    <message>
        <source>its header gives no usable voxel size or place. Export the volume again.</source>
        <translation>der Header nennt keine brauchbare Voxelgröße oder Lage. Das Volumen neu exportieren.</translation>
    </message>
    <message>
        <source>its header is damaged: it names %1 dimensions. Export it again.</source>
        <translation>der Header ist beschädigt: er nennt %1 Dimensionen. Neu exportieren.</translation>
    </message>
    <message>
        <source>its header is damaged: the voxels begin at an impossible place. Export it again.</source>
        <translation>der Header ist beschädigt: die Voxel beginnen an unmöglicher Stelle. Neu exportieren.</translation>
    </message>
    <message>
        <source>its images do not say how large a pixel is, so they make no volume. Choose another series.</source>
        <translation>die Bilder nennen keine Pixelgröße und ergeben kein Volumen. Andere Serie wählen.</translation>
    </message>
    <message>
        <source>its images do not say where they lie in the patient, so they make no volume. Choose another series.</source>
        <translation>die Bilder nennen keine Lage im Patienten und ergeben kein Volumen. Andere Serie wählen.</translation>
    </message>
    <message>
        <source>its line skip or byte skip makes no sense. Correct the header.</source>
        <translation>line skip oder byte skip ergibt keinen Sinn. Den Header berichtigen.</translation>
    </message>
    <message>
        <source>its lines visit the same points too often. The file is damaged; export it again.</source>
        <translation>die Linien besuchen dieselben Punkte zu oft. Die Datei ist beschädigt; neu exportieren.</translation>
    </message>
    <message>
        <source>its pixels (%1, %2 samples) are not grey or colour. Export the angiogram in grey.</source>
        <translation>die Pixel (%1, %2 Werte) sind weder grau noch farbig. Das Angiogramm in Graustufen exportieren.</translation>
    </message>
    <message>
        <source>its pixels are cut short: %1 of %2 bytes are there. Copy or export it again.</source>
        <translation>die Pixel sind unvollständig: %1 von %2 Bytes vorhanden. Neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>its pixels are not finite numbers of a known kind. Export it with 8 or 16 bits.</source>
        <translation>die Pixel sind keine endlichen Zahlen bekannter Art. Mit 8 oder 16 Bit exportieren.</translation>
    </message>
    <message>
        <source>its pixels are not of the size its header gives. Export it again.</source>
        <translation>die Pixel haben nicht die Größe laut Header. Neu exportieren.</translation>
    </message>
    <message>
        <source>its pixels have %1 bits. Export the angiogram with 8 or 16 bits.</source>
        <translation>die Pixel haben %1 Bit. Das Angiogramm mit 8 oder 16 Bit exportieren.</translation>
    </message>
    <message>
        <source>its sizes are no numbers. The file is damaged; export it again.</source>
        <translation>die Größen sind keine Zahlen. Die Datei ist beschädigt; neu exportieren.</translation>
    </message>
    <message>
        <source>its slices lie beside each other rather than above. Choose another series.</source>
        <translation>die Schichten liegen neben- statt übereinander. Andere Serie wählen.</translation>
    </message>
    <message>
        <source>its slices lie too unevenly to make a volume of them (%1 over %2 mm). Copy all slices of the series, or choose another one.</source>
        <translation>die Schichten liegen zu ungleich für ein Volumen (%1 auf %2 mm). Alle Schichten der Serie kopieren oder eine andere wählen.</translation>
    </message>
    <message>
        <source>its transform &quot;%1&quot; is not rigid, or lacks parameters. Export a rigid transform (affine, Euler3D or VersorRigid3D).</source>
        <translation>die Transformation &quot;%1&quot; ist nicht starr oder hat zu wenig Parameter. Eine starre exportieren (affine, Euler3D oder VersorRigid3D).</translation>
    </message>
    <message>
        <source>its triangles are damaged or cut short. Copy or export it again.</source>
        <translation>die Dreiecke sind beschädigt oder unvollständig. Neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>its voxel type (&quot;%1&quot;) is not read. Save it as 16-bit or float.</source>
        <translation>der Voxeltyp (&quot;%1&quot;) wird nicht gelesen. Als 16 Bit oder float speichern.</translation>
    </message>
    <message>
        <source>its voxel type (NIfTI datatype %1) is not read. Save it as 16-bit or float.</source>
        <translation>der Voxeltyp (NIfTI-Datentyp %1) wird nicht gelesen. Als 16 Bit oder float speichern.</translation>
    </message>
    <message>
        <source>its voxels are colours. Choose the scan itself, in grey values.</source>
        <translation>die Voxel sind Farben. Den Scan selbst in Grauwerten wählen.</translation>
    </message>
    <message>
        <source>its voxels are cut short, or their packing is damaged. Copy or export it again.</source>
        <translation>die Voxel sind unvollständig oder falsch gepackt. Neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>its voxels are cut short. Copy or export it again.</source>
        <translation>die Voxel sind unvollständig. Neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>its voxels are cut short: %1 of %2 bytes are there. Copy or export it again.</source>
        <translation>die Voxel sind unvollständig: %1 von %2 Bytes vorhanden. Neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>its voxels are packed with bzip2. Save it with gzip or raw encoding.</source>
        <translation>die Voxel sind mit bzip2 gepackt. Mit gzip oder roh speichern.</translation>
    </message>
    <message>
        <source>its voxels are written as text (%1). Save it with gzip or raw encoding.</source>
        <translation>die Voxel sind als Text geschrieben (%1). Mit gzip oder roh speichern.</translation>
    </message>
    <message>
        <source>its voxels are written as text. Save it with binary data.</source>
        <translation>die Voxel sind als Text geschrieben. Binär speichern.</translation>
    </message>
    <message>
        <source>its voxels lie in several files. Save it as one file.</source>
        <translation>die Voxel liegen in mehreren Dateien. Als eine Datei speichern.</translation>
    </message>
    <message>
        <source>line %1 does not give a point. The file is damaged; export it again.</source>
        <translation>Zeile %1 ergibt keinen Punkt. Die Datei ist beschädigt; neu exportieren.</translation>
    </message>
    <message>
        <source>line %1 has %2 columns, the first line has %3. Separate columns by commas and use . as decimal point.</source>
        <translation>Zeile %1 hat %2 Spalten, die erste hat %3. Spalten durch Kommas trennen, Dezimalpunkt verwenden.</translation>
    </message>
    <message>
        <source>line %1 is not `id type x y z radius parent`. Correct the line or export it again.</source>
        <translation>Zeile %1 ist nicht `id type x y z radius parent`. Berichtigen oder neu exportieren.</translation>
    </message>
    <message>
        <source>line %1 lies far outside any image. Coordinates are in pixels.</source>
        <translation>Zeile %1 liegt weit außerhalb jedes Bildes. Koordinaten sind in Pixeln.</translation>
    </message>
    <message>
        <source>line %1 names a parent, %2, that is not there. Export the whole tree.</source>
        <translation>Zeile %1 nennt ein Elternteil %2, das fehlt. Den ganzen Baum exportieren.</translation>
    </message>
    <message>
        <source>line %1 repeats an id. Ids must be unique.</source>
        <translation>Zeile %1 wiederholt eine id. Jede id muss einmalig sein.</translation>
    </message>
    <message>
        <source>line %1, column %2: &quot;%3&quot; is not a finite number. Correct or remove the line.</source>
        <translation>Zeile %1, Spalte %2: &quot;%3&quot; ist keine endliche Zahl. Berichtigen oder entfernen.</translation>
    </message>
    <message>
        <source>line %1: the branch must be a whole number. Correct the line.</source>
        <translation>Zeile %1: branch muss eine ganze Zahl sein. Berichtigen.</translation>
    </message>
    <message>
        <source>method: &quot;%1&quot; is unknown. Use one of %2.</source>
        <translation>method: &quot;%1&quot; ist unbekannt. Möglich: %2.</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>modality %1</source>
        <translation>Modalität %1</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>no DICOM element in it can be read. The file is damaged; copy or export it again.</source>
        <translation>kein DICOM-Element darin ist lesbar. Die Datei ist beschädigt; neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>no data set</source>
        <translation>kein Datensatz</translation>
    </message>
    <message>
        <source>no file this program knows</source>
        <translation>keine bekannte Datei</translation>
    </message>
    <message>
        <source>no image this program reads</source>
        <translation>kein lesbares Bild</translation>
    </message>
    <message>
        <source>no improvement</source>
        <translation>keine Verbesserung</translation>
    </message>
    <message>
        <source>no name</source>
        <translation>kein Name</translation>
    </message>
    <message>
        <source>no series in this folder makes a volume. Choose another folder.</source>
        <translation>keine Serie dieses Ordners ergibt ein Volumen. Anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>none of its lines has two different points. Choose a file with vessel centrelines.</source>
        <translation>keine der Linien hat zwei verschiedene Punkte. Eine Datei mit Gefäß-Mittellinien wählen.</translation>
    </message>
    <message>
        <source>none of its triangles has an area. Choose the surface of a vessel.</source>
        <translation>keines der Dreiecke hat eine Fläche. Die Oberfläche eines Gefäßes wählen.</translation>
    </message>
    <message>
        <source>none of its voxels is a number. Export the volume again.</source>
        <translation>keines der Voxel ist eine Zahl. Das Volumen neu exportieren.</translation>
    </message>
    <message>
        <source>number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>only %1 of its %2 frames are there. Copy or export it again.</source>
        <translation>nur %1 von %2 Bildern vorhanden. Neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>options.%1: give %2.</source>
        <translation>options.%1: angeben: %2.</translation>
    </message>
    <message>
        <source>part %1 of %2</source>
        <translation>Teil %1 von %2</translation>
    </message>
    <message>
        <source>pose.initial: it is missing, and the angles do not give a start pose. %1</source>
        <translation>pose.initial: fehlt, und die Winkel ergeben keine Startlage. %1</translation>
    </message>
    <message>
        <source>poses are written as .json or .tfm. Change the extension.</source>
        <translation>Lagen werden als .json oder .tfm geschrieben. Die Endung ändern.</translation>
    </message>
    <message>
        <source>reading was stopped.</source>
        <translation>das Lesen wurde angehalten.</translation>
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
        <source>stopped by the user</source>
        <translation>von Hand angehalten</translation>
    </message>
    <message>
        <source>surfaces are written as .stl. Change the extension.</source>
        <translation>Oberflächen werden als .stl geschrieben. Die Endung ändern.</translation>
    </message>
    <message>
        <source>the SWC unit must be a positive length in mm.</source>
        <translation>die SWC-Einheit muss eine positive Länge in mm sein.</translation>
    </message>
    <message>
        <source>the VTK XML data in it is damaged or cut short. Export it again.</source>
        <translation>die VTK-XML-Daten sind beschädigt oder unvollständig. Neu exportieren.</translation>
    </message>
    <message>
        <source>the element %1 declares %2 bytes, but %3 are left</source>
        <translation>das Element %1 nennt %2 Bytes, es bleiben aber %3</translation>
    </message>
    <message>
        <source>the file is empty. Export or copy it again.</source>
        <translation>die Datei ist leer. Neu exportieren oder kopieren.</translation>
    </message>
    <message>
        <source>the file with its voxels cannot be read (%1).</source>
        <translation>die Datei mit den Voxeln lässt sich nicht lesen (%1).</translation>
    </message>
    <message>
        <source>the first line must name the columns: x,y,z and, where known, radius,branch.</source>
        <translation>die erste Zeile muss die Spalten nennen: x,y,z und, wo bekannt, radius,branch.</translation>
    </message>
    <message>
        <source>the folder cannot be read (%1). Check the path.</source>
        <translation>der Ordner lässt sich nicht lesen (%1). Pfad prüfen.</translation>
    </message>
    <message>
        <source>the folder cannot be read to its end. Copy it to a local disk.</source>
        <translation>der Ordner lässt sich nicht zu Ende lesen. Auf eine lokale Platte kopieren.</translation>
    </message>
    <message>
        <source>the frames differ in size. All frames of a run must be equally large.</source>
        <translation>die Bilder sind verschieden groß. Alle Bilder einer Serie müssen gleich groß sein.</translation>
    </message>
    <message>
        <source>the header row has no columns x and y. The first line must name the columns: x,y and, where known, branch,radius (px).</source>
        <translation>der Kopfzeile fehlen die Spalten x und y. Die erste Zeile muss die Spalten nennen: x,y und, wo bekannt, branch,radius (px).</translation>
    </message>
    <message>
        <source>the header row has no columns x, y and z. Name them (mm, patient LPS).</source>
        <translation>der Kopfzeile fehlen die Spalten x, y und z. Sie benennen (mm, Patient LPS).</translation>
    </message>
    <message>
        <source>the image cannot be decoded: damaged, cut short or of an unusual kind. Export it again.</source>
        <translation>das Bild lässt sich nicht dekodieren: beschädigt, unvollständig oder ungewöhnlich. Neu exportieren.</translation>
    </message>
    <message>
        <source>the image has fewer than 8 pixels on a side, or more than this program holds. Export the angiogram at its own size.</source>
        <translation>das Bild hat weniger als 8 Pixel je Seite, oder mehr als dieses Programm fasst. Das Angiogramm in eigener Größe exportieren.</translation>
    </message>
    <message>
        <source>the image is damaged or cut short. Copy or export it again.</source>
        <translation>das Bild ist beschädigt oder unvollständig. Neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>the image is damaged or of an unusual kind. Export it in grey or RGB with 8 or 16 bits, without tiles.</source>
        <translation>das Bild ist beschädigt oder ungewöhnlich. In Grau oder RGB mit 8 oder 16 Bit ohne Kacheln exportieren.</translation>
    </message>
    <message>
        <source>the last row of cameraFromPatient must be 0 0 0 1. Is the matrix transposed?</source>
        <translation>die letzte Zeile von cameraFromPatient muss 0 0 0 1 sein. Ist die Matrix transponiert?</translation>
    </message>
    <message>
        <source>the pose is not a rigid motion of finite numbers. Reset it before saving.</source>
        <translation>die Lage ist keine starre Bewegung endlicher Zahlen. Vor dem Speichern zurücksetzen.</translation>
    </message>
    <message>
        <source>the pose is not a rigid motion of finite numbers. Reset the pose before saving.</source>
        <translation>die Lage ist keine starre Bewegung endlicher Zahlen. Vor dem Speichern zurücksetzen.</translation>
    </message>
    <message>
        <source>the run is too large for an uncompressed DICOM file. Write fewer frames.</source>
        <translation>die Serie ist zu groß für eine unkomprimierte DICOM-Datei. Weniger Bilder schreiben.</translation>
    </message>
    <message>
        <source>the section &quot;%1&quot; is damaged or cut short. Export it again.</source>
        <translation>der Abschnitt &quot;%1&quot; ist beschädigt oder unvollständig. Neu exportieren.</translation>
    </message>
    <message>
        <source>the sequence %1 has no end</source>
        <translation>die Sequenz %1 hat kein Ende</translation>
    </message>
    <message>
        <source>the series %1 is not in this folder. Choose the folder it is in.</source>
        <translation>die Serie %1 ist nicht in diesem Ordner. Den richtigen Ordner wählen.</translation>
    </message>
    <message>
        <source>the series of the case is not in this folder. Choose the folder it is in.</source>
        <translation>die Serie des Falls ist nicht in diesem Ordner. Den richtigen Ordner wählen.</translation>
    </message>
    <message>
        <source>the third line of a legacy VTK file must be ASCII or BINARY. Export it again.</source>
        <translation>die dritte Zeile einer alten VTK-Datei muss ASCII oder BINARY sein. Neu exportieren.</translation>
    </message>
    <message>
        <source>the unit must be a positive length in mm.</source>
        <translation>die Einheit muss eine positive Länge in mm sein.</translation>
    </message>
    <message>
        <source>the upper left 3 x 3 of cameraFromPatient is not a rotation (scale or shear). Give a rigid pose in mm.</source>
        <translation>die linken oberen 3 x 3 von cameraFromPatient sind keine Drehung (Skalierung oder Scherung). Eine starre Lage in mm angeben.</translation>
    </message>
    <message>
        <source>the volume is larger than this computer&apos;s memory. Crop the scan to the vessels.</source>
        <translation>das Volumen ist größer als der Speicher dieses Rechners. Den Scan auf die Gefäße zuschneiden.</translation>
    </message>
    <message>
        <source>there are no frames to write. Load or simulate an angiogram first.</source>
        <translation>keine Bilder zu schreiben. Zuerst ein Angiogramm laden oder simulieren.</translation>
    </message>
    <message>
        <source>there are no voxels to write. Load a volume first.</source>
        <translation>keine Voxel zu schreiben. Zuerst ein Volumen laden.</translation>
    </message>
    <message>
        <source>there is no DICOM image in this folder. Choose the folder of a scan.</source>
        <translation>in diesem Ordner ist kein DICOM-Bild. Den Ordner eines Scans wählen.</translation>
    </message>
    <message>
        <source>there is no memory left to pack the volume.</source>
        <translation>kein Speicher mehr, um das Volumen zu packen.</translation>
    </message>
    <message>
        <source>there is no picture to write. Render or trace one first.</source>
        <translation>kein Bild zu schreiben. Zuerst eines erzeugen.</translation>
    </message>
    <message>
        <source>there is no such file. Check the path.</source>
        <translation>die Datei gibt es nicht. Pfad prüfen.</translation>
    </message>
    <message>
        <source>there is not enough memory to write this run. Write fewer frames.</source>
        <translation>der Speicher reicht nicht, um diese Serie zu schreiben. Weniger Bilder schreiben.</translation>
    </message>
    <message>
        <source>this DICOM file (%1)</source>
        <translation>diese DICOM-Datei (%1)</translation>
    </message>
    <message>
        <source>this DICOM file holds no image. Choose a scan.</source>
        <translation>diese DICOM-Datei enthält kein Bild. Einen Scan wählen.</translation>
    </message>
    <message>
        <source>this JSON is not an AngioPose case (its format is not &quot;angiopose-case&quot;). Choose an .angiopose file.</source>
        <translation>dieses JSON ist kein AngioPose-Fall (sein format ist nicht &quot;angiopose-case&quot;). Eine .angiopose-Datei wählen.</translation>
    </message>
    <message>
        <source>this is %1, not a 2-D centreline. Choose a CSV table or a PNG mask.</source>
        <translation>das ist %1, keine 2-D-Mittellinie. Eine CSV-Tabelle oder PNG-Maske wählen.</translation>
    </message>
    <message>
        <source>this is %1, not a case. Choose an .angiopose file.</source>
        <translation>das ist %1, kein Fall. Eine .angiopose-Datei wählen.</translation>
    </message>
    <message>
        <source>this is %1, not a centreline. %2</source>
        <translation>das ist %1, keine Mittellinie. %2</translation>
    </message>
    <message>
        <source>this is %1, not a surface. Choose a .vtp, .vtk, .stl, .ply or .obj file.</source>
        <translation>das ist %1, keine Oberfläche. Eine .vtp-, .vtk-, .stl-, .ply- oder .obj-Datei wählen.</translation>
    </message>
    <message>
        <source>this is %1, not a volume. Choose a DICOM folder, NIfTI, NRRD or MetaImage (.mha, .mhd).</source>
        <translation>das ist %1, kein Volumen. Einen DICOM-Ordner, NIfTI, NRRD oder MetaImage (.mha, .mhd) wählen.</translation>
    </message>
    <message>
        <source>this is %1, not an angiogram. Choose a DICOM XA run, a PNG, TIFF or JPEG image.</source>
        <translation>das ist %1, kein Angiogramm. Eine DICOM-XA-Serie, ein PNG-, TIFF- oder JPEG-Bild wählen.</translation>
    </message>
    <message>
        <source>this is a Git LFS pointer, not the file itself. Run `git lfs pull` where it came from.</source>
        <translation>das ist ein Git-LFS-Verweis, nicht die Datei selbst. Am Ursprungsort `git lfs pull` ausführen.</translation>
    </message>
    <message>
        <source>this is a folder. Choose a file in it.</source>
        <translation>das ist ein Ordner. Eine Datei darin wählen.</translation>
    </message>
    <message>
        <source>this is a gzip archive without a readable DICOM file in it. Unpack it and choose the angiogram itself.</source>
        <translation>das ist ein gzip-Archiv ohne lesbare DICOM-Datei. Auspacken und das Angiogramm selbst wählen.</translation>
    </message>
    <message>
        <source>this is an Analyze 7.5 header, which does not say left from right. Convert it to NIfTI where the orientation is known.</source>
        <translation>das ist ein Analyze-7.5-Header, der links und rechts nicht unterscheidet. Wo die Ausrichtung bekannt ist, in NIfTI umwandeln.</translation>
    </message>
    <message>
        <source>this is an X-ray run, not a volume. Open it as the angiogram.</source>
        <translation>das ist eine Röntgenserie, kein Volumen. Als Angiogramm öffnen.</translation>
    </message>
    <message>
        <source>this is an input of the case and will not be overwritten. Choose another name.</source>
        <translation>das ist eine Eingabe des Falls und wird nicht überschrieben. Anderen Namen wählen.</translation>
    </message>
    <message>
        <source>this is no centreline format AngioPose reads. %1</source>
        <translation>dieses Mittellinienformat liest AngioPose nicht. %1</translation>
    </message>
    <message>
        <source>this is no pose. Choose a .json or an ITK .tfm file.</source>
        <translation>das ist keine Lage. Eine .json- oder ITK-.tfm-Datei wählen.</translation>
    </message>
    <message>
        <source>this is not a DICOM file. Choose a scan.</source>
        <translation>das ist keine DICOM-Datei. Einen Scan wählen.</translation>
    </message>
    <message>
        <source>this is not a mask of two levels. Draw the vessels white on black.</source>
        <translation>das ist keine Maske mit zwei Stufen. Die Gefäße weiß auf schwarz zeichnen.</translation>
    </message>
    <message>
        <source>this is not a place for a file. Give a file name in an existing folder.</source>
        <translation>hier kann keine Datei liegen. Einen Namen in einem vorhandenen Ordner angeben.</translation>
    </message>
    <message>
        <source>this is not a regular file. Choose a file on disk.</source>
        <translation>das ist keine gewöhnliche Datei. Eine Datei auf der Platte wählen.</translation>
    </message>
    <message>
        <source>this is not a text table. Choose a CSV file with a header row.</source>
        <translation>das ist keine Texttabelle. Eine CSV-Datei mit Kopfzeile wählen.</translation>
    </message>
    <message>
        <source>user</source>
        <translation>eingegeben</translation>
    </message>
    <message>
        <source>version: the case was saved by a newer AngioPose. Update the program.</source>
        <translation>version: der Fall stammt von einem neueren AngioPose. Das Programm aktualisieren.</translation>
    </message>
    <message>
        <source>vessel trees are written as .vtp, .csv or .mrk.json. Change the extension.</source>
        <translation>Gefäßbäume werden als .vtp, .csv oder .mrk.json geschrieben. Die Endung ändern.</translation>
    </message>
    <message>
        <source>vessel.%1: the tree has no branch %2; it is left out.</source>
        <translation>vessel.%1: der Baum hat keinen Ast %2; er wird ausgelassen.</translation>
    </message>
    <message>
        <source>vessel: it names no input. Give the file of the vessels as centerline, segmentation, surface or volume.</source>
        <translation>vessel: nennt keine Eingabe. Die Datei der Gefäße als centerline, segmentation, surface oder volume angeben.</translation>
    </message>
    <message>
        <source>volumes are written as .nii, .nii.gz, .nrrd or .mha. Change the extension.</source>
        <translation>Volumen werden als .nii, .nii.gz, .nrrd oder .mha geschrieben. Die Endung ändern.</translation>
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
    <message>
        <source> The intensifier of %1 mm suggests at most %2 mm.</source>
        <translation> Der Bildverstärker mit %1 mm legt höchstens %2 mm nahe.</translation>
    </message>
    <message>
        <source> · not trustworthy</source>
        <translation> · nicht vertrauenswürdig</translation>
    </message>
    <message>
        <source>%1 and elsewhere</source>
        <translation>%1 und anderswo</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2. Check its permissions.</source>
        <translation>%1 lässt sich nicht lesen: %2. Die Rechte prüfen.</translation>
    </message>
    <message>
        <source>%1 does not exist. Check the name, or whether its drive is mounted.</source>
        <translation>%1 gibt es nicht. Namen prüfen, oder ob das Laufwerk eingehängt ist.</translation>
    </message>
    <message>
        <source>%1 files of the series are damaged at their end.</source>
        <translation>%1 Dateien der Serie sind am Ende beschädigt.</translation>
    </message>
    <message>
        <source>%1 files of the series are there twice.</source>
        <translation>%1 Dateien der Serie sind doppelt vorhanden.</translation>
    </message>
    <message>
        <source>%1 holds no image. Choose the X-ray angiography run.</source>
        <translation>%1 enthält kein Bild. Die Röntgenangiographie-Serie wählen.</translation>
    </message>
    <message>
        <source>%1 is a case. Open it alone, without other files.</source>
        <translation>%1 ist ein Fall. Allein öffnen, ohne andere Dateien.</translation>
    </message>
    <message>
        <source>%1 is a second %2. Open one %3 at a time.</source>
        <translation>%1 ist das zweite seiner Art (%2). Nur eines auf einmal öffnen (%3).</translation>
    </message>
    <message>
        <source>%1 is damaged before its pixels: %2. Copy or export it again.</source>
        <translation>%1 ist vor den Pixeln beschädigt: %2. Neu kopieren oder exportieren.</translation>
    </message>
    <message>
        <source>%1 is empty. Copy the file again from where it came from.</source>
        <translation>%1 ist leer. Die Datei vom Ursprungsort neu kopieren.</translation>
    </message>
    <message>
        <source>%1 is missing or not positive. Enter it in the geometry of the case (the image header does not tell).</source>
        <translation>%1 fehlt oder ist nicht positiv. In der Geometrie des Falls eintragen (der Bildheader nennt ihn nicht).</translation>
    </message>
    <message>
        <source>%1 is not a file that AngioPose opens. Open a case (.angiopose), a centreline (VTP, VTK, CSV, SWC), a CT scan (DICOM folder, NIfTI, NRRD, MetaImage), a surface (STL, PLY, OBJ) or an angiogram (DICOM, PNG, TIFF).</source>
        <translation>%1 kann AngioPose nicht öffnen. Einen Fall (.angiopose), eine Mittellinie (VTP, VTK, CSV, SWC), ein CT (DICOM-Ordner, NIfTI, NRRD, MetaImage), eine Oberfläche (STL, PLY, OBJ) oder ein Angiogramm (DICOM, PNG, TIFF) öffnen.</translation>
    </message>
    <message>
        <source>%1 mm/px at the vessels</source>
        <translation>%1 mm/px an den Gefäßen</translation>
    </message>
    <message>
        <source>%1 mm/px detector (%2)</source>
        <translation>%1 mm/px Detektor (%2)</translation>
    </message>
    <message>
        <source>%1 occurs twice in the vessel tree. Branch ids must be unique.</source>
        <translation>%1 kommt im Gefäßbaum doppelt vor. Ast-Nummern müssen einmalig sein.</translation>
    </message>
    <message>
        <source>%1 of %2 slices lie where another one does; the first recorded of each is used.</source>
        <translation>%1 von %2 Schichten liegen auf einer anderen; die jeweils zuerst aufgenommene gilt.</translation>
    </message>
    <message>
        <source>%1 of the vessel tree does not have one radius per point.</source>
        <translation>%1 des Gefäßbaums hat nicht je Punkt einen Radius.</translation>
    </message>
    <message>
        <source>%1 of the vessel tree has a coordinate that is not a number (NaN or infinite).</source>
        <translation>%1 des Gefäßbaums hat eine Koordinate, die keine Zahl ist (NaN oder unendlich).</translation>
    </message>
    <message>
        <source>%1 of the vessel tree has fewer than two points. Remove it or add points.</source>
        <translation>%1 des Gefäßbaums hat weniger als zwei Punkte. Entfernen oder Punkte ergänzen.</translation>
    </message>
    <message>
        <source>%1 of the vessel tree has no length: all its points coincide.</source>
        <translation>%1 des Gefäßbaums hat keine Länge: alle Punkte fallen zusammen.</translation>
    </message>
    <message>
        <source>%1 voxels are not numbers; they are taken as the lowest value.</source>
        <translation>%1 Voxel sind keine Zahlen; sie gelten als kleinster Wert.</translation>
    </message>
    <message>
        <source>%1 · median %2 px%3</source>
        <translation>%1 · Median %2 px%3</translation>
    </message>
    <message>
        <source>%1: %2 Correct it.</source>
        <translation>%1: %2 Berichtigen.</translation>
    </message>
    <message>
        <source>%1: the file has changed since the case was saved. Check that it is the right one.</source>
        <translation>%1: die Datei hat sich seit dem Speichern des Falls geändert. Prüfen, ob es die richtige ist.</translation>
    </message>
    <message>
        <source>%1: the key %2 is missing. Add it.</source>
        <translation>%1: der Schlüssel %2 fehlt. Ergänzen.</translation>
    </message>
    <message>
        <source>%1: the value is not one of those allowed. See the published schema.</source>
        <translation>%1: der Wert ist nicht erlaubt. Siehe das veröffentlichte Schema.</translation>
    </message>
    <message>
        <source>%1: the value is of the wrong kind. See the published schema.</source>
        <translation>%1: der Wert ist von falscher Art. Siehe das veröffentlichte Schema.</translation>
    </message>
    <message>
        <source>%1: this is another DICOM image than the one the case was made for.</source>
        <translation>%1: das ist ein anderes DICOM-Bild als das des Falls.</translation>
    </message>
    <message>
        <source>(0018,1149) field of view %1 mm / %2 px</source>
        <translation>(0018,1149) Bildfeld %1 mm / %2 px</translation>
    </message>
    <message>
        <source>(0028,0030) Pixel Spacing (%1) times SID/SOD</source>
        <translation>(0028,0030) Pixel Spacing (%1) mal SID/SOD</translation>
    </message>
    <message>
        <source>A branch cannot be joined to itself. Choose two branches.</source>
        <translation>Ein Ast lässt sich nicht mit sich selbst verbinden. Zwei Äste wählen.</translation>
    </message>
    <message>
        <source>A joint registration needs at least two views.</source>
        <translation>Eine gemeinsame Registrierung braucht mindestens zwei Projektionen.</translation>
    </message>
    <message>
        <source>A library gave up: </source>
        <translation>Eine Bibliothek gab auf: </translation>
    </message>
    <message>
        <source>A library gave up: %1. Check the inputs.</source>
        <translation>Eine Bibliothek gab auf: %1. Die Eingaben prüfen.</translation>
    </message>
    <message>
        <source>A plain image has no C-arm geometry: enter it in the geometry of the case.</source>
        <translation>Ein einfaches Bild hat keine C-Bogen-Geometrie: in der Geometrie des Falls eintragen.</translation>
    </message>
    <message>
        <source>a DICOM file</source>
        <translation>eine DICOM-Datei</translation>
    </message>
    <message>
        <source>a JPEG image</source>
        <translation>ein JPEG-Bild</translation>
    </message>
    <message>
        <source>a JSON file</source>
        <translation>eine JSON-Datei</translation>
    </message>
    <message>
        <source>a MetaImage header</source>
        <translation>ein MetaImage-Header</translation>
    </message>
    <message>
        <source>a NIfTI header</source>
        <translation>ein NIfTI-Header</translation>
    </message>
    <message>
        <source>a NIfTI volume</source>
        <translation>ein NIfTI-Volumen</translation>
    </message>
    <message>
        <source>a NetCDF (MINC) volume</source>
        <translation>ein NetCDF-Volumen (MINC)</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>ein PDF-Dokument</translation>
    </message>
    <message>
        <source>a PLY surface</source>
        <translation>eine PLY-Oberfläche</translation>
    </message>
    <message>
        <source>a PNG image</source>
        <translation>ein PNG-Bild</translation>
    </message>
    <message>
        <source>a TIFF image</source>
        <translation>ein TIFF-Bild</translation>
    </message>
    <message>
        <source>a TrackVis tractogram</source>
        <translation>ein TrackVis-Traktogramm</translation>
    </message>
    <message>
        <source>a VTK XML file</source>
        <translation>eine VTK-XML-Datei</translation>
    </message>
    <message>
        <source>a case needs a vessel tree and an angiogram. Open both before saving.</source>
        <translation>ein Fall braucht Gefäßbaum und Angiogramm. Vor dem Speichern beide öffnen.</translation>
    </message>
    <message>
        <source>a coordinate is not a number, or beyond a kilometre. Correct or export it again.</source>
        <translation>eine Koordinate ist keine Zahl oder über einen Kilometer groß. Berichtigen oder neu exportieren.</translation>
    </message>
    <message>
        <source>a file name or a text in the case is not UTF-8. Rename the file.</source>
        <translation>ein Dateiname oder Text im Fall ist nicht UTF-8. Die Datei umbenennen.</translation>
    </message>
    <message>
        <source>a glTF scene</source>
        <translation>eine glTF-Szene</translation>
    </message>
    <message>
        <source>a gzip archive</source>
        <translation>ein gzip-Archiv</translation>
    </message>
    <message>
        <source>a legacy VTK file</source>
        <translation>eine alte VTK-Datei</translation>
    </message>
    <message>
        <source>a line refers to a point that does not exist. The file is damaged; export it again.</source>
        <translation>eine Linie verweist auf einen Punkt, den es nicht gibt. Die Datei ist beschädigt; neu exportieren.</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>eine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>a number in it is too large for a double. Correct it.</source>
        <translation>eine Zahl darin ist zu groß für double. Berichtigen.</translation>
    </message>
    <message>
        <source>a pixel is not a finite number. Correct the image before writing it.</source>
        <translation>ein Pixel ist keine endliche Zahl. Das Bild vor dem Schreiben berichtigen.</translation>
    </message>
    <message>
        <source>a pixel is not a finite number. Export the image again.</source>
        <translation>ein Pixel ist keine endliche Zahl. Das Bild neu exportieren.</translation>
    </message>
    <message>
        <source>a triangle refers to a point that does not exist. The file is damaged; export it again.</source>
        <translation>ein Dreieck verweist auf einen Punkt, den es nicht gibt. Die Datei ist beschädigt; neu exportieren.</translation>
    </message>
    <message>
        <source>a value in it has the wrong kind. Compare it with the published schema.</source>
        <translation>ein Wert darin ist von falscher Art. Mit dem veröffentlichten Schema vergleichen.</translation>
    </message>
    <message>
        <source>a zip archive</source>
        <translation>ein zip-Archiv</translation>
    </message>
    <message>
        <source>%1 (%2): filled in between their neighbours. Copy the series again if you can.</source>
        <translation>%1 (%2): zwischen den Nachbarn ergänzt. Die Serie wenn möglich neu kopieren.</translation>
    </message>
    <message>
        <source>%1 loops were opened at their thinnest places: look there for vessels that only touch.</source>
        <translation>%1 Schleifen wurden an den dünnsten Stellen geöffnet: dort nach Gefäßen sehen, die sich nur berühren.</translation>
    </message>
    <message>
        <source>%1 of %2 slices are missing</source>
        <translation>%1 von %2 Schichten fehlen</translation>
    </message>
    <message>
        <source>%1 pieces that do not connect to the traced vessels were left out. Place a seed in each that belongs to the tree.</source>
        <translation>%1 Stücke ohne Verbindung zu den erkannten Gefäßen wurden ausgelassen. In jedes, das zum Baum gehört, einen Startpunkt setzen.</translation>
    </message>
    <message>
        <source>1 loop was opened at the thinnest place: look there for vessels that only touch.</source>
        <translation>1 Schleife wurde an der dünnsten Stelle geöffnet: dort nach Gefäßen sehen, die sich nur berühren.</translation>
    </message>
    <message>
        <source>1 of %1 slices is missing</source>
        <translation>1 von %1 Schichten fehlt</translation>
    </message>
    <message>
        <source>A piece that does not connect to the traced vessels was left out. Place a seed in it if it belongs to the tree.</source>
        <translation>Ein Stück ohne Verbindung zu den erkannten Gefäßen wurde ausgelassen. Einen Startpunkt hineinsetzen, wenn es zum Baum gehört.</translation>
    </message>
    <message>
        <source>Its two placements (qform and sform) differ; the qform, in the scanner&apos;s coordinates, is used.</source>
        <translation>Ihre zwei Lageangaben (qform und sform) weichen ab; die qform in Gerätekoordinaten gilt.</translation>
    </message>
    <message>
        <source>Its two placements (qform and sform) differ; the sform is used.</source>
        <translation>Ihre zwei Lageangaben (qform und sform) weichen ab; die sform gilt.</translation>
    </message>
    <message>
        <source>after slice %1</source>
        <translation>nach Schicht %1</translation>
    </message>
    <message>
        <source>it declares %1&quot;, which cannot be. The file is damaged; export it again.</source>
        <translation>nennt %1&quot;, was nicht sein kann. Die Datei ist beschädigt; neu exportieren.</translation>
    </message>
    <message>
        <source>it holds %1 volumes (%2). Choose one by its series id; `info` lists them.</source>
        <translation>enthält %1 Volumen (%2). Eines über seine Serien-ID wählen; `info` zeigt sie.</translation>
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
</context>
<context>
    <name>ui::AngiogramAnnotations</name>
    <message>
        <source>%1 mm at vessel</source>
        <translation>%1 mm am Gefäß</translation>
    </message>
</context>
<context>
    <name>ui::AngiogramView</name>
    <message>
        <source>Angiogram with the projected vessel tree</source>
        <translation>Angiogramm mit projiziertem Gefäßbaum</translation>
    </message>
    <message>
        <source>frame %1 of 0–%2</source>
        <translation>Bild %1 von 0–%2</translation>
    </message>
</context>
<context>
    <name>ui::BottomStrip</name>
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
    <name>ui::BranchDelegate</name>
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
</context>
<context>
    <name>ui::BranchModel</name>
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
</context>
<context>
    <name>ui::BranchPanel</name>
    <message>
        <source>Branches</source>
        <translation>Äste</translation>
    </message>
    <message>
        <source>No vessels yet. Open a centreline: VTP, VTK, CSV or SWC.</source>
        <translation>Noch keine Gefäße. Eine Mittellinie öffnen: VTP, VTK, CSV oder SWC.</translation>
    </message>
    <message>
        <source>A auxiliary · X exclude</source>
        <translation>A Hilfsast · X ausschließen</translation>
    </message>
    <message>
        <source>Auxiliary on or off	A</source>
        <translation>Hilfsast an oder aus	A</translation>
    </message>
    <message>
        <source>Exclude or include	X</source>
        <translation>Aus- oder einschließen	X</translation>
    </message>
    <message>
        <source>Only these auxiliary</source>
        <translation>Nur diese als Hilfsäste</translation>
    </message>
    <message>
        <source>No auxiliary branches (use the nodes)</source>
        <translation>Keine Hilfsäste (Knoten verwenden)</translation>
    </message>
</context>
<context>
    <name>ui::ConvergencePlot</name>
    <message>
        <source>Convergence</source>
        <translation>Konvergenz</translation>
    </message>
    <message>
        <source>shown after a run</source>
        <translation>nach einem Lauf zu sehen</translation>
    </message>
</context>
<context>
    <name>ui::ExportDialog</name>
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
        <source>The picture always says “Not for clinical use” and carries inputs, method and pose in its text fields.</source>
        <translation>Das Bild trägt immer „Not for clinical use“ und in seinen Textfeldern Eingaben, Methode und Lage.</translation>
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
        <source>%1 × %2 px</source>
        <translation>%1 × %2 px</translation>
    </message>
</context>
<context>
    <name>ui::FrameBars</name>
    <message>
        <source>Frames by opacification</source>
        <translation>Bilder nach Kontrastfüllung</translation>
    </message>
    <message>
        <source>Frame %1, the fullest</source>
        <translation>Bild %1, das vollste</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>Bild %1</translation>
    </message>
</context>
<context>
    <name>ui::GeometryPanel</name>
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
        <source>Pixel pitch on the detector</source>
        <translation>Pixelabstand auf dem Detektor</translation>
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
        <translation>SID 1000 mm, SOD 750 mm, Pixel 0.3 mm, Winkel 0°: nur für das, was fehlt.</translation>
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
</context>
<context>
    <name>ui::GoodFit</name>
    <message>
        <source>Good: everything lies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Good: one branch unfilled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Good: vessels have moved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bad: shifted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bad: turned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bad: wrong view angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lines run in the middle of their vessels, blue all along, into the side branches too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Amber only where this frame shows no contrast; every filled vessel is blue.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Small differences to both sides: beating and breathing. No rigid pose does better.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All lines miss to the same side. Register again, or nudge with the arrows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fits in the middle and misses more and more outwards: turned in the image plane.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The trunk fits, side branches point elsewhere: LAO/RAO or CRA/CAU are off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What a good fit looks like</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated vessels. Blue lies on a vessel, amber 2 mm off or more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished">Schließen</translation>
    </message>
    <message>
        <source>drawing …</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::HeaderBar</name>
    <message>
        <source>Not for clinical use</source>
        <translation>Nicht für den klinischen Einsatz</translation>
    </message>
    <message>
        <source>AngioPose is a research program, not a medical device.</source>
        <translation>AngioPose ist ein Forschungsprogramm, kein Medizinprodukt.</translation>
    </message>
</context>
<context>
    <name>ui::HelpPage</name>
    <message>
        <source>Close</source>
        <translation type="unfinished">Schließen</translation>
    </message>
</context>
<context>
    <name>ui::HistogramPlot</name>
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
    <name>ui::KeySheet</name>
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
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset all keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter or double-click on a line takes a new key for it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This key is fixed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press the new key for “%1”. Esc keeps the old one, Delete leaves none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The old key stays.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is needed elsewhere. Press another key.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” belongs to “%2”. Press it again to take it from there, or press another key.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No key any more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The key is “%1” now.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::MessageDialog</name>
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
    <name>ui::NudgeTool</name>
    <message>
        <source>Nudge: drag shifts, ring rolls, Ctrl is fine, Esc takes back</source>
        <translation>Justieren: Ziehen schiebt, Ring dreht, Strg fein, Esc nimmt zurück</translation>
    </message>
</context>
<context>
    <name>ui::PoseAxis</name>
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
    <name>ui::PosePanel</name>
    <message>
        <source>Pose</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Back to start pose</source>
        <translation>Zurück zur Startlage</translation>
    </message>
    <message>
        <source>Backspace. Undo brings the pose back.</source>
        <translation>Rücktaste. Rückgängig bringt die Lage zurück.</translation>
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
        <source>Lock against nudging, dragging and typing. Register still finds all six and says so.</source>
        <translation>Sperrt gegen Justieren, Ziehen und Tippen. Registrieren bestimmt weiter alle sechs und sagt das.</translation>
    </message>
    <message>
        <source>nudging · arrows · N ends</source>
        <translation>justieren · Pfeile · N beendet</translation>
    </message>
    <message>
        <source>nudge N · fine Ctrl · coarse Shift</source>
        <translation>justieren N · fein Strg · grob Umschalt</translation>
    </message>
</context>
<context>
    <name>ui::RegistrationPanel</name>
    <message>
        <source>Registration</source>
        <translation>Registrierung</translation>
    </message>
    <message>
        <source>Method and options</source>
        <translation>Methode und Optionen</translation>
    </message>
    <message>
        <source>Register  R</source>
        <translation>Registrieren  R</translation>
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
        <source>aux: 1 branch</source>
        <translation>Hilfs: 1 Ast</translation>
    </message>
    <message>
        <source>aux: %1 branches</source>
        <translation>Hilfs: %1 Äste</translation>
    </message>
    <message>
        <source>aux: nodes</source>
        <translation>Hilfs: Knoten</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>The lock holds for your hand only: Register moves all six.</source>
        <translation>Die Sperre gilt nur für die Hand: Registrieren bewegt alle sechs.</translation>
    </message>
    <message>
        <source>The %1 locks hold for your hand only: Register moves all six.</source>
        <translation>Die %1 Sperren gelten nur für die Hand: Registrieren bewegt alle sechs.</translation>
    </message>
    <message>
        <source>method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>Finds the pose that lays the vessels onto the angiogram (R).</source>
        <translation>Findet die Lage, die die Gefäße auf das Angiogramm legt (R).</translation>
    </message>
    <message>
        <source>Registering …</source>
        <translation>Registriert …</translation>
    </message>
</context>
<context>
    <name>ui::ResultPanel</name>
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
        <source>Half of the vessel points lie nearer than this.</source>
        <translation>Die Hälfte der Gefäßpunkte liegt näher.</translation>
    </message>
    <message>
        <source>95 %, mm</source>
        <translation>95 %, mm</translation>
    </message>
    <message>
        <source>95 of 100 vessel points lie nearer than this.</source>
        <translation>95 von 100 Gefäßpunkten liegen näher.</translation>
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
        <source>mm, all points</source>
        <translation>mm, alle Punkte</translation>
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
        <source>median distance, px</source>
        <translation>mittlerer Abstand, px</translation>
    </message>
    <message>
        <source>median %1 → %2 px, steps: %3</source>
        <translation>Median %1 → %2 px, Schritte: %3</translation>
    </message>
</context>
<context>
    <name>ui::ResultSentences</name>
    <message>
        <source>In plane ±%1 mm</source>
        <translation>In der Bildebene ±%1 mm</translation>
    </message>
    <message>
        <source>Rotation ±%1°</source>
        <translation>Drehung ±%1°</translation>
    </message>
    <message>
        <source>rotation ±%1°</source>
        <translation>Drehung ±%1°</translation>
    </message>
    <message>
        <source>%1 of %2 branches agree within %3 mm.</source>
        <translation>%1 von %2 Ästen stimmen auf %3 mm überein.</translation>
    </message>
    <message>
        <source>Depth ±%1 mm: one view cannot tell it.</source>
        <translation>Tiefe ±%1 mm: eine Projektion allein verrät sie nicht.</translation>
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
        <source>Look closely: this fit is not trustworthy.</source>
        <translation>Genau ansehen: diese Einpassung ist nicht vertrauenswürdig.</translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation>Ast %1</translation>
    </message>
</context>
<context>
    <name>ui::Section</name>
    <message>
        <source>Fold %1</source>
        <translation>%1 ein- oder ausklappen</translation>
    </message>
</context>
<context>
    <name>ui::SeriesChooser</name>
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
    <name>ui::StepBar</name>
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
    <name>ui::StepButton</name>
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
    <name>ui::Tour</name>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::TreeView</name>
    <message>
        <source>3-D view of vessel tree, X-ray source and detector</source>
        <translation>3-D-Ansicht von Gefäßbaum, Röntgenfokus und Detektor</translation>
    </message>
</context>
<context>
    <name>ui::VtkView</name>
    <message>
        <source>The 3-D view needs OpenGL 3.2, which this display does not offer. Everything else works. Try LIBGL_ALWAYS_SOFTWARE=1, or install libgl1-mesa-dri.</source>
        <translation>Die 3-D-Ansicht braucht OpenGL 3.2, das diese Anzeige nicht bietet. Alles andere geht. LIBGL_ALWAYS_SOFTWARE=1 versuchen oder libgl1-mesa-dri installieren.</translation>
    </message>
</context>
<context>
    <name>ui::WelcomePage</name>
    <message>
        <source>Lay a vessel tree onto its angiogram</source>
        <translation>Einen Gefäßbaum auf sein Angiogramm legen</translation>
    </message>
    <message>
        <source>Drop a case here, or a centreline together with an angiogram.</source>
        <translation>Hier einen Fall ablegen, oder eine Mittellinie mit einem Angiogramm.</translation>
    </message>
    <message>
        <source>Centrelines: VTP, VTK, CSV, SWC.  Angiograms: DICOM XA, PNG, TIFF.</source>
        <translation>Mittellinien: VTP, VTK, CSV, SWC.  Angiogramme: DICOM XA, PNG, TIFF.</translation>
    </message>
    <message>
        <source>Open …  Ctrl+O</source>
        <translation>Öffnen …  Strg+O</translation>
    </message>
    <message>
        <source>Open the sample case</source>
        <translation>Beispielfall öffnen</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (fehlt)</translation>
    </message>
</context>
<context>
    <name>ui::WindowActions</name>
    <message>
        <source>Open …</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Open DICOM folder …</source>
        <translation>DICOM-Ordner öffnen …</translation>
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
        <source>Vessels: centreline, outline, tube</source>
        <translation>Gefäße: Mittellinie, Umriss, Röhre</translation>
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
        <source>Reset 3-D view</source>
        <translation>3-D-Ansicht zurücksetzen</translation>
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
        <source>← → ↑ ↓</source>
        <translation>← → ↑ ↓</translation>
    </message>
    <message>
        <source>move by 1 mm (Shift 10 mm, Ctrl 0.1 mm)</source>
        <translation>schieben um 1 mm (Umschalt 10 mm, Strg 0.1 mm)</translation>
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
        <source>Open recent</source>
        <translation>Zuletzt geöffnet</translation>
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
        <source>In the whole window</source>
        <translation>Im ganzen Fenster</translation>
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
        <source>Language of the desktop</source>
        <translation>Sprache des Desktops</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>move; on the ring roll; Esc takes it back, then ends the mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save picture of the window …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy picture of the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radiology: left drag windows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3D Slicer: left only picks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scroll: left drag runs the frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help on what the mouse points at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Short tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What a good fit looks like</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>menu of what can be done here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left drag, arrows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn</source>
        <translation type="unfinished">Drehung</translation>
    </message>
    <message>
        <source>right drag, wheel, + −</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>double click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>everything in view again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift+left drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+left drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the 3-D view</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
