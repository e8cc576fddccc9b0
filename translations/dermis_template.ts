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
    <name>ListKeys</name>
    <message>
        <source>In lists</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
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
    <message>
        <source>&lt;br&gt;Default %1</source>
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
    <name>dermis::BookmarksBox</name>
    <message>
        <source>Camera bookmarks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click looks from there, double-click renames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add bookmark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the camera&apos;s place with the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the selected bookmark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove bookmark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename bookmark</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::CameraMenu</name>
    <message>
        <source>Turn &amp;left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn &amp;right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn &amp;up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn &amp;down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Closer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Farther</source>
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
        <source>Image shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bookmarks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without perspective: what is farther away is no smaller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of what the picture shows, in scene units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops applied to the picture before the view transform; the light stays as it is</source>
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
    <message>
        <source>Paste material on %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit of the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dress %1 as %2</source>
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
    <message>
        <source>Stops by which the environment&apos;s light is brighter, and what of it is seen behind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is seen behind the model: the environment, its irradiance, the environment blurred, one colour, or nothing, which a saved picture keeps as alpha 0. The light is the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The one colour behind the model</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::Exports</name>
    <message>
        <source>Drawing %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1 frames, %2 to %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copied a picture of %1 × %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 follows when the picture before it is done</source>
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
    <message>
        <source>Save light rig</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light rigs (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::FlyKeys</name>
    <message>
        <source>While the right button is held in the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fly to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fly to the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fly up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fly down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fly forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fly back</source>
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
    <name>dermis::HoldKey</name>
    <message>
        <source>While a key is held</source>
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
    <name>dermis::LightGizmos</name>
    <message>
        <source>There is no lamp to move: add one in the Lights panel, or turn the environment with Shift and the right button.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance</source>
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
    <message>
        <source>Duplicate the selected light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F2 or a double click renames a light, Ctrl+D duplicates it, Delete removes it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How it shines: a point to all sides, a directional light from one side everywhere, a spot in a cone, a sphere and a rectangle from all of their surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of the light; its brightness multiplies the intensity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radiant intensity of the light, which falls off with the square of the distance in scene units; of a directional light its irradiance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lamp itself is seen in the picture and in reflections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the model stops this light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the light is, in scene units: +Y is up, +Z the side of the built-in cameras</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The way the light travels; of any length but 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half angle of the cone that is lit wholly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half angle of the cone outside of which nothing is lit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius of the sphere; of other lights, of the lamp that is seen. Larger makes softer shadows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width and height of the rectangle. Larger makes softer shadows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The light moves by itself: around the target, or to and fro</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far it moves, in scene units</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fast it moves; negative, the other way round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name</source>
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
    <message>
        <source>Pasting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assign %1 map to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loading maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No file there has a map&apos;s name, such as head_albedo.png or head_normal.png.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n map(s) matched by name</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n file(s) not used</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Assign %n map(s) to %1</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Reading %1 again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; its last good picture stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>Locate %n map(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Opening the scene of %1</source>
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
        <source>Model &amp;unit…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 triangles   ·   %2 tall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not opened: %1. Of each kind one file is taken, and a scene brings all its own; drop the others by themselves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a &amp;folder of maps…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See without subsurface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hold %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Float or dock the panel in use</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::MatchReport</name>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, channel %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, inverted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, green flipped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the model %1 has no %2 map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no map&apos;s name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>names another slot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another file is better for it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no opacity map of its own; put it in the alpha of the albedo map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the model %1 has no opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not used: %1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::MaterialClipboard</name>
    <message>
        <source>&amp;Copy material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts the whole material on the clipboard, as a preset&apos;s text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Paste group or material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts what was copied on the edited slots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy group “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the clipboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was pasted: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was pasted: this shading model has none of the parameters on the clipboard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste values on %1</source>
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
    <message>
        <source>%1 › %2 of %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag it onto a part in the picture, or onto the box of slots: that part wears the same</source>
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
    <name>dermis::ModelPicker</name>
    <message>
        <source>The model can&apos;t be pointed at: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::ModelUnitBar</name>
    <message>
        <source>m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit of the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One unit of the file is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One unit of the model is 1 %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Millimetres in one unit of the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the question about the model&apos;s unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is %2 mm tall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::ModifiedDot</name>
    <message>
        <source>The chosen slots have different values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Differs from the default; a double-click brings that back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed since the preset was applied; a double-click brings the default back</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::OverlayCanvas</name>
    <message>
        <source>Tools over the picture</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::PickReadout</name>
    <message>
        <source>Radiance %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Display %1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Under the pointer: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::PictureScenes</name>
    <message>
        <source>Reading %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A picture of a scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” remembers the scene that it was made of.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open that scene, or use the picture as an environment?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use as environment</source>
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
    <message>
        <source>Reading presets</source>
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
    <message>
        <source>The preset %1 could not be read; put the file back and revert to it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Compare with this</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare &amp;others with this (left side)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::ProgramActions</name>
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
        <source>Copy value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The chosen slots have different values:
%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset to the default%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the preset%1</source>
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
    <name>dermis::ReferencePanel</name>
    <message>
        <source>Choose photograph…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a reference photograph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A picture to compare with. It is remembered by the editor, not by the scene.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.webp *.bmp);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference photograph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the photograph is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over the picture, beside it, or not at all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Beside the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much of the picture it hides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wipe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The share of the picture, from the left, that it lies over; the line can be dragged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 is as high as the viewport</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In heights of the viewport</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No photograph</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::ReferencePhoto</name>
    <message>
        <source>Loading the reference photograph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 can&apos;t be shown as a reference: %2. Choose a PNG, JPEG or WebP picture.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::ReferenceView</name>
    <message>
        <source>Reference photograph</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::RigBox</name>
    <message>
        <source>Light rig</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light rig › Element</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which of the rig&apos;s lights the fields below are for; a click on its handle chooses it too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a light of the rig</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether this light of the rig shines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About the vertical: 0° is the side of the built-in cameras, 90° the subject&apos;s left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Above the horizon: 90° is overhead, below 0° is under the subject</source>
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
        <source>Across, or the diameter of what is round; in metres, or in degrees as the subject sees it. From 0.001 m or 0.01° upwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upwards; in metres, or in degrees as the subject sees it. From 0.001 m or 0.01° upwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radiance of the brightest place, or what the rig&apos;s file says instead: irradiance, cd/m² or lux; of a sky, a factor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save rig as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light rig › Save as a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the rig as it is now to a .json file of its own; what the program carries stays as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in the light rig</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light on or off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, changed; kept in the scene</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::RigEdit</name>
    <message>
        <source>Lighting</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::RigGizmos</name>
    <message>
        <source>Size in the light rig</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place in the light rig</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brightness in the light rig</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::RigMarks</name>
    <message>
        <source>Softbox</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Glow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dome</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overcast sky</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sky and sun</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ground</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::RowHelp</name>
    <message>
        <source>Range %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From %1 upwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear Rec.709, each channel from 0 upwards</source>
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
    <name>dermis::SaveDialog</name>
    <message>
        <source>File exists</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is there already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replacing it loses what is in it now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace</source>
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
    <message>
        <source>What is drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turntable: numbered frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sheet of views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures of a turntable, evenly spread round the target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the clipboard instead of a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Balls and chart, as in the viewport</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The grey and chrome balls and the colour chart, where the View menu has them on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View transform</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An EXR through Raw is scene-linear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A sheet&apos;s file name ends in .png</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::SearchField</name>
    <message>
        <source>%1: empty the field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; Esc empties it</source>
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
    <name>dermis::SlotChooser</name>
    <message>
        <source>Material slot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit several slots together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit several slots together: a change goes to all that are ticked, as one undo step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slots edited together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All slots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the one shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n slot(s) together</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Together…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The part of the model whose material is shown; a preset dragged here goes to it, or to another slot of the list that comes up</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::SlotDropList</name>
    <message>
        <source>Drop on a slot</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::SnapshotPictures</name>
    <message>
        <source>Drawing a snapshot</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::Snapshots</name>
    <message>
        <source>Snapshot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::SnapshotsPanel</name>
    <message>
        <source>Take</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the look as it is now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the selected snapshot beside the picture, with the same camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the selected look back; one step of undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forget the selected snapshot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snapshots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click compares, F2 renames</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::TaskRunner</name>
    <message>
        <source>%1 did not succeed: %2.</source>
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
    <message>
        <source>Locate…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 map: locate the missing file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Say where the file is now; other missing maps that lie beside it come along</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read 1 − value: for gloss maps as roughness, and inverted masks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For normal maps with −Y, as DirectX tools write them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, its last picture stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file can&apos;t be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show in the file manager</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UDIM, %1 tile, %2 × %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UDIM, %1 tiles, %2 × %3 each</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the file&apos;s numbers are read: automatic goes by the map and the kind of file, linear is Rec.709, raw changes nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which channel of the file holds the value, as in packed maps; luminance weighs red, green and blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How often the map repeats across; a map that repeats otherwise upwards keeps its shape. 0.001 to 1000</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the map&apos;s value is multiplied with; of a normal map, how steep it is. −1000 to 1000</source>
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
        <source>Drop a folder anywhere here: its files find their maps by name, such as head_albedo.png</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maps matched by name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide what was matched</source>
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
        <source>Where is %1 now?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same name (%1);;Images (%2);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maps of “%1”. Drop a folder to match files by name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a folder of maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a folder: its files find their maps by name, such as head_albedo.png</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>dermis::ViewTools</name>
    <message>
        <source>Reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snapshots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera &amp;bookmarks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera bac&amp;k</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera f&amp;orward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ta&amp;ke a snapshot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Co&amp;mpare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grey and chrome ba&amp;lls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour c&amp;hart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R&amp;uler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pixel &amp;readout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P&amp;in what is under the pointer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cle&amp;ar pins</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Set of lamps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light &amp;handles in the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add bookmark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loading preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the selected &amp;snapshot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With a &amp;preset on the current slot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;End comparison</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the key light with the pointer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mov&amp;e the camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ruler from or to the middle of the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The model is not in the middle of the picture: turn or move the camera until what is to be measured is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split further &amp;left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split further &amp;right</source>
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
    <message>
        <source>The graphics driver was reset and the picture is made anew; the scene has lost nothing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The graphics driver was reset. If the picture doesn&apos;t come back, save the scene and start Dermis again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 fps   %2 ms   %3/%4</source>
        <comment>pictures a second, time of one, samples of how many</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lamps</name>
    <message>
        <source>Key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rim</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left rim</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right rim</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Behind the ear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Three-point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A warm key, a cool fill, a rim from behind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rembrandt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A high key from the side that leaves a triangle of light on the far cheek</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Butterfly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A high key from the front, a weak fill from below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One key from the side: half a face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rim pair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two strips from behind, one cool and one warm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Through the ear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A small lamp behind an ear, to judge transmission by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set of lamps</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>start</name>
    <message>
        <source>OpenGL can&apos;t be used on this display; install a graphics driver, or use a command such as &quot;dermis render&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>tables</name>
    <message>
        <source>Albedo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the light entering the surface that leaves it again, per channel; metals use it as F0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metallic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0 is a dielectric; 1 is a metal that reflects with the albedo and has no diffuse light.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>IOR</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Specular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Index of refraction of the surface; F0 = ((n − 1)/(n + 1))². Editing it makes F0 follow it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fresnel F0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reflectance at normal incidence. Null follows the IOR; any value wins over it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Perceptual roughness a; the width of the microfacet distribution is alpha = a².</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lobe scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roughness of the first and second specular lobe as multiples of the roughness, each clamped to 0.02..1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lobe mix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the second lobe: (1 − m)·lobe 0 + m·lobe 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Multiplies what the specular lobes reflect; in `thesis` it is the published specular value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cavity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much of the specular reflection survives in pores and creases; multiplies the cavity map.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Subsurface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much of the diffuse light spreads below the surface; the rest leaves where it entered (Lambert).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Multiplies the diffusion radius per channel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Multiplies every length of the diffusion profile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diffusion length per channel; what it measures is said by the radius reading.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the radius is: 1/σ_tr, the reduced mean free path 1/σ_t′, or Burley&apos;s d itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diffuse mean free path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean free path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Burley d</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Family of the diffusion profile: Burley&apos;s normalised diffusion or a sum of Gaussians.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Burley</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussians</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Albedo mix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share m of the albedo applied before diffusion (albedo^m), the rest after it; 0 keeps texture detail sharp.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Boundary colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tint of light that would have come from beyond the boundary of this material.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows of variance (mm²) and red, green, blue weights of the sum of Gaussians; up to eight.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transmission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much of the light on the far side shows through thin parts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Multiplies the transmitted light.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where thickness is read: a map, the mesh by ray casting, or the light&apos;s shadow map.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness where the map is 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness max</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness where the map is 1; the thickness everywhere where there is no map.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the point is moved inwards along its normal before it looks up the thickness.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal strength</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Multiplies the slope of the normal map.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Detail strength</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Multiplies the slope of the tiling detail normal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Detail tiling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How often the detail normal repeats over the UV square.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height along the normal between the map&apos;s 0 and 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displacement midlevel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value of the displacement map that leaves the surface where it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much the occlusion map darkens image light.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SSS colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Subsurface (thesis)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of the published wrap term.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SSS scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale in 1 − exp(−thickness · scale · N·L).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness in 1 − exp(−thickness · scale · N·L); it has no unit as published.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Geometry term</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Microfacet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Geometry factor G: none, Smith with k = α²/2 and α = 0.3, or Cook-Torrance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smith</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cook torrance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sclera colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Eye</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Albedo outside the iris; with an albedo map it tints the map there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Iris colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Albedo of the iris; with an albedo map it tints the map there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Iris radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius of the visible iris, on an eyeball 24 mm across; a larger eyeball is taken for an enlarged one, and so for all lengths of an eye.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Iris depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance of the iris plane behind the top of the cornea.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cornea IOR</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Index of refraction of the cornea.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cornea roughness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Perceptual roughness of the tear film over the iris; the sclera has the specular one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pupil radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius of the pupil where there is no albedo map; a map has its own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Iris variation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much fibres and collarette vary the iris&apos;s colour where there is no albedo map.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limbus width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width of the dark ring between iris and sclera.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limbus darkness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How dark that ring is: 0 leaves it as it is, 1 is black.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much of what lies behind the lens its own black covers; its reflection is added whole.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed blending</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draws the lens the published way: depth test off, source-alpha blending.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emissive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of the light the surface gives off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emissive strength</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Multiplies the emissive colour into a radiance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alpha</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alpha of the base colour; used by the alpha modes mask and blend.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alpha mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opaque, cut out where alpha is below the cutoff, or blended.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opaque</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alpha cutoff</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alpha below which the mask mode cuts out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double sided</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back faces are drawn, with their normal turned to the viewer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diffusing skin under two specular lobes; what the program is for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thesis (2024)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shader of &quot;Physically Based Skin rendering Using OpenGL&quot; (2024), as published.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reflection (lab)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A mirror of the environment, encoded in the shader as the lab published it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Microfacet (lab)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lab&apos;s microfacet reflection of the environment, encoded in the shader as published.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sclera that scatters, and an iris seen by refraction through the cornea.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A cornea shell: specular only, blended over what lies behind it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metallic-roughness (glTF)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>glTF&apos;s material, so that a downloaded model shows as its author meant.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Detail normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Detail mask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preparing shaders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sending maps to the graphics driver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring thickness and occlusion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Three-quarter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bottom right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bottom left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Studio, three-point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clamshell beauty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A beauty dish above the camera, a reflector below it, soft kickers behind: even skin and clear eyes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rim on dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two tall strips behind the subject, warm and cool, and a dark front: outlines, and light through ears.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Window daylight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A tall window on the left, a dim warm room on the right: the light of painters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overcast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The CIE standard overcast sky over grey ground: light without a direction.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Golden hour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A low sun from the left under a clear sky, over dry grass.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clinic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>White walls and ceiling panels: flat, neutral light in which colours can be judged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Night street</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A warm lamp overhead, a cool shop window, a neon sign behind, and lamps far down the street.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skin tone I</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skin tone II</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skin tone III</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skin tone IV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skin tone V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skin tone VI</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skin, elderly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skin, flushed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skin, freckled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skin, pale and thin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face, aged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face, flushed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face, tone I</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face, tone II</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face, tone III</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face, tone IV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face, tone V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face, tone VI</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jade</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marble</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Milk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wax</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thesis: eye</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thesis: face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lab: mirror sphere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lab: rougher</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lab: very rough</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lab: very rough gold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lab: very rough silver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lab: very specular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lab: very specular gold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thesis: lens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A large warm key from high on the left, a soft cooler fill, a reflector below, rims from behind, a bank overhead; dark walls.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Eye, blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Eye, brown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Eye, dark brown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Eye, green</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Eye, grey</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Eye, hazel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hair, black</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hair, blond</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hair, brown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hair, grey</source>
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
