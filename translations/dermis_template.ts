<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" sourcelanguage="en">
<context>
    <name>Length</name>
    <message>
        <source>%1 cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>&lt;br&gt;&lt;br&gt;Range %1 to %2 %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;br&gt;Multiplies the %1 map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;br&gt;Source: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TimeLeft</name>
    <message>
        <source>about %1 s left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1 min left</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::Autosave</name>
    <message>
        <source>Unsaved work cannot be kept safe: %1. Save the scene elsewhere; the editor goes on trying.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved work is kept safe again.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::CameraPanel</name>
    <message>
        <source>Lens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orthographic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertical angle of view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the picture in scene units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ready-made views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Display</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View transform</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops applied to the picture before the view transform</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Image shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::ColourEditor</name>
    <message>
        <source>Own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On: a value of its own. Off: follows the index of refraction.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from IOR</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear Rec.709 %1, %2, %3
sRGB %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, own value</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::ColourPicker</name>
    <message>
        <source>Colour of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As it was: click to go back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour as it was</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear Rec.709 — what the renderer uses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, linear %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sRGB, 0–255 — what image editors show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, sRGB %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hex, sRGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, sRGB hexadecimal</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::DiffusionPanel</name>
    <message>
        <source>Burley</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussians</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is plotted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share by radius, 2πr·R(r)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile, R(r)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale of the vertical axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This material&apos;s light leaves where it entered: nothing diffuses.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: red %2, green %3, blue %4 mm. </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean free path ℓ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diffuse mean free path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Burley&apos;s d</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1/e length: 63 % within</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 profile of the slot %2, drawn solid. %3One pixel at the focus is %4 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · dashed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>solid: %1%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>r = %1 mm:%2 %3&lt;br&gt;leaves within r:%4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1/mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1/mm²</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::DiffusionPlot</name>
    <message>
        <source>Diffusion profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distance r from where light entered, mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2πr·R(r): share leaving per mm of r, 1/mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R(r): share leaving per area, 1/mm²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pixel %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::Document</name>
    <message>
        <source>Untitled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 › %2 of %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shading model %1 for %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear %1 map of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %1 map of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assign %1 map to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Revert %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Environment %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light %1 › %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View exposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View transform</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open model %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::EnvironmentList</name>
    <message>
        <source>Search environments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words of a name or folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Environments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Built-in light, files of the folders in the preferences, and files used before; an .hdr or .exr can also be dropped on the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop reading environments for their thumbnails</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Reading %n environment(s) for their thumbnails</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dermis::EnvironmentPanel</name>
    <message>
        <source>Choose file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An .hdr or .exr panorama, or a light rig</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Environment light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Environment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About the vertical axis, counter-clockwise seen from above. Shift + right-drag turns it in the viewport.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Irradiance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blurred environment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing (alpha 0)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blur</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Perceptual roughness of the prefiltered environment that is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate environment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Environment exposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Background blur</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Background colour</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::FileActions</name>
    <message>
        <source>Unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” has unsaved changes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save them before going on?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All that can be opened (%1);;Scenes (%2);;Models (%3);;Presets (%4);;Environments (*.hdr *.exr);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 can&apos;t be opened: by its name it is no scene (.dermis), model, preset (.json) or environment (.hdr, .exr, a light rig&apos;s .json).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Models (%1);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose an environment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images and light rigs (%1);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenes (*.dermis)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Presets (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Models</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Presets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Environments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not there any more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear list</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::FolderList</name>
    <message>
        <source>Folders that are searched, and watched for changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: add a folder…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: remove the selected folder from the list</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::GaussiansEditor</name>
    <message>
        <source>Variance mm²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>G</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove this row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sums  %1  %2  %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>variance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>red weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>green weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>blue weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, row %2, %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, remove row %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, add a row</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::GroupBox</name>
    <message>
        <source>%1, group</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::GuideWindow</name>
    <message>
        <source>Guide — Dermis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search the guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pages without these words are hidden; Enter goes to the next place on the page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contents</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pages of the guide and their sections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As they are set now; *Edit › Keyboard shortcuts* changes them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not part of this guide; it is in the program&apos;s source.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>found on %n page(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>dermis::HistoryPanel</name>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a state to go back or forward to it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) after the saved state</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n step(s) before the saved state</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>saved</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::HueStrip</name>
    <message>
        <source>Hue</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::Layouts</name>
    <message>
        <source>Save layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Layouts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None saved yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save layout…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::Legend</name>
    <message>
        <source>m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Legend: %1 from %2 to %3 %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&gt; 1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::LightsPanel</name>
    <message>
        <source>Point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Directional</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the selected light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on or off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Visible lamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Casts shadows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inner angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outer angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sway</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are %1 lights, as many as a scene takes</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::Loading</name>
    <message>
        <source>Preparing the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recovering the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loading %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 mm tall (%3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loading preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reverting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no scene, model, preset or environment by its name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::LogPanel</name>
    <message>
        <source>Messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::MainWindow</name>
    <message>
        <source>Presets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Environment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera &amp;&amp; view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diffusion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Texture maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>History</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1[*] — Dermis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;model…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose &amp;environment…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save scene &amp;as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save preset as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Find parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;vert material to its preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Ready-made views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;tatistics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Next of these</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre&amp;vious of these</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Without subsurface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hold N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add &amp;point light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add &amp;directional light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add &amp;spot light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove selected light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset environment r&amp;otation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate environment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Render</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save a picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Samples while still</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Hide or show all panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Dermis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No OpenGL</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Dermis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;Dermis %1&lt;/b&gt;&lt;br&gt;An editor for physically based skin.&lt;br&gt;&lt;br&gt;%2&lt;br&gt;Qt %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%L1 triangles   ·   %2 tall</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::MaterialPanel</name>
    <message>
        <source>Slot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material slot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shading model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Revert to the preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save preset…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed since the preset was applied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This shading model has no parameters: it mirrors the environment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No parameter of this model matches “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::MessageBar</name>
    <message>
        <source>Close the message</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Greys without a hue, because colour is judged beside them. The system&apos;s is read from its colours when the program starts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interface size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On top of the screen&apos;s own scale; from the next start on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In which the height of a model is shown; materials always count in millimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Millimetres, metres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples while still</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many pictures are averaged while nothing moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show time and samples over the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The line in the lower right corner of the viewport</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep unsaved work</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At most this long after an edit it is on the disk, and is offered again after a crash</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s after an edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cache</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What baked environments, models and thumbnails may take on the disk; what was used longest ago goes first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> MB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preset folders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Environment folders</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::PresetLibrary</name>
    <message>
        <source>built in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::PresetList</name>
    <message>
        <source>Presets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click or Enter puts a preset on the current slot; drag it onto the picture for the slot there</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::PresetsPanel</name>
    <message>
        <source>Search presets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words of a preset&apos;s name or tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows presets with one tag: a shading model, whose it is, or a tag of your own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop drawing thumbnails</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update the preset with the slot&apos;s values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Revert the slot to its preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the selected preset on the current slot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the slot&apos;s material as a new preset…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More for the selected preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No preset matches.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 *</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1:  %2 *</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1:  %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The slot&apos;s values differ from its preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is in the trash</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words, separated by commas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Apply to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply to slo&amp;t</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ta&amp;gs…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move to &amp;trash</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show &amp;folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing thumbnails: %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::ProgramActions</name>
    <message>
        <source>Without subsurface, while it is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;What is this?</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::PropertyRow</name>
    <message>
        <source>Differs from the default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset to default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste value</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::RecoveryDialog</name>
    <message>
        <source>Unsaved work</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The editor was closed before this work was saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each line is what one editor had open when it ended</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1   ·   %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recovering opens it as unsaved work; no file of yours is written over.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deletes the selected work for good</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps it and asks again at the next start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens the selected work</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::SaturationSquare</name>
    <message>
        <source>Saturation and value</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::ScaleBar</name>
    <message>
        <source>%1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale: the bar is %1 long</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::ScreenshotDialog</name>
    <message>
        <source>Save a picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Viewport (%1 × %2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Custom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width in pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height in pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples per pixel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All layers (EXR)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diffuse, specular, normal, occlusion, depth and profile beside the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raw: an EXR is scene-linear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As displayed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures (*.png *.exr *.jpg *.tif)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file&apos;s name ends in .png, .exr, .jpg or .tif</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::Shortcuts</name>
    <message>
        <source>%1 belongs to “%2” already; give that one other keys first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 belongs to “%2” now; reset that one first.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::ShortcutsDialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words of a command, or keys such as Ctrl+S</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search commands or keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a command, then press its new keys below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Menu</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press the new keys of the selected command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The selected command has no keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The keys it came with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every command has the keys it came with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes are kept already</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::TextureRow</name>
    <message>
        <source>8-bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>16-bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>half</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>float</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>grey</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>grey + alpha</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Texture maps › %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 map: choose a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 map: read the file again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 map: clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 map › %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luminance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tiling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Invert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flip green (DirectX)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 map › Invert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 map › Flip green</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop an image here, or choose one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not loaded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read the file again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::TexturesPanel</name>
    <message>
        <source>This shading model reads no maps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the %1 map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images (%1);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maps of “%1”</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::Viewport</name>
    <message>
        <source>Viewport</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preparing the picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no picture: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>without subsurface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shown: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate environment</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>views</name>
    <message>
        <source>Final picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All light together, through the view transform</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diffuse before diffusion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The body&apos;s light as if it left where it entered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diffuse after diffusion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The body&apos;s light after it has spread under the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Specular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light reflected at the surface, and emission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transmission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light that comes through from the far side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Millimetres of material behind the surface, as transmission uses them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shading normal in world space, maps included</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ambient occlusion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The share of the surroundings that reaches the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diffusion profile id</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A colour for each profile; light never crosses between two</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance along the view; white is near</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Energy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The share of a uniform white environment that comes back; above 1 is red</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
