<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>angiopose::app::AuxiliaryController</name>
    <message>
        <source>No auxiliary branches selected: the method AngioPose weights all branches equally. If auxiliary branches are selected, they determine the pose components that they constrain; the other branches determine the remaining components.</source>
        <translation>未选择辅助分支：AngioPose 方法对所有分支同等加权。若选择了辅助分支，则由其决定所能约束的位姿分量，其余分支决定剩余分量。</translation>
    </message>
    <message>
        <source>%1 In the method AngioPose, these branches determine the pose components that they constrain; the other branches determine the remaining components. The result also reports the fit of all branches. If confidence is low, AngioPose also tries poses found from these branches alone.</source>
        <translation>%1 在 AngioPose 方法中，这些分支决定其所能约束的位姿分量，其余分支决定剩余分量；结果也给出全部分支的拟合。置信度低时，AngioPose 还会尝试仅由这些分支求得的位姿。</translation>
    </message>
    <message>
        <source>Change method to %1</source>
        <translation>改用方法 %1</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>倾斜</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>转动</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>滚转</translation>
    </message>
    <message>
        <source>horizontal</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>vertical</source>
        <translation>垂直</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>No branch lies mostly inside the lasso.</source>
        <translation>没有主体位于套索内的分支。</translation>
    </message>
    <message>
        <source>This tree has no generation data.</source>
        <translation>此血管树没有分级信息。</translation>
    </message>
    <message>
        <source>No branch reaches this radius.</source>
        <translation>没有分支达到此半径。</translation>
    </message>
    <message>
        <source>No auxiliary branches selected: the method uses the %1 nodes of the tree as auxiliary points.</source>
        <translation>未选择辅助分支：该方法以血管树的 %1 个节点作为辅助点。</translation>
    </message>
    <message>
        <source>Auxiliary: %1 (%2 mm, %3 % of the tree).</source>
        <translation>辅助分支：%1（%2 mm，占血管树 %3 %）。</translation>
    </message>
    <message>
        <source>%1 The current method ignores this selection and uses all branches.</source>
        <translation>%1 当前方法不使用此选择，而使用全部分支。</translation>
    </message>
    <message>
        <source>%1 The method option “Auxiliary points” takes precedence.</source>
        <translation>%1 方法选项“辅助点”优先。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::BlindTrialController</name>
    <message>
        <source>A blind trial requires vessels, an angiogram and an initial pose. No registration may be running.</source>
        <translation>盲法试验需要血管、造影图像和初始位姿，且不能有正在进行的配准。</translation>
    </message>
    <message>
        <source>Blind trial</source>
        <translation>盲法试验</translation>
    </message>
    <message>
        <source>%1, blind</source>
        <translation>%1，盲法</translation>
    </message>
    <message>
        <source>Blind trial, seed %1, %2 s, %3 edits</source>
        <translation>盲法试验，种子 %1，%2 s，%3 次编辑</translation>
    </message>
    <message>
        <source>Save blind trial</source>
        <translation>保存盲法试验</translation>
    </message>
</context>
<context>
    <name>angiopose::app::BranchController</name>
    <message>
        <source>Select a branch first: click it in the list or in a view.</source>
        <translation>请先选择一个分支：在列表或视图中单击。</translation>
    </message>
    <message>
        <source>Excluded branches cannot be auxiliary. Include them first (X).</source>
        <translation>已排除的分支不能作为辅助分支。请先恢复（X）。</translation>
    </message>
    <message>
        <source>Choose auxiliary branches</source>
        <translation>选择辅助分支</translation>
    </message>
    <message>
        <source>At least one branch must remain.</source>
        <translation>至少须保留一个分支。</translation>
    </message>
    <message>
        <source>Exclude %1</source>
        <translation>排除 %1</translation>
    </message>
    <message>
        <source>Include %1</source>
        <translation>恢复 %1</translation>
    </message>
    <message>
        <source>No branch is completely visible. Zoom out or pan the image.</source>
        <translation>没有分支完全位于视野内。请缩小或平移图像。</translation>
    </message>
    <message>
        <source>This tree has no radii.</source>
        <translation>此血管树没有半径信息。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::BranchWords</name>
    <message>
        <source>%1 branches</source>
        <translation>%1 个分支</translation>
    </message>
</context>
<context>
    <name>angiopose::app::CaseController</name>
    <message>
        <source>A registration is running. Stop it before editing.</source>
        <translation>配准正在进行。请先停止再编辑。</translation>
    </message>
    <message>
        <source>Could not trace the vessels</source>
        <translation>无法提取血管</translation>
    </message>
    <message>
        <source>Support bundle saved: %1</source>
        <translation>已保存支持包：%1</translation>
    </message>
    <message>
        <source>Could not save the support bundle</source>
        <translation>无法保存支持包</translation>
    </message>
</context>
<context>
    <name>angiopose::app::CaseReport</name>
    <message>
        <source>Registered</source>
        <translation>配准时间</translation>
    </message>
    <message>
        <source>Median distance</source>
        <translation>中位距离</translation>
    </message>
    <message>
        <source>%1 mm (%2 px)</source>
        <translation>%1 mm（%2 px）</translation>
    </message>
    <message>
        <source>Coverage of traced vessels</source>
        <translation>提取血管的覆盖率</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>none: this is the initial pose</source>
        <translation>无：这是初始位姿</translation>
    </message>
    <message>
        <source>Registered in</source>
        <translation>配准帧</translation>
    </message>
    <message>
        <source>frame %1; image and values from frame %2</source>
        <translation>第 %1 帧；图像与数值来自第 %2 帧</translation>
    </message>
    <message>
        <source>pose set manually</source>
        <translation>手动设定的位姿</translation>
    </message>
    <message>
        <source>edited manually</source>
        <translation>手动编辑</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>%1 mm median · %2 mm long</source>
        <translation>中位数 %1 mm · 长 %2 mm</translation>
    </message>
    <message>
        <source>Worst %1 of %2 branches</source>
        <translation>%2 个分支中最差的 %1 个</translation>
    </message>
    <message>
        <source>Branches, worst first</source>
        <translation>分支，最差的在前</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>几何</translation>
    </message>
    <message>
        <source>Pose (patient to camera), mm</source>
        <translation>位姿（患者到相机），mm</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>血管</translation>
    </message>
    <message>
        <source>Angiogram</source>
        <translation>造影</translation>
    </message>
    <message>
        <source>Traced vessels</source>
        <translation>提取的血管</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>Created</source>
        <translation>生成时间</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>Signature</source>
        <translation>签名</translation>
    </message>
    <message>
        <source>Measured in the image</source>
        <translation>图像中的测量</translation>
    </message>
    <message>
        <source>, narrowest point %1 mm (−%2 %)</source>
        <translation>，最窄 %1 mm（−%2 %）</translation>
    </message>
    <message>
        <source>Target points and rings</source>
        <translation>目标点与环</translation>
    </message>
    <message>
        <source>traced from a manually edited lumen mask</source>
        <translation>由手工编辑的管腔掩膜提取</translation>
    </message>
    <message>
        <source>Lumen mask</source>
        <translation>管腔掩膜</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>Before: initial pose</source>
        <translation>之前：初始位姿</translation>
    </message>
    <message>
        <source>After: registered</source>
        <translation>之后：已配准</translation>
    </message>
    <message>
        <source>After: pose set manually</source>
        <translation>之后：手动设定的位姿</translation>
    </message>
    <message>
        <source>Colors: distance to the vessels traced in the image</source>
        <translation>颜色：到图像中所提取血管的距离</translation>
    </message>
    <message>
        <source>farther</source>
        <translation>更远</translation>
    </message>
    <message>
        <source>Reliable</source>
        <translation>可靠</translation>
    </message>
    <message>
        <source>Not reliable</source>
        <translation>不可靠</translation>
    </message>
    <message>
        <source>This pose may be wrong. Do not use it without verification.</source>
        <translation>此位姿可能有误，未经核实请勿使用。</translation>
    </message>
    <message>
        <source>All checks passed. This is not proof: inspect the overlay.</source>
        <translation>所有检查均已通过。这并非证明：请检视叠加图。</translation>
    </message>
    <message>
        <source>95th percentile</source>
        <translation>第 95 百分位数</translation>
    </message>
</context>
<context>
    <name>angiopose::app::CloseController</name>
    <message>
        <source>A registration is running</source>
        <translation>配准正在进行</translation>
    </message>
    <message>
        <source>Stop it and close? Unsaved changes to this case will be lost.</source>
        <translation>停止并关闭？此病例未保存的更改将丢失。</translation>
    </message>
    <message>
        <source>Save before closing?</source>
        <translation>关闭前保存吗？</translation>
    </message>
    <message>
        <source>“%1” has unsaved changes.</source>
        <translation>“%1”有未保存的更改。</translation>
    </message>
    <message>
        <source>Stop, save and close</source>
        <translation>停止、保存并关闭</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>停止并关闭</translation>
    </message>
    <message>
        <source>Keep running</source>
        <translation>继续运行</translation>
    </message>
    <message>
        <source>Save and close</source>
        <translation>保存并关闭</translation>
    </message>
    <message>
        <source>Close without saving</source>
        <translation>不保存直接关闭</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>“%1” has no angiogram yet. Only its vessels can be saved, as centerlines.</source>
        <translation>“%1”尚无造影图像。只能将其血管存为中心线。</translation>
    </message>
    <message>
        <source>Save vessels and close</source>
        <translation>保存血管并关闭</translation>
    </message>
    <message>
        <source>Close without saving?</source>
        <translation>不保存就关闭？</translation>
    </message>
    <message>
        <source>“%1” has no vessels yet, so there is no case to save. Unsaved work will be lost.</source>
        <translation>“%1”尚无血管，因此没有可保存的病例。未保存的工作将丢失。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::CurveController</name>
    <message>
        <source>At least one curve must remain as the registration target.</source>
        <translation>至少须保留一条曲线作为配准目标。</translation>
    </message>
    <message>
        <source>Keep suspect curve</source>
        <translation>保留可疑曲线</translation>
    </message>
    <message>
        <source>The edited curves of frame %1 were replaced. Undo restores them.</source>
        <translation>第 %1 帧编辑过的曲线已被替换。可用“撤销”恢复。</translation>
    </message>
    <message>
        <source>Trace this frame again?</source>
        <translation>重新提取此帧？</translation>
    </message>
    <message>
        <source>Its edited or imported curves will be replaced. Undo restores them.</source>
        <translation>编辑过或导入的曲线将被替换。可用“撤销”恢复。</translation>
    </message>
    <message>
        <source>Trace again</source>
        <translation>重新提取</translation>
    </message>
    <message>
        <source>Keep the curves</source>
        <translation>保留曲线</translation>
    </message>
    <message>
        <source>If only a guidewire is visible, use the method “Guidewire or catheter”, which uses every curve.</source>
        <translation>若只能看到导丝，请使用方法“导丝或导管”，它会使用所有曲线。</translation>
    </message>
    <message>
        <source>Mark curve as device</source>
        <translation>将曲线标为器械</translation>
    </message>
    <message>
        <source>Mark curve as vessel</source>
        <translation>将曲线标为血管</translation>
    </message>
    <message>
        <source>Track device</source>
        <translation>跟踪器械</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ExportController</name>
    <message>
        <source>3D Slicer points (*.fcsv *.mrk.json)</source>
        <translation>3D Slicer 标志点 (*.fcsv *.mrk.json)</translation>
    </message>
    <message>
        <source>Poses with camera (*.txt *.yml *.xml)</source>
        <translation>带相机的位姿 (*.txt *.yml *.xml)</translation>
    </message>
    <message>
        <source>Vector graphics (*.svg)</source>
        <translation>矢量图 (*.svg)</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>PDF 文档 (*.pdf)</translation>
    </message>
    <message>
        <source>There is nothing to export yet. Open a vessel tree and an angiogram first.</source>
        <translation>尚无可导出内容。请先打开血管树和造影图像。</translation>
    </message>
    <message>
        <source>Export overlay</source>
        <translation>导出叠加图</translation>
    </message>
    <message>
        <source>PNG images (*.png)</source>
        <translation>PNG 图像 (*.png)</translation>
    </message>
    <message>
        <source>There is no result for this pose. Register first (R).</source>
        <translation>此位姿没有结果。请先配准（R）。</translation>
    </message>
    <message>
        <source>Export result</source>
        <translation>导出结果</translation>
    </message>
    <message>
        <source>Results (*.json)</source>
        <translation>结果 (*.json)</translation>
    </message>
    <message>
        <source>Export pose</source>
        <translation>导出位姿</translation>
    </message>
    <message>
        <source>Poses (*.json *.tfm *.h5)</source>
        <translation>位姿 (*.json *.tfm *.h5)</translation>
    </message>
    <message>
        <source>No vessels have been traced in this frame yet.</source>
        <translation>此帧尚未提取血管。</translation>
    </message>
    <message>
        <source>Displacement of each point (*.csv)</source>
        <translation>各点位移 (*.csv)</translation>
    </message>
    <message>
        <source>Deformed centerlines (*.vtp)</source>
        <translation>变形中心线 (*.vtp)</translation>
    </message>
    <message>
        <source>Export deformed vessels</source>
        <translation>导出变形血管</translation>
    </message>
    <message>
        <source>There are no deformed vessels for this pose. Register first (R).</source>
        <translation>此位姿没有变形血管。请先配准（R）。</translation>
    </message>
    <message>
        <source>Export traced vessels</source>
        <translation>导出提取的血管</translation>
    </message>
    <message>
        <source>2-D centerlines (*.csv)</source>
        <translation>二维中心线 (*.csv)</translation>
    </message>
    <message>
        <source>There are no vessels yet. Open a centerline, or trace a scan.</source>
        <translation>尚无血管。请打开中心线，或从扫描中提取。</translation>
    </message>
    <message>
        <source>Export vessel tree</source>
        <translation>导出血管树</translation>
    </message>
    <message>
        <source>Centerlines (*.vtp *.csv *.swc *.mrk.json)</source>
        <translation>中心线 (*.vtp *.csv *.swc *.mrk.json)</translation>
    </message>
    <message>
        <source>Export measurements</source>
        <translation>导出测量</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>No target points or rings have been set yet.</source>
        <translation>尚未设置目标点或环。</translation>
    </message>
    <message>
        <source>Export target points</source>
        <translation>导出目标点</translation>
    </message>
    <message>
        <source>Nothing has been measured yet.</source>
        <translation>尚未进行任何测量。</translation>
    </message>
    <message>
        <source>Export lumen mask</source>
        <translation>导出管腔掩膜</translation>
    </message>
    <message>
        <source>Label images (*.nrrd *.nii.gz *.nii *.mha)</source>
        <translation>标签图像 (*.nrrd *.nii.gz *.nii *.mha)</translation>
    </message>
</context>
<context>
    <name>angiopose::app::TrackingController</name>
    <message>
        <source>Tracking the vessels through the run: %1 %</source>
        <translation>正在序列中跟踪血管：%1 %</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>Could not track the vessels</source>
        <translation>无法跟踪血管</translation>
    </message>
    <message>
        <source>Another task is running. Wait for it to finish.</source>
        <translation>另一任务正在运行，请等待其完成。</translation>
    </message>
    <message>
        <source>Open vessels and an angiogram first.</source>
        <translation>请先打开血管和造影图像。</translation>
    </message>
    <message>
        <source>Tracking the vessels through the run…</source>
        <translation>正在序列中跟踪血管…</translation>
    </message>
    <message>
        <source>Track vessels through the run</source>
        <translation>在序列中跟踪血管</translation>
    </message>
    <message>
        <source>The vessels were moved during tracking. Track them again.</source>
        <translation>跟踪期间血管被移动，请重新跟踪。</translation>
    </message>
    <message>
        <source>breathing: period %1 s, %2 mm peak to peak</source>
        <translation>呼吸：周期 %1 s，峰峰值 %2 mm</translation>
    </message>
    <message>
        <source>heartbeat: period %1 s, %2 mm peak to peak</source>
        <translation>心跳：周期 %1 s，峰峰值 %2 mm</translation>
    </message>
    <message>
        <source>Tracked through %1 frames; scroll through the frames or play them</source>
        <translation>已跟踪 %1 帧：可滚动或播放</translation>
    </message>
    <message>
        <source>Tracked through %1 frames; in %2 of them, the vessels are not sufficiently visible</source>
        <translation>已跟踪 %1 帧；其中 %2 帧血管显示不够清楚</translation>
    </message>
    <message>
        <source>Export tracked poses</source>
        <translation>导出跟踪位姿</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
</context>
<context>
    <name>angiopose::app::GeometryController</name>
    <message>
        <source>Change %1</source>
        <translation>更改 %1</translation>
    </message>
    <message>
        <source>Use distances and spacing</source>
        <translation>使用距离和像素间距</translation>
    </message>
</context>
<context>
    <name>angiopose::app::HelpController</name>
    <message>
        <source>Open the sample case</source>
        <translation>打开示例病例</translation>
    </message>
    <message>
        <source>AngioPose %1</source>
        <translation>AngioPose %1</translation>
    </message>
    <message>
        <source>Registers a 3-D vessel tree to a 2-D angiogram without correspondences.

Not for clinical use: AngioPose is research software, not a medical device.

Apache License 2.0. Built on Qt, VTK, ITK, OpenCV, NLopt, Eigen and nanoflann.</source>
        <translation>无需对应点即可将三维血管树配准到二维造影图像。

不得用于临床：AngioPose 是研究软件，不是医疗器械。

Apache 许可证 2.0。基于 Qt、VTK、ITK、OpenCV、NLopt、Eigen 和 nanoflann。</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Start here</source>
        <translation>从这里开始</translation>
    </message>
    <message>
        <source>Drop a case, or vessels and an angiogram, anywhere in the window. “Open the sample case” requires no data of your own.</source>
        <translation>将病例，或血管与造影图像，拖到窗口任意处。“打开示例病例”无需自己的数据。</translation>
    </message>
    <message>
        <source>Steps to a result</source>
        <translation>得到结果的步骤</translation>
    </message>
    <message>
        <source>Each step shows a check mark when complete; otherwise, its tooltip lists what is missing. The steps can be clicked in any order.</source>
        <translation>每个已完成的步骤显示对勾；否则其提示会列出缺少的内容。可按任意顺序单击各步骤。</translation>
    </message>
    <message>
        <source>The vessel tree</source>
        <translation>血管树</translation>
    </message>
    <message>
        <source>Lists the branches with their lengths and residuals. Press A to add a branch to the auxiliary branches, X to exclude it.</source>
        <translation>列出各分支的长度和残差。按 A 将分支加入辅助分支，按 X 将其排除。</translation>
    </message>
    <message>
        <source>The angiogram</source>
        <translation>造影图像</translation>
    </message>
    <message>
        <source>The projected tree is overlaid on the angiogram and colored by its distance to the traced vessels. Wheel: scroll through the frames. N: move the tree with the arrow keys or the mouse. H: hide the tree.</source>
        <translation>投影血管树叠加在造影图像上，按到所提取血管的距离着色。滚轮：换帧。N：用方向键或鼠标移动血管树。H：隐藏血管树。</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>配准</translation>
    </message>
    <message>
        <source>R finds the pose. Stop keeps the best pose found so far; Ctrl+Z restores the pose from before the registration.</source>
        <translation>R 求位姿。停止会保留目前最佳位姿，Ctrl+Z 恢复配准前的位姿。</translation>
    </message>
    <message>
        <source>Is the result reliable?</source>
        <translation>结果可靠吗？</translation>
    </message>
    <message>
        <source>Shows distances in mm and notes on what cannot be determined from this image. Shift+F1 shows examples of good and bad fits.</source>
        <translation>显示以毫米表示的距离，并说明此图像无法确定之处。Shift+F1 显示好与坏的配准示例。</translation>
    </message>
    <message>
        <source>Getting help</source>
        <translation>获取帮助</translation>
    </message>
    <message>
        <source>F1 explains the item under the mouse pointer; ? lists all shortcuts and lets you change them. This tour is also available from the Help menu.</source>
        <translation>F1 解释鼠标所指内容，? 列出并修改全部快捷键。本导览在“帮助”菜单中。</translation>
    </message>
    <message>
        <source>The angiogram is rendered with VTK (OpenGL).</source>
        <translation>造影图像由 VTK（OpenGL）渲染。</translation>
    </message>
    <message>
        <source>The angiogram is rendered on the CPU.</source>
        <translation>造影图像由 CPU 渲染。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::HistoryController</name>
    <message>
        <source>Undo: %1</source>
        <translation>撤销：%1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>重做：%1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PatientBar</name>
    <message>
        <source>Patient</source>
        <translation>患者</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PatientController</name>
    <message>
        <source>The inputs belong to different patients</source>
        <translation>输入来自不同患者</translation>
    </message>
    <message>
        <source>The inputs do not match</source>
        <translation>输入不匹配</translation>
    </message>
    <message>
        <source>Identity hidden (Shift+P shows it)</source>
        <translation>身份已隐藏（Shift+P 显示）</translation>
    </message>
    <message>
        <source>scan</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>view %1</source>
        <translation>视图 %1</translation>
    </message>
    <message>
        <source>angiogram</source>
        <translation>造影</translation>
    </message>
    <message>
        <source>ID %1</source>
        <translation>ID %1</translation>
    </message>
    <message>
        <source>born %1</source>
        <translation>出生 %1</translation>
    </message>
</context>
<context>
    <name>angiopose::app::InputKind</name>
    <message>
        <source>Poses and points (*.json *.tfm *.mat *.h5 *.txt *.yml *.yaml *.xml *.fcsv)</source>
        <translation>位姿和点 (*.json *.tfm *.mat *.h5 *.txt *.yml *.yaml *.xml *.fcsv)</translation>
    </message>
    <message>
        <source>Cases, vessels and angiograms (%1)</source>
        <translation>病例、血管和造影图像 (%1)</translation>
    </message>
    <message>
        <source>Cases (*.angiopose)</source>
        <translation>病例 (*.angiopose)</translation>
    </message>
    <message>
        <source>Centerlines (*.vtp *.vtk *.csv *.swc *.json)</source>
        <translation>中心线 (*.vtp *.vtk *.csv *.swc *.json)</translation>
    </message>
    <message>
        <source>Scans and surfaces (%1 *.dcm)</source>
        <translation>CT 数据和表面 (%1 *.dcm)</translation>
    </message>
    <message>
        <source>Angiograms (*.dcm *.png *.tif *.tiff *.jpg *.jpeg)</source>
        <translation>造影图像 (*.dcm *.png *.tif *.tiff *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
</context>
<context>
    <name>angiopose::app::EvaluationController</name>
    <message>
        <source>nothing to assess yet</source>
        <translation>尚无可评估内容</translation>
    </message>
</context>
<context>
    <name>angiopose::app::LandmarkController</name>
    <message>
        <source>bifurcation %1</source>
        <translation>分叉 %1</translation>
    </message>
    <message>
        <source>end of %1</source>
        <translation>%1 的末端</translation>
    </message>
    <message>
        <source>on %1</source>
        <translation>在 %1 上</translation>
    </message>
    <message>
        <source>point outside the vessels</source>
        <translation>血管外的点</translation>
    </message>
    <message>
        <source>Fewer than four pairs: pose components that the pairs do not determine remain unchanged.</source>
        <translation>少于四对：点对未能确定的位姿分量保持不变。</translation>
    </message>
    <message>
        <source>Residual of the pairs: %1 px. With click errors of 2 px: rotation ±%2°, depth ±%3 mm.</source>
        <translation>点对残差：%1 px。点击误差为 2 px 时：旋转 ±%2°，深度 ±%3 mm。</translation>
    </message>
    <message>
        <source>Move landmark %1</source>
        <translation>移动标志点 %1</translation>
    </message>
    <message>
        <source>Open the vessels first.</source>
        <translation>请先打开血管。</translation>
    </message>
    <message>
        <source>Add landmark</source>
        <translation>添加标志点</translation>
    </message>
    <message>
        <source>Remove landmark</source>
        <translation>移除标志点</translation>
    </message>
    <message>
        <source>Register from landmarks</source>
        <translation>按标志点配准</translation>
    </message>
</context>
<context>
    <name>angiopose::app::LinkedCrosshair</name>
    <message>
        <source>The crosshair is linked across side-by-side views (%1).</source>
        <translation>十字线联动并排显示的视图（%1）。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::OverlayStyleController</name>
    <message>
        <source>Depth cueing</source>
        <translation>深度提示</translation>
    </message>
    <message>
        <source>Depth cueing off</source>
        <translation>深度提示已关闭</translation>
    </message>
    <message>
        <source>Vessels as centerlines</source>
        <translation>以中心线显示血管</translation>
    </message>
    <message>
        <source>Vessels as outlines</source>
        <translation>以轮廓显示血管</translation>
    </message>
    <message>
        <source>Vessels as tubes</source>
        <translation>以管状显示血管</translation>
    </message>
    <message>
        <source>Swipe: the overlay ends at the mouse pointer</source>
        <translation>卷帘：叠加图止于鼠标指针处</translation>
    </message>
    <message>
        <source>Lens: hides the overlay around the mouse pointer</source>
        <translation>透镜：隐藏鼠标指针周围的叠加图</translation>
    </message>
    <message>
        <source>Swipe and lens off</source>
        <translation>卷帘和透镜已关闭</translation>
    </message>
    <message>
        <source>Overlay opacity %1 %</source>
        <translation>叠加图不透明度 %1 %</translation>
    </message>
    <message>
        <source>No residuals yet</source>
        <translation>尚无残差</translation>
    </message>
    <message>
        <source>Worst %1 of %2: median %3 mm · W next · 1 fit view</source>
        <translation>最差第 %1 / %2：中位数 %3 mm · W 下一个 · 1 适合窗口</translation>
    </message>
    <message>
        <source>View from the source: only the display is mirrored</source>
        <translation>从射线源方向看：仅显示镜像</translation>
    </message>
    <message>
        <source>View from the detector</source>
        <translation>从探测器方向看</translation>
    </message>
    <message>
        <source>Vessels as DRR of the scan</source>
        <translation>血管显示为扫描的 DRR</translation>
    </message>
    <message>
        <source>Vessels as DRR of the tube model</source>
        <translation>血管显示为管状模型的 DRR</translation>
    </message>
</context>
<context>
    <name>angiopose::app::Notifications</name>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
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
        <translation>显影随时间变化</translation>
    </message>
</context>
<context>
    <name>angiopose::app::OpenController</name>
    <message>
        <source>The pose belongs to an image of %1 × %2 px, but the angiogram is %3 × %4 px. Open the pose that belongs to this angiogram.</source>
        <translation>该位姿属于 %1 × %2 px 的图像，而造影图像为 %3 × %4 px。请打开属于此造影图像的位姿。</translation>
    </message>
    <message>
        <source>The camera stored with the pose is mirrored relative to the angiogram: one is viewed from the detector, the other from the source. Mirror the image, or change the viewing side in the geometry panel.</source>
        <translation>随位姿存储的相机与造影图像互为镜像：一个从探测器看，另一个从射线源看。请镜像图像，或在几何面板中更改观察侧。</translation>
    </message>
    <message>
        <source>The pose was registered with different vessels.</source>
        <translation>该位姿是用其他血管配准的。</translation>
    </message>
    <message>
        <source>The pose was registered to a different angiogram.</source>
        <translation>该位姿是在另一幅造影图像中配准的。</translation>
    </message>
    <message>
        <source>A pose can be opened only in a case. Open vessels and an angiogram first, then the pose.</source>
        <translation>位姿只能在病例中打开。请先打开血管和造影图像，再打开位姿。</translation>
    </message>
    <message>
        <source>At this pose, the vessels lie behind the X-ray source. The pose may belong to another patient, or it may map camera coordinates to patient coordinates; in the latter case, invert the pose.</source>
        <translation>按此位姿，血管位于射线源之后。该位姿可能属于其他患者，或是从相机坐标到患者坐标的变换：若是后者，请将其求逆。</translation>
    </message>
    <message>
        <source>The camera stored with the pose is now in use. You can revert this in the geometry panel.</source>
        <translation>现在使用随位姿存储的相机。可在几何面板中撤回。</translation>
    </message>
    <message>
        <source>Open pose %1</source>
        <translation>打开位姿 %1</translation>
    </message>
    <message>
        <source>Points can be opened only in a case with vessels. Open the vessels first, then the points.</source>
        <translation>只有病例中有血管时才能打开点。请先打开血管，再打开点。</translation>
    </message>
    <message>
        <source>Target points added: %1.</source>
        <translation>已添加目标点：%1 个。</translation>
    </message>
    <message>
        <source>None of the target points is near the vessels. The points may belong to another patient or use a different coordinate system.</source>
        <translation>没有一个目标点靠近血管。这些点可能属于其他患者，或使用其他坐标系。</translation>
    </message>
    <message>
        <source>Open points %1</source>
        <translation>打开点 %1</translation>
    </message>
    <message>
        <source>Pose from %1 applied.</source>
        <translation>已应用 %1 的位姿。</translation>
    </message>
    <message>
        <source>A registration is running. Stop it before opening another file.</source>
        <translation>配准正在进行。打开其他文件前请先停止。</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>正在读取 %1…</translation>
    </message>
    <message>
        <source>A registration was started in the meantime. Open the file again after the registration has finished.</source>
        <translation>期间已开始配准。请在其结束后重新打开文件。</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>打开 %1</translation>
    </message>
    <message>
        <source>A blind trial is in progress. End it before opening another file.</source>
        <translation>盲法试验进行中。打开其他文件前请先结束试验。</translation>
    </message>
    <message>
        <source>A blind trial was started in the meantime. Open the file again after the trial has finished.</source>
        <translation>期间已开始盲法试验。请在其结束后重新打开文件。</translation>
    </message>
    <message>
        <source>Add view %1</source>
        <translation>添加视图 %1</translation>
    </message>
    <message>
        <source>View added. To show it, click its entry in the strip above the image.</source>
        <translation>已添加视图：在图像上方的条中单击即可显示。</translation>
    </message>
    <message>
        <source>Additional runs can be added as views only if the case has vessels. Open the vessels first, then the runs again.</source>
        <translation>只有病例有血管时，才能将其余序列添加为视图。请先打开血管，再重新打开这些序列。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::OpenDialogs</name>
    <message>
        <source>Which camera should be used?</source>
        <translation>使用哪个相机？</translation>
    </message>
    <message>
        <source>“%1” contains a camera that differs from that of the case. The pose is valid only with the camera that was used for its registration.</source>
        <translation>“%1”所含相机与病例的相机不同。位姿只有配合配准时所用的相机才有效。</translation>
    </message>
    <message>
        <source>Use pose and camera</source>
        <translation>使用位姿和相机</translation>
    </message>
    <message>
        <source>Use pose only</source>
        <translation>仅使用位姿</translation>
    </message>
    <message>
        <source>Different patient?</source>
        <translation>患者不同？</translation>
    </message>
    <message>
        <source>If you open “%1” anyway, every image and report of the case will carry a warning, and no registration in this case will be rated reliable. If only the pseudonyms differ, open it as the same patient.</source>
        <translation>如果仍然打开“%1”，该病例的每张图像和每份报告都会带有警告，且此病例中的任何配准都不会评为可靠。如果只是假名不同，请作为同一患者打开。</translation>
    </message>
    <message>
        <source>Do not open</source>
        <translation>不打开</translation>
    </message>
    <message>
        <source>Open anyway</source>
        <translation>仍然打开</translation>
    </message>
    <message>
        <source>Open as same patient</source>
        <translation>作为同一患者打开</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Open DICOM folder/CD</source>
        <translation>打开 DICOM 文件夹/光盘</translation>
    </message>
    <message>
        <source>Add a view</source>
        <translation>添加视图</translation>
    </message>
    <message>
        <source>Another view of the same vessels?</source>
        <translation>同一血管的另一视图？</translation>
    </message>
    <message>
        <source>The case already has an angiogram. Add “%1” as a second view for joint registration, or replace the current angiogram?</source>
        <translation>病例已有造影图像。将“%1”添加为第二视图进行联合配准，还是替换当前造影图像？</translation>
    </message>
    <message>
        <source>Add as a view</source>
        <translation>添加为视图</translation>
    </message>
    <message>
        <source>Replace the angiogram</source>
        <translation>替换造影图像</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Show the scan with the current vessels?</source>
        <translation>将扫描与当前血管一起显示？</translation>
    </message>
    <message>
        <source>The vessels of the case come from a file. Show the slices of “%1” with these vessels, or replace them with vessels traced in this scan?</source>
        <translation>病例的血管来自文件。将“%1”的层面与这些血管一起显示，还是用在此扫描中提取的血管替换它们？</translation>
    </message>
    <message>
        <source>Show with the vessels</source>
        <translation>与血管一起显示</translation>
    </message>
    <message>
        <source>Trace this scan</source>
        <translation>提取此扫描</translation>
    </message>
    <message>
        <source>Creating the sample case…</source>
        <translation>正在生成示例病例…</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>Could not create the sample case</source>
        <translation>无法生成示例病例</translation>
    </message>
    <message>
        <source>Save the open case first?</source>
        <translation>先保存当前病例吗？</translation>
    </message>
    <message>
        <source>“%1” has unsaved changes.</source>
        <translation>“%1”有未保存的更改。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>放弃更改</translation>
    </message>
    <message>
        <source>Keep current case</source>
        <translation>保留当前病例</translation>
    </message>
    <message>
        <source>%1 mm across</source>
        <translation>宽 %1 mm</translation>
    </message>
    <message>
        <source>%1 m across</source>
        <translation>宽 %1 m</translation>
    </message>
    <message>
        <source>“%1” does not specify the unit of its coordinates. If the unit were millimeters, the vessels would be unusually small or large. Your choice is stored in the case.</source>
        <translation>“%1”未说明坐标的单位。若为毫米，则血管异常小或大。您的选择会保存在病例中。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Which unit does the file use?</source>
        <translation>文件使用哪种单位？</translation>
    </message>
    <message>
        <source>Discard unsaved work?</source>
        <translation>放弃未保存的工作？</translation>
    </message>
    <message>
        <source>“%1” has no vessels yet, so there is no case to save. Unsaved work will be lost.</source>
        <translation>“%1”尚无血管，因此没有可保存的病例。未保存的工作将丢失。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::OpenNotes</name>
    <message>
        <source>The vessels lie outside this scan: it may be a different scan or use a different coordinate system.</source>
        <translation>血管在此扫描之外：可能是其他扫描，或使用不同的坐标系。</translation>
    </message>
    <message>
        <source>No vessels have been traced in the scan yet. Place a seed or set the threshold in the slices (%1), then trace.</source>
        <translation>扫描中尚未提取血管：请在层面（%1）中放置种子点或设置阈值，然后提取。</translation>
    </message>
    <message>
        <source>File unit: %1 mm, as selected.</source>
        <translation>文件单位：%1 mm（按您的选择）。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ScreenshotController</name>
    <message>
        <source>Screenshot copied to the clipboard</source>
        <translation>截图已复制到剪贴板</translation>
    </message>
    <message>
        <source>Save screenshot</source>
        <translation>保存截图</translation>
    </message>
    <message>
        <source>PNG images (*.png)</source>
        <translation>PNG 图像 (*.png)</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>Could not save the image</source>
        <translation>无法保存图像</translation>
    </message>
    <message>
        <source>Could not write %1. Choose another folder.</source>
        <translation>无法写入 %1。请选择其他文件夹。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PivotController</name>
    <message>
        <source>Set rotation center</source>
        <translation>设置旋转中心</translation>
    </message>
    <message>
        <source>The vessels now rotate about the selected point.</source>
        <translation>血管现在围绕所选点旋转。</translation>
    </message>
    <message>
        <source>Reset rotation center</source>
        <translation>重置旋转中心</translation>
    </message>
    <message>
        <source>The vessels rotate about their centroid again.</source>
        <translation>血管恢复围绕其质心旋转。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PlotExport</name>
    <message>
        <source>Copy image</source>
        <translation>复制图像</translation>
    </message>
    <message>
        <source>Export as SVG…</source>
        <translation>导出为 SVG…</translation>
    </message>
    <message>
        <source>Export as PNG…</source>
        <translation>导出为 PNG…</translation>
    </message>
    <message>
        <source>Export plot</source>
        <translation>导出图表</translation>
    </message>
    <message>
        <source>Vector graphics (*.svg)</source>
        <translation>矢量图 (*.svg)</translation>
    </message>
    <message>
        <source>PNG images (*.png)</source>
        <translation>PNG 图像 (*.png)</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PoseController</name>
    <message>
        <source>Move vessels</source>
        <translation>移动血管</translation>
    </message>
    <message>
        <source>There is no pose to nudge yet. Open vessels and an angiogram and complete the geometry first.</source>
        <translation>尚无可微调的位姿。请先打开血管和造影图像，并补全几何参数。</translation>
    </message>
    <message>
        <source>“%1” is locked.</source>
        <translation>“%1”已锁定。</translation>
    </message>
    <message>
        <source>Reset to initial pose</source>
        <translation>重置为初始位姿</translation>
    </message>
    <message>
        <source>A registration is running. Stop it first.</source>
        <translation>配准正在进行。请先停止。</translation>
    </message>
    <message>
        <source>Change locks</source>
        <translation>更改锁定</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PoseGestures</name>
    <message>
        <source>Nudge mode: arrow keys move, dragging moves or rolls, N exits</source>
        <translation>微调模式：方向键平移，拖动平移或滚转，N 退出</translation>
    </message>
    <message>
        <source>Nudge mode off</source>
        <translation>微调模式已关闭</translation>
    </message>
    <message>
        <source>Copied: patient-to-camera matrix, 4 × 4, mm</source>
        <translation>已复制：患者到相机的 4 × 4 矩阵（mm）</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PoseTableController</name>
    <message>
        <source>There are no poses to compare yet.</source>
        <translation>尚无可比较的位姿。</translation>
    </message>
    <message>
        <source>Current pose</source>
        <translation>当前位姿</translation>
    </message>
    <message>
        <source>The vessels of this frame are still being traced.</source>
        <translation>此帧血管仍在提取。</translation>
    </message>
    <message>
        <source>Starting…</source>
        <translation>正在开始…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Run several methods</source>
        <translation>运行多种方法</translation>
    </message>
    <message>
        <source>1 method done</source>
        <translation>1 种方法已完成</translation>
    </message>
    <message>
        <source>%1 methods done</source>
        <translation>%1 种方法已完成</translation>
    </message>
    <message>
        <source>Stopped. %1.</source>
        <translation>已停止。%1。</translation>
    </message>
    <message>
        <source>Export comparison</source>
        <translation>导出比较</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PoseTools</name>
    <message>
        <source>Logged: %1</source>
        <translation>已记录：%1</translation>
    </message>
    <message>
        <source>Blind trial</source>
        <translation>盲法试验</translation>
    </message>
</context>
<context>
    <name>angiopose::app::RegistrationController</name>
    <message>
        <source>Open a vessel centerline first.</source>
        <translation>请先打开血管中心线。</translation>
    </message>
    <message>
        <source>Open an angiogram first.</source>
        <translation>请先打开造影图像。</translation>
    </message>
    <message>
        <source>Register (%1)</source>
        <translation>配准（%1）</translation>
    </message>
    <message>
        <source>In a blind trial, align the vessels manually.</source>
        <translation>盲法试验须手动配准。</translation>
    </message>
    <message>
        <source>Register all views</source>
        <translation>配准所有视图</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ReplayController</name>
    <message>
        <source>Alternative path %1 of %2, probability %3 % · %4 to accept</source>
        <translation>备选路径 %1 / %2，概率 %3 % · 按 %4 采用</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>倾斜</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>转动</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>滚转</translation>
    </message>
    <message>
        <source>horizontal</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>vertical</source>
        <translation>垂直</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>There is no registration to replay. Register first (R).</source>
        <translation>没有可回放的配准。请先配准（R）。</translation>
    </message>
    <message>
        <source>Replay ended</source>
        <translation>回放结束</translation>
    </message>
    <message>
        <source>Replay: step %1 of %2, %3 px</source>
        <translation>回放：第 %1 / %2 步，%3 px</translation>
    </message>
    <message>
        <source>The uncertainty of this pose is not known yet.</source>
        <translation>此位姿的不确定度尚未知。</translation>
    </message>
    <message>
        <source>The registration found no other solution.</source>
        <translation>配准未找到其他解。</translation>
    </message>
    <message>
        <source>There is no registration yet. Register first (R).</source>
        <translation>尚未配准。请先配准（R）。</translation>
    </message>
    <message>
        <source>Registered solution</source>
        <translation>配准所得解</translation>
    </message>
    <message>
        <source>Show the other solutions first (J).</source>
        <translation>请先显示其他解（J）。</translation>
    </message>
    <message>
        <source>Accept solution %1</source>
        <translation>采用解 %1</translation>
    </message>
    <message>
        <source>Alternative solution %1 of %2, score %3 · %4 to accept</source>
        <translation>其他解 %1 / %2，评分 %3 · 按 %4 采用</translation>
    </message>
    <message>
        <source>Because of image noise alone, poses within ±%1 mm (2 σ, mainly %2) cannot be distinguished</source>
        <translation>仅因图像噪声，±%1 mm 内的位姿（2 σ，主要为%2）无法区分</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ReviewController</name>
    <message>
        <source>Choose another frame</source>
        <translation>选择另一帧</translation>
    </message>
    <message>
        <source>Before: initial pose</source>
        <translation>之前：初始位姿</translation>
    </message>
    <message>
        <source>There are no deformed vessels for this pose</source>
        <translation>此位姿没有变形血管</translation>
    </message>
    <message>
        <source>Colors: distance to the traced vessels</source>
        <translation>颜色：到提取血管的距离</translation>
    </message>
    <message>
        <source>Colors: displacement of the deformed vessels</source>
        <translation>颜色：变形血管的位移</translation>
    </message>
    <message>
        <source>Vessels: rigid pose</source>
        <translation>血管：刚性位姿</translation>
    </message>
    <message>
        <source>Vessels: deformed</source>
        <translation>血管：变形后</translation>
    </message>
    <message>
        <source>After: current pose</source>
        <translation>之后：当前位姿</translation>
    </message>
</context>
<context>
    <name>angiopose::app::RunController</name>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>Change option “%1”</source>
        <translation>更改选项“%1”</translation>
    </message>
    <message>
        <source>Tracing the vessels of this frame…</source>
        <translation>正在提取此帧的血管…</translation>
    </message>
    <message>
        <source>Could not start the registration</source>
        <translation>无法开始配准</translation>
    </message>
    <message>
        <source>Registering: %1 · %2 % · %3 px</source>
        <translation>配准中：%1 · %2 % · %3 px</translation>
    </message>
    <message>
        <source>Stopped, NOT RELIABLE: the best pose so far is kept; Undo restores the previous pose</source>
        <translation>已停止，不可靠：保留目前最佳位姿，可撤销</translation>
    </message>
    <message>
        <source>Registered: median %1 mm</source>
        <translation>配准完成：中位数 %1 mm</translation>
    </message>
    <message>
        <source>NOT RELIABLE · median %1 mm over %2 % of the tree</source>
        <translation>不可靠 · 中位数 %1 mm（血管树的 %2 %）</translation>
    </message>
</context>
<context>
    <name>angiopose::app::SaveController</name>
    <message>
        <source>%1 (not saved)</source>
        <translation>%1（未保存）</translation>
    </message>
    <message>
        <source>Save case</source>
        <translation>保存病例</translation>
    </message>
    <message>
        <source>Cases (*.angiopose)</source>
        <translation>病例 (*.angiopose)</translation>
    </message>
    <message>
        <source>All changes saved</source>
        <translation>所有更改已保存</translation>
    </message>
    <message>
        <source>Autosaved %1 s ago</source>
        <translation>%1 秒前自动保存</translation>
    </message>
    <message>
        <source>Autosaved %1 min ago</source>
        <translation>%1 分钟前自动保存</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>有未保存的更改</translation>
    </message>
    <message>
        <source>Not saved yet</source>
        <translation>尚未保存</translation>
    </message>
    <message>
        <source>A blind trial is in progress. End it before saving.</source>
        <translation>盲法试验进行中。保存前请先结束试验。</translation>
    </message>
    <message>
        <source>Untitled case</source>
        <translation>未命名病例</translation>
    </message>
    <message>
        <source>No angiogram yet</source>
        <translation>尚无造影图像</translation>
    </message>
    <message>
        <source>A case requires vessels and an angiogram. Without an angiogram, only the vessels can be saved, as centerlines. To create a case later, open these vessels together with an angiogram.</source>
        <translation>病例需要血管和造影图像。没有造影图像时，只能将血管存为中心线；以后与造影图像一起打开即可建立病例。</translation>
    </message>
    <message>
        <source>Save vessels…</source>
        <translation>保存血管…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Vessels without an angiogram</source>
        <translation>无造影图像的血管</translation>
    </message>
    <message>
        <source>Vessels saved as centerlines</source>
        <translation>血管已存为中心线</translation>
    </message>
    <message>
        <source>Changed elsewhere</source>
        <translation>已在别处更改</translation>
    </message>
    <message>
        <source>“%1” was saved by another window or program after it was opened here. Overwriting discards the changes saved there; reloading discards the changes made here.</source>
        <translation>“%1”在此处打开后，已被另一个窗口或程序保存。覆盖会丢弃在那里保存的更改；重新载入会丢弃在此处所做的更改。</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>另存为…</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>覆盖</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>重新载入</translation>
    </message>
    <message>
        <source>Not autosaved</source>
        <translation>未自动保存</translation>
    </message>
</context>
<context>
    <name>angiopose::app::SeriesRows</name>
    <message>
        <source>Series %1</source>
        <translation>序列 %1</translation>
    </message>
</context>
<context>
    <name>angiopose::app::SessionController</name>
    <message>
        <source>Case bundle saved: %1</source>
        <translation>已保存病例包：%1</translation>
    </message>
    <message>
        <source>Could not save the case bundle</source>
        <translation>无法保存病例包</translation>
    </message>
    <message>
        <source>DICOM objects written: %1</source>
        <translation>已写出 DICOM 对象：%1</translation>
    </message>
    <message>
        <source>Could not start another AngioPose process. Start AngioPose from the system menu.</source>
        <translation>无法启动另一个 AngioPose 进程。请从系统菜单启动。</translation>
    </message>
    <message>
        <source>Could not open another window</source>
        <translation>无法打开另一个窗口</translation>
    </message>
    <message>
        <source>Not for clinical use</source>
        <translation>不得用于临床</translation>
    </message>
    <message>
        <source>AngioPose is research software, not a medical device: do not use it for diagnosis, treatment or navigation. Results can be wrong; a single projection cannot fully determine depth.</source>
        <translation>AngioPose 是研究软件，不是医疗器械：不得用于诊断、治疗或导航。结果可能有误；单一投影无法完全确定深度。</translation>
    </message>
    <message>
        <source>I understand</source>
        <translation>我已了解</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>Opened</source>
        <translation>已打开</translation>
    </message>
    <message>
        <source>Could not open the file</source>
        <translation>无法打开文件</translation>
    </message>
    <message>
        <source>Could not open the files</source>
        <translation>无法打开这些文件</translation>
    </message>
    <message>
        <source>Could not save</source>
        <translation>无法保存</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>正在保存…</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>正在写入…</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>Could not export</source>
        <translation>无法导出</translation>
    </message>
    <message>
        <source>Autosave failed; AngioPose retries every minute. %1</source>
        <translation>自动保存失败；AngioPose 每分钟重试一次。%1</translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>已停止；未写入任何内容。</translation>
    </message>
    <message>
        <source>Some files were skipped</source>
        <translation>部分文件已跳过</translation>
    </message>
    <message>
        <source>Could not de-identify the files</source>
        <translation>无法对文件去标识</translation>
    </message>
    <message>
        <source>The audit log is incomplete</source>
        <translation>审计日志不完整</translation>
    </message>
</context>
<context>
    <name>angiopose::app::SideBySideController</name>
    <message>
        <source>Other views are hidden during a blind trial because they would reveal the true pose.</source>
        <translation>盲法试验期间不显示其他视图，因为它们会泄露真实位姿。</translation>
    </message>
    <message>
        <source>Open an angiogram first. Another view can then be shown next to it.</source>
        <translation>请先打开造影图像，然后才能并排显示另一视图。</translation>
    </message>
    <message>
        <source>This case has only one view. Add another angiogram of the same vessels (%1) to show both side by side.</source>
        <translation>此病例只有一个视图。请添加同一血管的另一造影图像（%1）以并排显示。</translation>
    </message>
    <message>
        <source>no geometry</source>
        <translation>无几何参数</translation>
    </message>
    <message>
        <source>linked</source>
        <translation>联动</translation>
    </message>
    <message>
        <source>independent pose</source>
        <translation>独立位姿</translation>
    </message>
    <message>
        <source>The vessels in this view move together with those in the active view.</source>
        <translation>此视图中的血管随当前视图中的血管一同移动。</translation>
    </message>
    <message>
        <source>The views are not registered jointly: moving the vessels in the active view does not move them in this view.</source>
        <translation>各视图未联合配准：在当前视图中移动血管时，此处的血管保持不动。</translation>
    </message>
    <message>
        <source>Click here, or double-click the image, to make this the active view.</source>
        <translation>单击此处或双击图像即可将其设为当前视图。</translation>
    </message>
    <message>
        <source>The image of this view could not be read.</source>
        <translation>无法读取此视图的图像。</translation>
    </message>
    <message>
        <source>Choose another frame</source>
        <translation>选择另一帧</translation>
    </message>
</context>
<context>
    <name>angiopose::app::SnapshotController</name>
    <message>
        <source>Pose %1</source>
        <translation>位姿 %1</translation>
    </message>
    <message>
        <source>There is no pose to save yet.</source>
        <translation>尚无可保存的位姿。</translation>
    </message>
    <message>
        <source>Save snapshot %1</source>
        <translation>保存快照 %1</translation>
    </message>
    <message>
        <source>Saved as “%1” · Y to compare</source>
        <translation>已保存为“%1” · Y 比较</translation>
    </message>
    <message>
        <source>“%1”: median %2 mm · Esc to return</source>
        <translation>“%1”：中位数 %2 mm · Esc 返回</translation>
    </message>
    <message>
        <source>“%1” · Esc to return</source>
        <translation>“%1” · Esc 返回</translation>
    </message>
    <message>
        <source>There is nothing to compare with yet: press K to save a snapshot; each registration (R) also adds one.</source>
        <translation>尚无可比较的内容：按 K 保存快照，每次配准（R）也会添加一个。</translation>
    </message>
    <message>
        <source>A: current pose</source>
        <translation>A：当前位姿</translation>
    </message>
    <message>
        <source>Restore %1</source>
        <translation>恢复 %1</translation>
    </message>
    <message>
        <source>Edit snapshot</source>
        <translation>编辑快照</translation>
    </message>
    <message>
        <source>Delete snapshot</source>
        <translation>删除快照</translation>
    </message>
    <message>
        <source>Delete %1 snapshots</source>
        <translation>删除 %1 个快照</translation>
    </message>
</context>
<context>
    <name>angiopose::app::SolutionController</name>
    <message>
        <source>%1 %: %2</source>
        <translation>%1 %：%2</translation>
    </message>
    <message>
        <source>%1 Press Enter to accept it.</source>
        <translation>%1按回车采用。</translation>
    </message>
    <message>
        <source>Branches %1: probability %2 %; %3 % of the guidewire follows these branches, at a distance of %4 mm from their centerlines.</source>
        <translation>分支 %1：概率 %2 %；%3 % 的导丝沿其走行，偏离中心线 %4 mm。</translation>
    </message>
    <message>
        <source>result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Registered solution</source>
        <translation>配准所得解</translation>
    </message>
    <message>
        <source>%1 mm, %2°</source>
        <translation>%1 mm，%2°</translation>
    </message>
    <message>
        <source>Alternative solution %1, score %2: differs from the registered solution by %3 mm in plane, %4 mm in depth and %5° in rotation. Press Enter to accept it.</source>
        <translation>其他解 %1，评分 %2：与配准所得解相差平面内 %3 mm、深度 %4 mm、旋转 %5°。按回车采用。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::InitialPoseController</name>
    <message>
        <source>Initial pose from angles</source>
        <translation>由角度得初始位姿</translation>
    </message>
    <message>
        <source>Initial pose from the angles, with the isocenter placed in the vessels</source>
        <translation>由角度得初始位姿，等中心在血管内</translation>
    </message>
    <message>
        <source>Open vessels and an angiogram and complete the geometry first.</source>
        <translation>请先打开血管和造影图像，并补全几何参数。</translation>
    </message>
    <message>
        <source>Manual initial pose</source>
        <translation>手动初始位姿</translation>
    </message>
    <message>
        <source>The current pose is now the initial pose</source>
        <translation>当前位姿已设为初始位姿</translation>
    </message>
</context>
<context>
    <name>angiopose::app::StepStates</name>
    <message>
        <source>1 branch</source>
        <translation>1 个分支</translation>
    </message>
    <message>
        <source>%1 branches</source>
        <translation>%1 个分支</translation>
    </message>
    <message>
        <source>Open an angiogram: DICOM XA, PNG or TIFF.</source>
        <translation>打开造影图像：DICOM XA、PNG 或 TIFF。</translation>
    </message>
    <message>
        <source>no vessels traced</source>
        <translation>未提取血管</translation>
    </message>
    <message>
        <source>no contrast?</source>
        <translation>无对比剂？</translation>
    </message>
    <message>
        <source>tracing…</source>
        <translation>提取中…</translation>
    </message>
    <message>
        <source>imported centerline</source>
        <translation>导入的中心线</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>第 %1 帧</translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation>不完整</translation>
    </message>
    <message>
        <source>from the case</source>
        <translation>来自病例</translation>
    </message>
    <message>
        <source>inconsistent</source>
        <translation>相互矛盾</translation>
    </message>
    <message>
        <source>partly assumed</source>
        <translation>部分为假定</translation>
    </message>
    <message>
        <source>Some values are assumed. Enter the actual values if you know them.</source>
        <translation>部分数值为假定值。如已知请输入。</translation>
    </message>
    <message>
        <source>pixel spacing entered</source>
        <translation>像素间距为手工输入</translation>
    </message>
    <message>
        <source>pixel spacing derived</source>
        <translation>像素间距为推算</translation>
    </message>
    <message>
        <source>from the header</source>
        <translation>来自文件头</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>from angles</source>
        <translation>由角度得出</translation>
    </message>
    <message>
        <source>running…</source>
        <translation>进行中…</translation>
    </message>
    <message>
        <source>moved manually</source>
        <translation>手动移动</translation>
    </message>
    <message>
        <source>tracked</source>
        <translation>已跟踪</translation>
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
        <translation>不同帧</translation>
    </message>
    <message>
        <source>This pose was registered in frame %1. Press R to register in the displayed frame.</source>
        <translation>该位姿由第 %1 帧配准。按 R 在显示的帧中配准。</translation>
    </message>
    <message>
        <source>%1 mm median</source>
        <translation>中位数 %1 mm</translation>
    </message>
    <message>
        <source>exported</source>
        <translation>已导出</translation>
    </message>
    <message>
        <source>Open a CT angiogram, a segmentation, a surface or a centerline.</source>
        <translation>打开 CT 血管造影、分割、表面或中心线。</translation>
    </message>
    <message>
        <source>%1 components</source>
        <translation>%1 个部分</translation>
    </message>
    <message>
        <source>The vessel tree is not connected. The note below the branch list explains how to join the components of the tree.</source>
        <translation>血管树不连通。分支列表下方说明如何连接各部分。</translation>
    </message>
    <message>
        <source>different patient?</source>
        <translation>患者不同？</translation>
    </message>
    <message>
        <source>frame %1, edited</source>
        <translation>第 %1 帧，已编辑</translation>
    </message>
    <message>
        <source>The header contains no pixel spacing: %1. Enter the pixel spacing, or press Enter in the field to confirm the value.</source>
        <translation>文件头无像素间距：%1。请输入，或在框内按回车确认。</translation>
    </message>
    <message>
        <source>from landmarks</source>
        <translation>来自标志点</translation>
    </message>
    <message>
        <source>not traced</source>
        <translation>未提取</translation>
    </message>
    <message>
        <source>No vessels were traced in the scan. Place a seed or set the threshold in the panel next to the slices.</source>
        <translation>扫描中未提取到血管。请在层面旁放置种子点或设置阈值。</translation>
    </message>
    <message>
        <source>NOT RELIABLE</source>
        <translation>不可靠</translation>
    </message>
    <message>
        <source>%1 mm median over %2 %</source>
        <translation>%1 mm 中位数（%2 %）</translation>
    </message>
</context>
<context>
    <name>angiopose::app::SubtractionController</name>
    <message>
        <source>Subtract mask</source>
        <translation>减去蒙片</translation>
    </message>
    <message>
        <source>Show native frames</source>
        <translation>显示原始帧</translation>
    </message>
    <message>
        <source>Peak-opacification image</source>
        <translation>全序列最小密度投影</translation>
    </message>
    <message>
        <source>Single frames</source>
        <translation>逐帧显示</translation>
    </message>
    <message>
        <source>Choose mask frames</source>
        <translation>选择蒙片帧</translation>
    </message>
    <message>
        <source>A registration is running. Stop it before editing.</source>
        <translation>配准正在进行。请先停止再编辑。</translation>
    </message>
    <message>
        <source>Open an angiogram first.</source>
        <translation>请先打开造影图像。</translation>
    </message>
    <message>
        <source>Pixel shift</source>
        <translation>像素位移</translation>
    </message>
</context>
<context>
    <name>angiopose::app::TitleController</name>
    <message>
        <source>%1 frames</source>
        <translation>%1 帧</translation>
    </message>
    <message>
        <source>1 frame</source>
        <translation>1 帧</translation>
    </message>
    <message>
        <source>Untitled case</source>
        <translation>未命名病例</translation>
    </message>
    <message>
        <source>AngioPose · not for clinical use</source>
        <translation>AngioPose · 不得用于临床</translation>
    </message>
    <message>
        <source>%1 · AngioPose · not for clinical use</source>
        <translation>%1 · AngioPose · 不得用于临床</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>病例</translation>
    </message>
</context>
<context>
    <name>angiopose::app::TracingController</name>
    <message>
        <source>Tracing the vessels of the scan… %1 %</source>
        <translation>正在提取扫描的血管… %1 %</translation>
    </message>
    <message>
        <source>Stopped: the vessels are unchanged</source>
        <translation>已停止：血管未改变</translation>
    </message>
    <message>
        <source>These vessels were not traced from an image. To trace vessels, open a scan, a segmentation or a surface.</source>
        <translation>这些血管并非由图像提取：请打开扫描、分割或表面。</translation>
    </message>
    <message>
        <source>A registration is running. Stop it first.</source>
        <translation>配准正在进行。请先停止。</translation>
    </message>
    <message>
        <source>Tracing the vessels of the scan…</source>
        <translation>正在提取扫描的血管…</translation>
    </message>
    <message>
        <source>Trace vessels</source>
        <translation>提取血管</translation>
    </message>
    <message>
        <source>Traced: 1 branch.</source>
        <translation>已提取：1 个分支。</translation>
    </message>
    <message>
        <source>Traced: %1 branches.</source>
        <translation>已提取：%1 个分支。</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>No label is selected. Select the labels that contain vessels.</source>
        <translation>未选择标签：请选择属于血管的标签。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::TreeActions</name>
    <message>
        <source>Select one branch: click it in the list or in a view.</source>
        <translation>请选择一个分支：在列表或视图中单击。</translation>
    </message>
    <message>
        <source>%1 components, too far apart to join</source>
        <translation>%1 个部分，相距过远，无法连接</translation>
    </message>
    <message>
        <source>Place seed here</source>
        <translation>在此放置种子点</translation>
    </message>
    <message>
        <source>Avoid this point</source>
        <translation>避开此点</translation>
    </message>
    <message>
        <source>%1 components · gap %2 mm: %3 – %4</source>
        <translation>%1 个部分 · 间隙 %2 mm：%3 – %4</translation>
    </message>
    <message>
        <source>Rotate vessels about this point</source>
        <translation>围绕此点旋转血管</translation>
    </message>
</context>
<context>
    <name>angiopose::app::TreeController</name>
    <message>
        <source>Select a branch first: click it in the list or in a view.</source>
        <translation>请先选择一个分支：在列表或视图中单击。</translation>
    </message>
    <message>
        <source>Select one branch: click it in the list or in a view.</source>
        <translation>请选择一个分支：在列表或视图中单击。</translation>
    </message>
    <message>
        <source>At least one branch must remain.</source>
        <translation>至少须保留一个分支。</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>删除 %1</translation>
    </message>
    <message>
        <source>Delete %1 and descendants</source>
        <translation>删除 %1 及其下级分支</translation>
    </message>
    <message>
        <source>First click the position of the cut, in a slice or on the branch in the 3-D view.</source>
        <translation>请先在层面或三维视图的分支上单击切断位置。</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>切断 %1</translation>
    </message>
    <message>
        <source>Select two branches to join (Ctrl+click adds the second).</source>
        <translation>请选择要连接的两个分支（Ctrl+单击追加第二个）。</translation>
    </message>
    <message>
        <source>Join %1 and %2</source>
        <translation>连接 %1 与 %2</translation>
    </message>
    <message>
        <source>Smooth %1</source>
        <translation>平滑 %1</translation>
    </message>
    <message>
        <source>Set root at %1</source>
        <translation>以 %1 为根</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>显示 %1</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>隐藏 %1</translation>
    </message>
    <message>
        <source>Show all branches</source>
        <translation>显示所有分支</translation>
    </message>
    <message>
        <source>No terminal branch is below these limits.</source>
        <translation>没有低于这些限值的末端分支。</translation>
    </message>
    <message>
        <source>Prune 1 branch</source>
        <translation>修剪 1 个分支</translation>
    </message>
    <message>
        <source>Prune %1 branches</source>
        <translation>修剪 %1 个分支</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>重命名 %1</translation>
    </message>
    <message>
        <source>Set generation of %1</source>
        <translation>设置 %1 的级别</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ViewController</name>
    <message>
        <source>Show this view</source>
        <translation>显示此视图</translation>
    </message>
    <message>
        <source>Name this view…</source>
        <translation>为此视图命名…</translation>
    </message>
    <message>
        <source>Name this view</source>
        <translation>为此视图命名</translation>
    </message>
    <message>
        <source>Name of view %1 (leave empty to use its angles)</source>
        <translation>视图 %1 的名称（留空则显示角度）</translation>
    </message>
    <message>
        <source>Rename view</source>
        <translation>重命名视图</translation>
    </message>
    <message>
        <source>Remove this view</source>
        <translation>移除此视图</translation>
    </message>
    <message>
        <source>%1 mm · %2 px</source>
        <translation>%1 mm · %2 px</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>未找到</translation>
    </message>
    <message>
        <source>%1. Click to show this view; Delete removes the active view.</source>
        <translation>%1。单击显示；Delete 移除当前视图。</translation>
    </message>
    <message>
        <source>The image of this view could not be read.</source>
        <translation>无法读取此视图的图像。</translation>
    </message>
    <message>
        <source>Show view %1</source>
        <translation>显示视图 %1</translation>
    </message>
    <message>
        <source>No other view can be shown instead.</source>
        <translation>没有其他视图可替代显示。</translation>
    </message>
    <message>
        <source>Remove view</source>
        <translation>移除视图</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ViewSync</name>
    <message>
        <source>Single frame</source>
        <translation>单帧</translation>
    </message>
    <message>
        <source>initial pose</source>
        <translation>初始位姿</translation>
    </message>
    <message>
        <source>a registration step</source>
        <translation>配准过程中的一步</translation>
    </message>
    <message>
        <source>a pose within image noise</source>
        <translation>图像噪声范围内的位姿</translation>
    </message>
    <message>
        <source>another solution</source>
        <translation>另一个解</translation>
    </message>
    <message>
        <source>a snapshot</source>
        <translation>快照</translation>
    </message>
    <message>
        <source>pose of this frame</source>
        <translation>此帧的位姿</translation>
    </message>
    <message>
        <source>another pose</source>
        <translation>另一位姿</translation>
    </message>
    <message>
        <source>Preview: %1</source>
        <translation>预览：%1</translation>
    </message>
    <message>
        <source>%1 · median of the whole tree %2 mm</source>
        <translation>%1 · 整棵树中位数 %2 mm</translation>
    </message>
    <message>
        <source>Opacification by frame · frame %1 of %2 · peak: %3</source>
        <translation>各帧显影 · 第 %1 帧，共 %2 帧 · 峰值帧：%3</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>Rank of the path by probability: 1 is the most probable path.</source>
        <translation>路径按概率的序号：1 为最可能的路径。</translation>
    </message>
    <message>
        <source>Adds the prior selected above to the attraction term.</source>
        <translation>在吸引项上加入上方所选先验。</translation>
    </message>
    <message>
        <source>Kernel-weighted PnP that alternates between a few auxiliary points and all points (Song, Ghaffari).</source>
        <translation>以核加权 PnP 在少量辅助点与全部点之间交替求解（Song、Ghaffari）。</translation>
    </message>
    <message>
        <source>Alternating search</source>
        <translation>交替搜索</translation>
    </message>
    <message>
        <source>Alternation</source>
        <translation>交替</translation>
    </message>
    <message>
        <source>Annealed particles around the initial pose, or a sweep over the out-of-plane angles.</source>
        <translation>围绕初始位姿的退火粒子，或遍历平面外角度。</translation>
    </message>
    <message>
        <source>Seed of the random number generator; the same seed reproduces the result.</source>
        <translation>随机数种子；相同的种子可重现结果。</translation>
    </message>
    <message>
        <source>Attracted to</source>
        <translation>吸引来源</translation>
    </message>
    <message>
        <source>Auxiliary points</source>
        <translation>辅助点</translation>
    </message>
    <message>
        <source>Best-first search over sequences of matched branches, with one pose per sequence (based on Zhu; reimplementation with our own parameters).</source>
        <translation>在匹配分支的序列中最佳优先搜索，每个序列给出一个位姿（参照 Zhu；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Image intensity along the projected vessels at the scale of each vessel, optimized by an evolution strategy (Jomier 2006; reimplementation with our own parameters).</source>
        <translation>沿投影血管按各血管尺度取图像强度，用进化策略优化（Jomier 2006；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Auxiliary branches (nodes if none are selected), nodes, the widest branches (up to one third of the total length), or random points.</source>
        <translation>辅助分支（未选择时为节点）、节点、最粗且不超过总长三分之一的分支，或随机点。</translation>
    </message>
    <message>
        <source>Coarse search, then robust point-to-line refinement about the tree&apos;s centroid; also estimates the pose uncertainty.</source>
        <translation>先粗搜索，再绕血管树质心做稳健的点到线精配准；同时估计位姿不确定度。</translation>
    </message>
    <message>
        <source>Covariance matrix adaptation (CMA-ES), or a (1+1) evolution strategy.</source>
        <translation>协方差矩阵自适应（CMA-ES），或 (1+1) 进化策略。</translation>
    </message>
    <message>
        <source>Levenberg–Marquardt on the Huber loss with updated correspondences, or L-BFGS on the squared distances.</source>
        <translation>对 Huber 损失用 Levenberg–Marquardt 并更新对应，或对距离平方用 L-BFGS。</translation>
    </message>
    <message>
        <source>Direction kernel</source>
        <translation>方向核</translation>
    </message>
    <message>
        <source>Use directions</source>
        <translation>使用方向</translation>
    </message>
    <message>
        <source>Spacing of the points on the traced vessels.</source>
        <translation>提取血管上的点间距。</translation>
    </message>
    <message>
        <source>Spacing of the tree points used for matching; a smaller spacing takes longer to compute.</source>
        <translation>参与匹配的血管树点间距；间距越小，计算越慢。</translation>
    </message>
    <message>
        <source>Distance beyond which a point has little weight in the final stage; image noise can increase this distance.</source>
        <translation>最终阶段超过此距离的点权重很小；图像噪声会使其增大。</translation>
    </message>
    <message>
        <source>Distance beyond which the influence of a point no longer increases.</source>
        <translation>超过此距离后单点影响不再增大。</translation>
    </message>
    <message>
        <source>Edge scale</source>
        <translation>边缘尺度</translation>
    </message>
    <message>
        <source>Edge search along the vessel wall normals; RANSAC with gradient matching selects the pose (Markelj 2008; reimplementation with our own parameters).</source>
        <translation>沿血管壁法线寻找边缘，以 RANSAC 和梯度匹配选位姿（Markelj 2008；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Max. evaluations</source>
        <translation>最大评估次数</translation>
    </message>
    <message>
        <source>Even spacing</source>
        <translation>等间距</translation>
    </message>
    <message>
        <source>Factor by which the kernel width is multiplied in each step after the first thirty.</source>
        <translation>前三十步之后，每步核宽所乘的系数。</translation>
    </message>
    <message>
        <source>Final scale</source>
        <translation>最终尺度</translation>
    </message>
    <message>
        <source>Initial kernel width</source>
        <translation>初始核宽</translation>
    </message>
    <message>
        <source>Initial range</source>
        <translation>初始范围</translation>
    </message>
    <message>
        <source>Initial matching range</source>
        <translation>初始匹配范围</translation>
    </message>
    <message>
        <source>Max. flow steps</source>
        <translation>最大流步数</translation>
    </message>
    <message>
        <source>Gradient ascent on the mean kernel value between the tree and the traced vessels, or on the image intensity (Aylward 2003; reimplementation with our own parameters).</source>
        <translation>对血管树与提取血管之间的平均核值，或图像强度做梯度上升（Aylward 2003；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Gradient flow of the inner product of the tree and the traced vessels, both represented as functions in the image (Ghaffari 2019; reimplementation with our own parameters).</source>
        <translation>血管树与提取血管作为图像函数之内积的梯度流（Ghaffari 2019；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Maximum number of gradient steps at each of the three kernel widths.</source>
        <translation>三个核宽各自的最多梯度步数。</translation>
    </message>
    <message>
        <source>Required similarity of directions; smaller values are stricter.</source>
        <translation>所要求的方向相似程度；越小越严格。</translation>
    </message>
    <message>
        <source>Maximum distance between a bifurcation or endpoint of the tree and its match in the image.</source>
        <translation>树的分叉或端点与其在图像中的匹配点之间的最大距离。</translation>
    </message>
    <message>
        <source>Search range of the in-plane shift.</source>
        <translation>平面内平移的搜索范围。</translation>
    </message>
    <message>
        <source>Initial search distance for edges along the normals of the vessel walls.</source>
        <translation>沿血管壁法线寻找边缘的初始距离。</translation>
    </message>
    <message>
        <source>Initial maximum distance between a branch and the traced vessel matched to it.</source>
        <translation>分支与其对应提取血管之间的初始最大距离。</translation>
    </message>
    <message>
        <source>Margin of the mask around the projected vessels.</source>
        <translation>掩膜超出投影血管的边距。</translation>
    </message>
    <message>
        <source>Search range of the LAO/RAO and CRA/CAU angles.</source>
        <translation>LAO/RAO 和 CRA/CAU 方向的搜索范围。</translation>
    </message>
    <message>
        <source>Search range of the in-plane rotation.</source>
        <translation>平面内旋转的搜索范围。</translation>
    </message>
    <message>
        <source>Number of auxiliary points if these are chosen at random.</source>
        <translation>辅助点为随机时的数量。</translation>
    </message>
    <message>
        <source>Weighting of the initial-pose prior relative to the image.</source>
        <translation>初始位姿先验相对于图像的权衡方式。</translation>
    </message>
    <message>
        <source>Nearest-neighbor search: the k-d tree and the grid are exact; the distance map is accurate to within three pixels.</source>
        <translation>最近邻搜索：k-d 树和网格为精确，距离图误差在三个像素内。</translation>
    </message>
    <message>
        <source>Huber distance</source>
        <translation>Huber 距离</translation>
    </message>
    <message>
        <source>Hypotheses</source>
        <translation>假设数</translation>
    </message>
    <message>
        <source>Max. ICP iterations</source>
        <translation>ICP 最大迭代次数</translation>
    </message>
    <message>
        <source>Image point spacing</source>
        <translation>图像点间距</translation>
    </message>
    <message>
        <source>Image points that attract each tree point: the nearest, the five nearest, or all within three kernel widths.</source>
        <translation>吸引每个树点的图像点：最近的、最近五个，或三倍核宽内的全部。</translation>
    </message>
    <message>
        <source>Max. iterations</source>
        <translation>最大迭代次数</translation>
    </message>
    <message>
        <source>Keeps the extent of the projected tree equal to that of the traced vessels; lower the weight if many branches are missing from the image.</source>
        <translation>使投影血管树的范围与提取血管一致；图像中缺失许多分支时请降低。</translation>
    </message>
    <message>
        <source>Prevents the projected tree from shrinking; lower the weight if many branches are missing from the image.</source>
        <translation>防止投影血管树收缩；图像中缺失许多分支时请降低。</translation>
    </message>
    <message>
        <source>Kernel decay</source>
        <translation>核衰减</translation>
    </message>
    <message>
        <source>Initial kernel width: the largest distance, or its square as printed in the original paper.</source>
        <translation>初始核宽：最大距离，或如论文所示取其平方。</translation>
    </message>
    <message>
        <source>Kernel-weighted iterative PnP on all points (Song, Ghaffari).</source>
        <translation>对全部点的核加权迭代 PnP（Song、Ghaffari）。</translation>
    </message>
    <message>
        <source>L2 distance between oriented Gaussian mixtures of the tree and the traced vessels (Baka 2014; reimplementation with our own parameters).</source>
        <translation>血管树与提取血管的有向高斯混合之 L2 距离（Baka 2014；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Final kernel width</source>
        <translation>最终核宽</translation>
    </message>
    <message>
        <source>Last pose ± (depth)</source>
        <translation>上次位姿 ±（深度）</translation>
    </message>
    <message>
        <source>Last pose ± (rotation)</source>
        <translation>上次位姿 ±（旋转）</translation>
    </message>
    <message>
        <source>Last pose ± (shift)</source>
        <translation>上次位姿 ±（平移）</translation>
    </message>
    <message>
        <source>Minimization of the Huber loss of the distances to the nearest traced vessel (Rivest-Hénault 2012; reimplementation with our own parameters).</source>
        <translation>到最近提取血管距离的 Huber 损失最小（Rivest-Hénault 2012；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Least squares on branches matched by graph matching, followed by length-preserving vessel motion (Groher 2009; reimplementation with our own parameters).</source>
        <translation>通过图匹配对应分支后的最小二乘，随后做保持长度的血管移动（Groher 2009；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Iterative closest point (ICP) registration with OpenCV&apos;s SQPnP solver.</source>
        <translation>使用 OpenCV SQPnP 求解器的迭代最近点。</translation>
    </message>
    <message>
        <source>Allow vessel motion</source>
        <translation>允许血管移动</translation>
    </message>
    <message>
        <source>Alternates between the auxiliary and the full problem.</source>
        <translation>辅助问题与完整问题交替求解。</translation>
    </message>
    <message>
        <source>Alternates between the auxiliary points and all points.</source>
        <translation>辅助点与全部点交替求解。</translation>
    </message>
    <message>
        <source>Maximum number of rounds of line searches along all six directions.</source>
        <translation>沿六个方向线搜索的最多轮数。</translation>
    </message>
    <message>
        <source>Searches the neighborhood of the initial pose before refinement.</source>
        <translation>精配准前先在初始位姿附近搜索。</translation>
    </message>
    <message>
        <source>Particle filter with resampling by likelihood, or a sweep over the out-of-plane angles (based on Tian 2022; reimplementation with our own parameters).</source>
        <translation>按似然重采样的粒子滤波，或遍历平面外角度（参照 Tian 2022；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Mask margin</source>
        <translation>掩膜边距</translation>
    </message>
    <message>
        <source>Maximum number of rounds of matching and pose selection.</source>
        <translation>匹配与选位姿的最多轮数。</translation>
    </message>
    <message>
        <source>Maximum number of rounds of matching and solving.</source>
        <translation>匹配与求解的最多轮数。</translation>
    </message>
    <message>
        <source>Maximum number of rounds of branch matching and pose fitting.</source>
        <translation>分支匹配与位姿拟合的最多轮数。</translation>
    </message>
    <message>
        <source>After the rigid fit, moves the branches to their matches while preserving branch lengths, and reports the displacement; the pose does not change.</source>
        <translation>刚性拟合后将分支保持长度移向其匹配血管并报告位移；位姿不变。</translation>
    </message>
    <message>
        <source>NICP within the alternating search (Song, Ghaffari; reimplementation with our own parameters).</source>
        <translation>交替搜索中的 NICP（Song、Ghaffari；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Narrows the kernel after every five steps, or when no new point comes within its range.</source>
        <translation>每五步收窄核，或在不再有新点进入范围时收窄。</translation>
    </message>
    <message>
        <source>Nearest-point search</source>
        <translation>最近点搜索</translation>
    </message>
    <message>
        <source>Neighbors</source>
        <translation>邻点</translation>
    </message>
    <message>
        <source>Off-axis ±</source>
        <translation>偏离轴线 ±</translation>
    </message>
    <message>
        <source>For images that show only a guidewire or catheter: finds its path through the tree and a pose near that of the last full registration.</source>
        <translation>用于仅可见导丝或导管的图像：求其在血管树中的路径，以及上次完整配准附近的位姿。</translation>
    </message>
    <message>
        <source>Particles</source>
        <translation>粒子数</translation>
    </message>
    <message>
        <source>Compared pixels</source>
        <translation>比较像素</translation>
    </message>
    <message>
        <source>Points attract each other more strongly where the vessels run in similar directions.</source>
        <translation>血管走向越相近，点之间吸引越强。</translation>
    </message>
    <message>
        <source>Population</source>
        <translation>种群</translation>
    </message>
    <message>
        <source>Number of poses per round, each computed from three random correspondences.</source>
        <translation>每轮由三个随机对应求得的位姿数。</translation>
    </message>
    <message>
        <source>Number of poses retained per round.</source>
        <translation>每轮保留的位姿数。</translation>
    </message>
    <message>
        <source>Maximum total number of poses tested.</source>
        <translation>最多测试的位姿总数。</translation>
    </message>
    <message>
        <source>Number of poses tested per generation.</source>
        <translation>每代测试的位姿数。</translation>
    </message>
    <message>
        <source>Prior</source>
        <translation>先验</translation>
    </message>
    <message>
        <source>Prior weight</source>
        <translation>先验权重</translation>
    </message>
    <message>
        <source>Initial-pose prior</source>
        <translation>初始位姿先验</translation>
    </message>
    <message>
        <source>Maximum number of DRRs computed.</source>
        <translation>最多计算的 DRR 数。</translation>
    </message>
    <message>
        <source>Random points</source>
        <translation>随机点</translation>
    </message>
    <message>
        <source>Random seed</source>
        <translation>随机种子</translation>
    </message>
    <message>
        <source>Rank correlation of the image with DRRs of the CTA or of vessel tubes, optimized by the Nelder–Mead method (Steininger 2012; reimplementation with our own parameters).</source>
        <translation>图像与 CTA 或管状模型的 DRR 的秩相关，Nelder–Mead（Steininger 2012；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Initial range of the attraction.</source>
        <translation>初始吸引范围。</translation>
    </message>
    <message>
        <source>Final range of the attraction.</source>
        <translation>最终吸引范围。</translation>
    </message>
    <message>
        <source>Max. node distance</source>
        <translation>最大节点距离</translation>
    </message>
    <message>
        <source>Rigid only, or rigid followed by an affine stage whose rigid component is adopted if it fits better.</source>
        <translation>仅刚性，或之后加仿射阶段，其刚性部分更优时保留。</translation>
    </message>
    <message>
        <source>Rotation first</source>
        <translation>先旋转</translation>
    </message>
    <message>
        <source>Rounds</source>
        <translation>轮数</translation>
    </message>
    <message>
        <source>Max. rounds</source>
        <translation>最大轮数</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Search radius</source>
        <translation>搜索半径</translation>
    </message>
    <message>
        <source>Roll search range</source>
        <translation>滚转搜索范围</translation>
    </message>
    <message>
        <source>Tilt search range</source>
        <translation>倾角搜索范围</translation>
    </message>
    <message>
        <source>Self term</source>
        <translation>自身项</translation>
    </message>
    <message>
        <source>Maximum number of matched-branch sequences tested.</source>
        <translation>最多测试的匹配分支序列数。</translation>
    </message>
    <message>
        <source>Fraction of the mask used for the rank correlation; at least 2000 pixels are used.</source>
        <translation>秩相关所用掩膜比例；至少 2000 像素。</translation>
    </message>
    <message>
        <source>Smoothing scale of the image gradients.</source>
        <translation>图像梯度的平滑尺度。</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>求解器</translation>
    </message>
    <message>
        <source>Spread term</source>
        <translation>展宽项</translation>
    </message>
    <message>
        <source>Resamples the points at even spacing before matching; if off, the points are used unchanged.</source>
        <translation>匹配前将点等距化；关闭则使用原始点。</translation>
    </message>
    <message>
        <source>Standard deviation of the in-plane position in the last full registration.</source>
        <translation>上次完整配准中平面内位置的标准差。</translation>
    </message>
    <message>
        <source>Standard deviation of the depth in the last full registration.</source>
        <translation>上次完整配准中深度的标准差。</translation>
    </message>
    <message>
        <source>Standard deviation of the angles in the last full registration.</source>
        <translation>上次完整配准中角度的标准差。</translation>
    </message>
    <message>
        <source>Standard deviation of the in-plane position of the initial pose.</source>
        <translation>初始位姿平面内位置的标准差。</translation>
    </message>
    <message>
        <source>Standard deviation of the depth of the initial pose.</source>
        <translation>初始位姿深度的标准差。</translation>
    </message>
    <message>
        <source>Standard deviation of the angles of the initial pose; constrains the components that the image cannot determine.</source>
        <translation>初始位姿角度的标准差；约束图像无法确定的分量。</translation>
    </message>
    <message>
        <source>Standard deviation of the distance of the guidewire from the centerline, in addition to its free play within the lumen.</source>
        <translation>导丝与中心线距离的标准差，不含其在管腔内的活动范围。</translation>
    </message>
    <message>
        <source>Initial depth ±</source>
        <translation>初始深度 ±</translation>
    </message>
    <message>
        <source>Maximum number of steps along the flow, summed over all kernel widths.</source>
        <translation>沿流的最多步数，各核宽合计。</translation>
    </message>
    <message>
        <source>Path rank</source>
        <translation>路径序号</translation>
    </message>
    <message>
        <source>Auxiliary branch weight</source>
        <translation>辅助分支的权重</translation>
    </message>
    <message>
        <source>Weight of the auxiliary branches relative to the fit of all branches; with a weight of 1, they are not fitted separately.</source>
        <translation>辅助分支相对于全部分支拟合的权重；为 1 时不单独拟合。</translation>
    </message>
    <message>
        <source>Geometry uncertainty</source>
        <translation>几何不确定度</translation>
    </message>
    <message>
        <source>Uncertainty of the focal length and the principal point: typical of their source, as specified below, or none.</source>
        <translation>焦距和主点的不确定度：按其来源的典型值、按下方给定值，或不考虑。</translation>
    </message>
    <message>
        <source>Focal length ±</source>
        <translation>焦距 ±</translation>
    </message>
    <message>
        <source>Standard deviation of the focal length; applies if the geometry uncertainty is set to “given”.</source>
        <translation>焦距的标准差；在几何不确定度设为“给定”时适用。</translation>
    </message>
    <message>
        <source>Principal point ±</source>
        <translation>主点 ±</translation>
    </message>
    <message>
        <source>Standard deviation of each principal-point coordinate; applies if the geometry uncertainty is set to “given”.</source>
        <translation>主点各坐标的标准差；在几何不确定度设为“给定”时适用。</translation>
    </message>
    <message>
        <source>Estimate geometry</source>
        <translation>估计几何参数</translation>
    </message>
    <message>
        <source>If the images clearly contradict the focal length or the principal point, adopts the values that best fit the images and registers again.</source>
        <translation>当图像明显与焦距或主点不符时，采用图像所示的值并重新配准。</translation>
    </message>
    <message>
        <source>Mirrored or rotated images</source>
        <translation>镜像或旋转的图像</translation>
    </message>
    <message>
        <source>If confidence is low, reports whether the image appears mirrored or rotated.</source>
        <translation>置信度低时，报告图像是否像被镜像或旋转。</translation>
    </message>
    <message>
        <source>Deformation</source>
        <translation>形变</translation>
    </message>
    <message>
        <source>Whether to deform the vessels to match the image after rigid registration: never; automatically, if the fit suggests a deformation (AngioPose method, no degrees of freedom locked); or always.</source>
        <translation>刚性配准后将血管形变到图像上：从不；在拟合提示存在形变时自动进行（AngioPose 方法，且未锁定自由度）；或总是。</translation>
    </message>
    <message>
        <source>Initial rotation ±</source>
        <translation>初始旋转 ±</translation>
    </message>
    <message>
        <source>Initial scale</source>
        <translation>初始尺度</translation>
    </message>
    <message>
        <source>Initial shift ±</source>
        <translation>初始平移 ±</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步长</translation>
    </message>
    <message>
        <source>Steps per width</source>
        <translation>每宽度步数</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>策略</translation>
    </message>
    <message>
        <source>Weight of the initial-pose prior.</source>
        <translation>初始位姿先验的权重。</translation>
    </message>
    <message>
        <source>Maximum number of refinement steps.</source>
        <translation>精配准的最多步数。</translation>
    </message>
    <message>
        <source>Number of rounds; the spread of the particles decreases by one quarter in each round.</source>
        <translation>轮数；每轮粒子的散布缩小四分之一。</translation>
    </message>
    <message>
        <source>The traced vessels, or the image intensity at the scale of each vessel.</source>
        <translation>提取的血管，或按各血管尺度的图像强度。</translation>
    </message>
    <message>
        <source>Transformation</source>
        <translation>变换</translation>
    </message>
    <message>
        <source>Tree point spacing</source>
        <translation>树点间距</translation>
    </message>
    <message>
        <source>Rotates about the X-ray source before all other steps.</source>
        <translation>首先绕射线源旋转。</translation>
    </message>
    <message>
        <source>Scaling of the gradient step: balanced between rotation and translation, or unscaled in radians and millimeters, which yields hardly any translation.</source>
        <translation>梯度步的缩放：旋转与平移平衡，或弧度与毫米不加缩放（几乎不平移）。</translation>
    </message>
    <message>
        <source>Matching of vessel walls to image gradients by Powell&apos;s method (Mitrović 2013; reimplementation with our own parameters).</source>
        <translation>血管壁与图像梯度匹配，Powell 法（Mitrović 2013；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Initial width of the Gaussians in the mixture.</source>
        <translation>高斯混合的初始宽度。</translation>
    </message>
    <message>
        <source>Final width of the Gaussians in the mixture.</source>
        <translation>高斯混合的最终宽度。</translation>
    </message>
    <message>
        <source>affine</source>
        <translation>仿射</translation>
    </message>
    <message>
        <source>auxiliary</source>
        <translation>辅助分支</translation>
    </message>
    <message>
        <source>converged</source>
        <translation>已收敛</translation>
    </message>
    <message>
        <source>full</source>
        <translation>全部点</translation>
    </message>
    <message>
        <source>iteration limit</source>
        <translation>达到迭代上限</translation>
    </message>
    <message>
        <source>no improvement</source>
        <translation>不再改善</translation>
    </message>
    <message>
        <source>joint</source>
        <translation>联合</translation>
    </message>
    <message>
        <source>refine</source>
        <translation>精配准</translation>
    </message>
    <message>
        <source>rotation</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>settle</source>
        <translation>稳定</translation>
    </message>
    <message>
        <source>bending</source>
        <translation>形变</translation>
    </message>
    <message>
        <source>stopped by the user</source>
        <translation>用户停止</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>辅助分支</translation>
    </message>
    <message>
        <source>closest</source>
        <translation>最近</translation>
    </message>
    <message>
        <source>cma-es</source>
        <translation>CMA-ES</translation>
    </message>
    <message>
        <source>five</source>
        <translation>五个</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>halving</source>
        <translation>减半</translation>
    </message>
    <message>
        <source>image</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>kd-tree</source>
        <translation>k-d 树</translation>
    </message>
    <message>
        <source>largest</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>largest squared</source>
        <translation>最大平方</translation>
    </message>
    <message>
        <source>lbfgs</source>
        <translation>L-BFGS</translation>
    </message>
    <message>
        <source>literal</source>
        <translation>按原式</translation>
    </message>
    <message>
        <source>lm</source>
        <translation>LM</translation>
    </message>
    <message>
        <source>main branches</source>
        <translation>主要分支</translation>
    </message>
    <message>
        <source>never</source>
        <translation>从不</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>always</source>
        <translation>总是</translation>
    </message>
    <message>
        <source>by origin</source>
        <translation>按来源</translation>
    </message>
    <message>
        <source>given</source>
        <translation>给定</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>map</source>
        <translation>距离图</translation>
    </message>
    <message>
        <source>metric</source>
        <translation>度量</translation>
    </message>
    <message>
        <source>nodes</source>
        <translation>节点</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>one plus one</source>
        <translation>一加一</translation>
    </message>
    <message>
        <source>out of plane</source>
        <translation>平面外</translation>
    </message>
    <message>
        <source>particles</source>
        <translation>粒子</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>random</source>
        <translation>随机</translation>
    </message>
    <message>
        <source>rigid</source>
        <translation>刚性</translation>
    </message>
    <message>
        <source>seed mean</source>
        <translation>均值</translation>
    </message>
    <message>
        <source>seed metric</source>
        <translation>度量</translation>
    </message>
    <message>
        <source>seed noprior</source>
        <translation>无先验</translation>
    </message>
    <message>
        <source>seed sum</source>
        <translation>求和</translation>
    </message>
    <message>
        <source>stagnation</source>
        <translation>停滞</translation>
    </message>
    <message>
        <source>traced vessels</source>
        <translation>提取血管</translation>
    </message>
</context>
<context>
    <name>angiopose::app::AngleController</name>
    <message>
        <source>C-arm angles for %1</source>
        <translation>%1 的 C 臂角度</translation>
    </message>
    <message>
        <source>No branch</source>
        <translation>无分支</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::AngleDialog</name>
    <message>
        <source>Origin only (±10 mm)</source>
        <translation>仅起始部（±10 mm）</translation>
    </message>
    <message>
        <source>C-arm angles</source>
        <translation>C 臂角度</translation>
    </message>
    <message>
        <source>Blue: visible at full length and without overlap. Amber: foreshortened or overlapped.</source>
        <translation>蓝色：全长可见且无重叠。琥珀色：缩短或有重叠。</translation>
    </message>
    <message>
        <source>Gantry position of this image.</source>
        <translation>此图像的 C 臂位置。</translation>
    </message>
    <message>
        <source>Gantry limits</source>
        <translation>C 臂范围</translation>
    </message>
    <message>
        <source>Current: %1</source>
        <translation>当前：%1</translation>
    </message>
    <message>
        <source>%1: foreshortening %2 %, overlap %3 %</source>
        <translation>%1：缩短 %2 %，重叠 %3 %</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::AngleMapPlot</name>
    <message>
        <source>Gantry angle map</source>
        <translation>C 臂角度图</translation>
    </message>
    <message>
        <source>no map yet</source>
        <translation>尚无角度图</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SimulatedView</name>
    <message>
        <source>Simulated view at these angles</source>
        <translation>这些角度下的模拟视图</translation>
    </message>
</context>
<context>
    <name>messages</name>
    <message>
        <source>The camera or the pose contains a value that is not a finite number. Export both again.</source>
        <comment>projection.not-finite</comment>
        <translation>相机或位姿中含有非有限数值。请重新导出。</translation>
    </message>
    <message>
        <source>The left 3 × 3 block of the projection matrix is singular, so this is not an X-ray camera. Export the matrix again.</source>
        <comment>projection.degenerate</comment>
        <translation>投影矩阵左侧 3 × 3 块不可逆，因此不是 X 射线相机。请重新导出。</translation>
    </message>
    <message>
        <source>The camera has skewed pixels (skew %1). Provide a camera without skew, or resample the image.</source>
        <comment>projection.skewed</comment>
        <translation>相机像素存在偏斜（偏斜 %1）。请提供无偏斜的相机，或对图像重采样。</translation>
    </message>
    <message>
        <source>K may contain only the focal lengths and the principal point: fx 0 cx, 0 fy cy, 0 0 1. Check that it is not transposed.</source>
        <comment>projection.intrinsics</comment>
        <translation>K 只能包含焦距和主点：fx 0 cx, 0 fy cy, 0 0 1。请检查是否被转置。</translation>
    </message>
    <message>
        <source>R is not a rotation (it contains scale or shear). Provide a rigid pose in mm.</source>
        <comment>projection.no-rotation</comment>
        <translation>R 不是旋转（含缩放或剪切）。请提供以 mm 为单位的刚性位姿。</translation>
    </message>
    <message>
        <source>the file contains no camera with a pose. Provide P (3 × 4); or K (3 × 3), R (3 × 3, or rvec) and t (3).</source>
        <comment>exchange.no-pose</comment>
        <translation>文件中没有带位姿的相机。请提供 P (3 × 4)，或 K (3 × 3)、R (3 × 3 或 rvec) 和 t (3)。</translation>
    </message>
    <message>
        <source>the file contains %1 numbers. P = K [R t] requires 12 numbers (three rows of four); a cameraFromPatient pose requires 16 (four rows of four).</source>
        <comment>exchange.numbers</comment>
        <translation>文件中有 %1 个数。P = K [R t] 有 12 个（三行四列），位姿 cameraFromPatient 有 16 个。</translation>
    </message>
    <message>
        <source>the camera has lens distortion (distortion coefficients). Undistort the image, then specify a camera without distortion.</source>
        <comment>exchange.distorted</comment>
        <translation>相机含畸变（畸变系数）。请先校正图像畸变，再提供无畸变的相机。</translation>
    </message>
    <message>
        <source>a pose in this format requires a camera. Specify a case, or a pose that includes a camera.</source>
        <comment>exchange.no-camera</comment>
        <translation>此格式的位姿需要相机。请提供病例，或带相机的位姿。</translation>
    </message>
    <message>
        <source>a camera with a pose can be saved as .json, .txt, .yml, .yaml or .xml. Change the extension.</source>
        <comment>exchange.extension</comment>
        <translation>带位姿的相机可保存为 .json、.txt、.yml、.yaml 或 .xml。请更改扩展名。</translation>
    </message>
    <message>
        <source>this is a PyTorch file, which can execute code when it is read. Save its pose as JSON first (FORMATS §3.4).</source>
        <comment>exchange.pickle</comment>
        <translation>这是 PyTorch 文件，读取时可能执行代码。请先将其位姿保存为 JSON（FORMATS §3.4）。</translation>
    </message>
    <message>
        <source>this is not a DiffDRR view: %1 is missing or invalid. FORMATS §3.4 lists the keys.</source>
        <comment>exchange.diffdrr-keys</comment>
        <translation>这不是 DiffDRR 视图：%1 缺失或无效。各键见 FORMATS §3.4。</translation>
    </message>
    <message>
        <source>the file contains no fiducials. Export the points of a markups node.</source>
        <comment>fiducials.none</comment>
        <translation>文件中没有标志点。请导出 markups 节点的点。</translation>
    </message>
    <message>
        <source>line %1 contains no point (id,x,y,z,…). Export the points again.</source>
        <comment>fiducials.line</comment>
        <translation>第 %1 行没有点 (id,x,y,z,…)。请重新导出这些点。</translation>
    </message>
    <message>
        <source>the coordinate system is %1, not LPS or RAS. Export the points in patient coordinates.</source>
        <comment>fiducials.system</comment>
        <translation>其坐标系是 %1，不是 LPS 或 RAS。请以患者坐标导出这些点。</translation>
    </message>
    <message>
        <source>points can be saved as .fcsv or .mrk.json. Change the extension.</source>
        <comment>fiducials.extension</comment>
        <translation>点可保存为 .fcsv 或 .mrk.json。请更改扩展名。</translation>
    </message>
    <message>
        <source>%1 contains a pose or points. Open the case to which the file belongs first, then open this file separately.</source>
        <comment>open.pose-alone</comment>
        <translation>%1 含有位姿或点。请先打开其所属病例，再单独打开此文件。</translation>
    </message>
    <message>
        <source>The pose was determined with a different camera from that of the case. The vessels are drawn with the camera stored with the pose.</source>
        <comment>pose.other-camera</comment>
        <translation>该位姿由不同于病例的相机求得。血管按随位姿保存的相机绘制。</translation>
    </message>
    <message>
        <source>The pose belongs to an image of %1 × %2 px, but the angiogram is %3 × %4 px. Choose the pose that belongs to this angiogram.</source>
        <comment>pose.other-image</comment>
        <translation>该位姿属于 %1 × %2 px 的图像，而血管造影为 %3 × %4 px。请选择属于此血管造影的位姿。</translation>
    </message>
    <message>
        <source>the case has no landmarks, target points or ostium rings. Add some in the window first.</source>
        <comment>convert.no-points</comment>
        <translation>病例没有标志点、目标点或开口环。请先在窗口中添加。</translation>
    </message>
    <message>
        <source>For this pose, the detector is assumed to be at negative z without an extrinsic matrix, as in xReg X-ray data. Use --camera if the image is mirrored.</source>
        <comment>convert.xreg-guessed</comment>
        <translation>假定该位姿的探测器位于负 z 且没有外参矩阵，与 xReg 的 X 射线数据一致。若图像为镜像，请使用 --camera。</translation>
    </message>
    <message>
        <source>the operating system provides no random numbers, so pseudonyms cannot be kept secret.</source>
        <comment>deidentify.no-random-key</comment>
        <translation>操作系统未提供随机数，因此无法保证假名的保密性。</translation>
    </message>
    <message>
        <source>The image contains burned-in text, for example at column %1, row %2. Review the text, or mask it.</source>
        <comment>deidentify.letters-stay</comment>
        <translation>图像中有烧录文字（例如第 %1 列、第 %2 行）。请检查或将其遮盖。</translation>
    </message>
    <message>
        <source>Burned-in text was masked (%1 % of the image area). Check that no text remains.</source>
        <comment>deidentify.letters-blacked-out</comment>
        <translation>烧录文字已遮盖（占图像面积的 %1 %）。请检查是否有残留。</translation>
    </message>
    <message>
        <source>According to the header, patient information is burned into the image, but no text was detected. Review every frame.</source>
        <comment>deidentify.letters-declared</comment>
        <translation>文件头声明图像中烧录有身份信息，但未检测到文字。请检查每一帧。</translation>
    </message>
    <message>
        <source>Colors were converted to gray levels, as displayed in the program.</source>
        <comment>deidentify.colour-dropped</comment>
        <translation>颜色已转换为灰度，与程序的显示一致。</translation>
    </message>
    <message>
        <source>Damaged frames were saved as far as they could be decoded: %1 of %2.</source>
        <comment>deidentify.frames-damaged</comment>
        <translation>损坏的帧已按可解码的程度保存：%1 / %2。</translation>
    </message>
    <message>
        <source>Files without an image were skipped: %1 of %2.</source>
        <comment>deidentify.files-left-out</comment>
        <translation>不含图像的文件已跳过：%1 / %2。</translation>
    </message>
    <message>
        <source>the segments use an encoding that cannot be written. Convert the file to .nii.gz or .nrrd; these formats store no label names.</source>
        <comment>deidentify.segmentation</comment>
        <translation>其分割使用无法写出的编码。请将文件转换为 .nii.gz 或 .nrrd；这些格式不保存标签名称。</translation>
    </message>
    <message>
        <source>the compressed 32-bit pixels cannot be re-encoded. Convert the file to .nii.gz or .nrrd.</source>
        <comment>deidentify.pixels-too-wide</comment>
        <translation>其 32 位压缩像素无法重新编码。请将文件转换为 .nii.gz 或 .nrrd。</translation>
    </message>
    <message>
        <source>only PNG, JPEG, TIFF and DICOM images can be stripped of metadata. Save the image as PNG.</source>
        <comment>deidentify.picture</comment>
        <translation>只有 PNG、JPEG、TIFF 和 DICOM 图像可以去除元数据。请另存为 PNG。</translation>
    </message>
    <message>
        <source>the folder is not empty. Choose an empty folder so that no other files are shared with the output.</source>
        <comment>deidentify.output-not-empty</comment>
        <translation>该文件夹不为空。请选择空文件夹，以免一并共享其他文件。</translation>
    </message>
    <message>
        <source>the folder contains no DICOM image. Choose the folder of one study.</source>
        <comment>deidentify.nothing</comment>
        <translation>文件夹中没有 DICOM 图像。请选择一次检查的文件夹。</translation>
    </message>
    <message>
        <source>an input file of the case could not be read and is therefore missing from the ZIP archive: %1</source>
        <comment>pack.input-missing</comment>
        <translation>病例的一个输入文件无法读取，未放入 ZIP 压缩包：%1</translation>
    </message>
    <message>
        <source>cases can be shared only as .zip. Change the extension.</source>
        <comment>pack.format</comment>
        <translation>病例以 .zip 共享。请更改扩展名。</translation>
    </message>
    <message>
        <source>the ZIP archive cannot be written (%1). Choose another folder, or free disk space.</source>
        <comment>pack.not-written</comment>
        <translation>无法写入 ZIP 压缩包（%1）。请选择其他文件夹，或释放磁盘空间。</translation>
    </message>
    <message>
        <source>Names, notes and other text entered by users were replaced by numbers (count: %1).</source>
        <comment>pack.texts-cleared</comment>
        <translation>手工输入的名称、备注和文字已替换为编号：%1。</translation>
    </message>
    <message>
        <source>the ZIP archive does not match the original case: %1 Nothing was written.</source>
        <comment>pack.differs</comment>
        <translation>ZIP 压缩包与原病例不一致：%1 未写出任何内容。</translation>
    </message>
    <message>
        <source>Branch names are kept. Check that they contain anatomy only.</source>
        <comment>pack.branch-names</comment>
        <translation>分支名称予以保留。请确认其中只有解剖名称。</translation>
    </message>
    <message>
        <source>a view is missing.</source>
        <comment>pack.views</comment>
        <translation>缺少一个视图。</translation>
    </message>
    <message>
        <source>the pixels of an image differ.</source>
        <comment>pack.pixels</comment>
        <translation>某幅图像的像素不同。</translation>
    </message>
    <message>
        <source>a result is no longer valid.</source>
        <comment>pack.results</comment>
        <translation>一个结果不再有效。</translation>
    </message>
    <message>
        <source>the vessels differ.</source>
        <comment>pack.vessels</comment>
        <translation>血管不同。</translation>
    </message>
    <message>
        <source>a key must be at least 16 bytes long. To create one: head -c 32 /dev/urandom &gt; key</source>
        <comment>deidentify.key-too-short</comment>
        <translation>密钥至少需要 16 字节。可这样生成：head -c 32 /dev/urandom &gt; key</translation>
    </message>
    <message>
        <source>the output for this file must have the extension %1; the output for a folder is a folder. Name OUT accordingly.</source>
        <comment>deidentify.kind</comment>
        <translation>此文件的输出须以 %1 为扩展名；文件夹的输出为文件夹。请相应命名 OUT。</translation>
    </message>
    <message>
        <source>this TIFF cannot be rewritten losslessly (supported: grayscale, palette and RGB images in strips, with 8-bit, 16-bit or floating-point samples). Convert it to PNG.</source>
        <comment>deidentify.tiff</comment>
        <translation>该 TIFF 无法无损重新保存（支持条带式的灰度、调色板或 RGB，8 或 16 位或浮点）。请另存为 PNG。</translation>
    </message>
    <message>
        <source>this is a PDF document, and any of its pages may contain names. Create it again from a de-identified case.</source>
        <comment>deidentify.pages</comment>
        <translation>这是 PDF 文档，任何页面都可能包含姓名。请由去标识化的病例重新生成。</translation>
    </message>
    <message>
        <source>objects of SOP class %1 contain data that cannot be reliably de-identified. Exclude this object.</source>
        <comment>deidentify.object</comment>
        <translation>SOP 类 %1 的对象含有无法可靠去标识化的数据。请排除此对象。</translation>
    </message>
    <message>
        <source>the SOP class (%1) does not define an image, but the file contains one, which would be lost. Export the object again, or exclude it.</source>
        <comment>deidentify.object-with-pixels</comment>
        <translation>其 SOP 类（%1）不含图像，但文件中含有图像，该图像会丢失。请重新导出该对象，或将其排除。</translation>
    </message>
    <message>
        <source>Free text was removed from reports, segmentations or presentation states (count: %1); codes and numbers were kept.</source>
        <comment>deidentify.words-cleared</comment>
        <translation>已从报告、分割或显示状态中去除自由文本（数量：%1）；编码和数值保留。</translation>
    </message>
    <message>
        <source>Alternative path: %1 (probability %2).</source>
        <comment>wire.may-follow</comment>
        <translation>备选路径：%1（%2）。</translation>
    </message>
    <message>
        <source>No path through the vessel tree is likely: the best path has a probability of %1.</source>
        <comment>wire.unlikely</comment>
        <translation>血管树中没有可能性高的路径：最佳路径的概率为 %1。</translation>
    </message>
    <message>
        <source>Only %1 of the guidewire lies along the vessel tree.</source>
        <comment>wire.off-tree</comment>
        <translation>仅 %1 的导丝沿血管树走行。</translation>
    </message>
    <message>
        <source>The traced curves do not form a single line: %1 of its length is gaps. Remove the curves that do not belong to the guidewire.</source>
        <comment>wire.in-pieces</comment>
        <translation>提取的曲线不构成单一线条：其中 %1 为间隙。请去除不属于导丝的曲线。</translation>
    </message>
    <message>
        <source>The guidewire does not match any path through the vessel tree near the initial pose. Start from the last full registration, or allow a larger deviation.</source>
        <comment>wire.nowhere</comment>
        <translation>在初始位姿附近，导丝与血管树的任何路径都不符。请从上次完整配准开始，或允许更大的偏差。</translation>
    </message>
    <message>
        <source>The guidewire follows branches %1 with a probability of %2, at a distance of %3 from their centerlines.</source>
        <comment>wire.follows</comment>
        <translation>导丝以 %2 的概率走行于分支 %1；偏离中心线 %3。</translation>
    </message>
    <message>
        <source>The requested path rank exceeds the number of likely paths (%1): the most likely path is used instead.</source>
        <comment>wire.fewer-ways</comment>
        <translation>请求的路径序号超过可能路径的数量（%1）：改用最可能的路径。</translation>
    </message>
    <message>
        <source>images can be saved as .png or .svg, and in the window also as .pdf. Choose one of these.</source>
        <comment>picture.kind</comment>
        <translation>图像可保存为 .png 或 .svg，在窗口中还可保存为 .pdf。请选择其一。</translation>
    </message>
    <message>
        <source>16-bit gray values can be saved only as .png.</source>
        <comment>picture.grey-kind</comment>
        <translation>16 位灰度值只能保存为 .png。</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; cannot be created: %2.</source>
        <comment>folder.not-made</comment>
        <translation>无法创建文件夹“%1”：%2。</translation>
    </message>
    <message>
        <source>Unexpected error: %1</source>
        <comment>run.unexpected-failure</comment>
        <translation>意外故障：%1</translation>
    </message>
    <message>
        <source>unknown setting &apos;%1&apos;. Closest names: %2.</source>
        <comment>setting.unknown</comment>
        <translation>没有名为“%1”的设置。最接近的名称：%2。</translation>
    </message>
    <message>
        <source>invalid value &apos;%2&apos; for the setting %1: %3</source>
        <comment>setting.value</comment>
        <translation>设置 %1 不能为“%2”：%3</translation>
    </message>
    <message>
        <source>a batch file needs a header row with a case column, or with vessels and angiogram columns, and one row per case.</source>
        <comment>batch.header-missing</comment>
        <translation>批处理表需要表头行，含有 case 列，或 vessels 和 angiogram 两列，并且每个病例一行。</translation>
    </message>
    <message>
        <source>line %1, column %2: %3</source>
        <comment>batch.cell</comment>
        <translation>第 %1 行，%2 列：%3</translation>
    </message>
    <message>
        <source>line %1 specifies both a case and inputs. Specify either the case, or its vessels and angiogram.</source>
        <comment>batch.not-both</comment>
        <translation>第 %1 行既给出病例又给出输入。请只给出病例，或只给出其血管和造影图像。</translation>
    </message>
    <message>
        <source>line %1 is incomplete. Specify a case, or both vessels and an angiogram.</source>
        <comment>batch.inputs-lack</comment>
        <translation>第 %1 行不完整。请给出病例，或同时给出血管和造影图像。</translation>
    </message>
    <message>
        <source>line %1: invalid seeds &apos;%2&apos;. Specify x y z in mm (LPS), with &apos;;&apos; between points.</source>
        <comment>batch.seeds-unclear</comment>
        <translation>第 %1 行：种子点“%2”不是点。请写成以毫米为单位的 x y z（LPS），点之间用“;”分隔。</translation>
    </message>
    <message>
        <source>the worker process ended unexpectedly (%1). Its partial output was discarded.</source>
        <comment>batch.crashed</comment>
        <translation>工作进程意外结束（%1）。已丢弃其不完整的输出。</translation>
    </message>
    <message>
        <source>the case exceeded the time limit of %1 and was aborted. Raise the limit with --time-limit.</source>
        <comment>batch.out-of-time</comment>
        <translation>该病例超过时限 %1，已中止。请用 --time-limit 提高时限。</translation>
    </message>
    <message>
        <source>the worker program %1 cannot be started.</source>
        <comment>batch.no-worker</comment>
        <translation>无法启动工作程序 %1。</translation>
    </message>
    <message>
        <source>the input contains %1 series. Specify a file of one of them, or a case that specifies the series.</source>
        <comment>batch.several-series</comment>
        <translation>输入中含有 %1 个序列。请给出其中一个序列的文件，或指明序列的病例。</translation>
    </message>
    <message>
        <source>the vessels span %1 units, which are unlikely to be millimeters. Specify a case that defines the unit.</source>
        <comment>batch.unit-unclear</comment>
        <translation>血管跨度为 %1 个单位，不大可能是毫米。请给出注明单位的病例。</translation>
    </message>
    <message>
        <source>no folder contains a result for this row. Process the row with --resume.</source>
        <comment>batch.row-missing</comment>
        <translation>没有文件夹含有此行的结果。请用 --resume 运行。</translation>
    </message>
    <message>
        <source>the results of %1 and %2 were computed with different settings or versions. Merge only results with the same settings and version.</source>
        <comment>batch.merge-differs</comment>
        <translation>%1 与 %2 的结果来自不同的设置或版本。请只合并设置和版本相同的结果。</translation>
    </message>
    <message>
        <source>this case has not been registered: its vessels are at the initial pose. Use --register, or --from with a result; use --start-pose to export the initial pose itself.</source>
        <comment>dicom-export.at-start</comment>
        <translation>此病例尚未配准：血管处于初始位姿。请使用 --register，或用 --from 给出结果；若要导出初始位姿本身，请用 --start-pose。</translation>
    </message>
    <message>
        <source>This case has not been registered: the vessels are drawn at the initial pose. Register the case with --save, or use --pose or --from.</source>
        <comment>command.drawn-at-start</comment>
        <translation>此病例尚未配准：血管按初始位姿绘制。请用 --save 配准，或使用 --pose 或 --from。</translation>
    </message>
    <message>
        <source>initial pose, not registered</source>
        <comment>pose.at-start</comment>
        <translation>初始位姿，未配准</translation>
    </message>
    <message>
        <source>this is not a registration result. Provide a result.json or joint.json written by `register` or `batch`.</source>
        <comment>result.not-one</comment>
        <translation>这不是配准结果。请提供由 `register` 或 `batch` 写出的 result.json 或 joint.json。</translation>
    </message>
    <message>
        <source>the result does not record its inputs: it was computed by an earlier version, or with estimated geometry. Register its case instead.</source>
        <comment>result.without-case</comment>
        <translation>该结果未记录其输入：它由较早的版本计算，或其配准估计了几何参数。请改为配准其病例。</translation>
    </message>
    <message>
        <source>no file with the recorded contents (SHA-256 %2) was found for input %1. Specify its folder with --inputs.</source>
        <comment>result.input-missing</comment>
        <translation>找不到内容与记录一致的输入 %1（SHA-256 %2）。请用 --inputs 指定其所在文件夹。</translation>
    </message>
    <message>
        <source>the contents of input %1 have changed since the result was computed. Specify the folder of the original with --inputs.</source>
        <comment>result.input-changed</comment>
        <translation>输入 %1 的内容在计算结果之后已改变。请用 --inputs 指定原文件所在文件夹。</translation>
    </message>
    <message>
        <source>--shard expects a part and the number of parts, such as 2/4, not &apos;%1&apos;.</source>
        <comment>command.shard-unclear</comment>
        <translation>--shard 需要部分号和总份数，例如 2/4，而不是“%1”。</translation>
    </message>
    <message>
        <source>There is no degree of freedom &apos;%1&apos;. Available: %2, or none.</source>
        <comment>command.no-such-freedom</comment>
        <translation>没有自由度“%1”。可用：%2，或 none。</translation>
    </message>
    <message>
        <source>there is no deformable registration for this pose. Register a frame in which the vessels appear deformed, or use the option deformable=always.</source>
        <comment>command.no-bent-vessels</comment>
        <translation>此位姿没有形变配准结果。请在血管看似变形的帧中配准，或使用选项 deformable=always。</translation>
    </message>
    <message>
        <source>the image of this view could not be read.</source>
        <comment>command.view-image-unread</comment>
        <translation>无法读取该视图的图像。</translation>
    </message>
    <message>
        <source>The folders to merge contain results of &apos;%1&apos; instead of &apos;%2&apos;.</source>
        <comment>command.merge-of-others</comment>
        <translation>要合并的文件夹中是“%1”的结果，而不是“%2”的。</translation>
    </message>
    <message>
        <source>the file contains no centerlines yet. Trace them with: angiopose-cli trace-vessel %1 --output %2.</source>
        <comment>convert.no-curves</comment>
        <translation>文件中还没有中心线。请先提取：angiopose-cli trace-vessel %1 --output %2。</translation>
    </message>
    <message>
        <source>this is neither a volume nor a surface, so it cannot be converted to a volume. Choose a scan (DICOM, NIfTI, NRRD, MetaImage) or a surface, or choose another output name.</source>
        <comment>convert.no-volume</comment>
        <translation>这既不是体数据也不是表面，无法转换为体数据。请选择扫描（DICOM、NIfTI、NRRD、MetaImage）或表面，或改用其他输出文件名。</translation>
    </message>
    <message>
        <source>files with this extension cannot be written. Centerlines: .vtp, .csv, .swc, .mrk.json; volumes: .nii, .nii.gz, .nrrd, .mha; surfaces: .stl; poses: .json, .tfm, .h5; X-ray runs: .dcm.</source>
        <comment>convert.extension</comment>
        <translation>不支持写入该扩展名。中心线：.vtp、.csv、.swc、.mrk.json；体数据：.nii、.nii.gz、.nrrd、.mha；表面：.stl；位姿：.json、.tfm、.h5；X 射线序列：.dcm。</translation>
    </message>
    <message>
        <source>this is the input file, which is never overwritten. Choose another name.</source>
        <comment>convert.onto-input</comment>
        <translation>这是输入文件，不会被覆盖。请选择其他文件名。</translation>
    </message>
    <message>
        <source>this is not a label image, so it has no labels. Omit --label, or choose a segmentation.</source>
        <comment>trace.no-labels</comment>
        <translation>不是标签图像，因此没有标签。请去掉 --label，或选择分割结果。</translation>
    </message>
    <message>
        <source>the file already contains centerlines, so no tracing is needed. Use `convert` to change the format.</source>
        <comment>trace.centrelines</comment>
        <translation>文件中已是中心线，无需提取。`convert` 可转换其格式。</translation>
    </message>
    <message>
        <source>this surface cannot be traced. Choose another one.</source>
        <comment>trace.other-surface</comment>
        <translation>无法提取此表面。请选择其他表面。</translation>
    </message>
    <message>
        <source>the detection of thin vessels requires the gray values of a scan, but this file has none. Omit --tubes.</source>
        <comment>trace.tubes-of-mask</comment>
        <translation>检测细血管需要扫描的灰度值，而此文件没有。请去掉 --tubes。</translation>
    </message>
    <message>
        <source>this file cannot be traced. Choose a scan.</source>
        <comment>trace.no-scan</comment>
        <translation>无法提取此文件。请选择扫描。</translation>
    </message>
    <message>
        <source>unsupported file type. AngioPose reads cases (.angiopose), centerlines (VTP, VTK, CSV, SWC, .mrk.json), scans and segmentations (DICOM, NIfTI, NRRD, MetaImage), surfaces (STL, PLY, OBJ), angiograms (DICOM, PNG, TIFF, JPEG) and poses (.json, .tfm).</source>
        <comment>info.unknown</comment>
        <translation>不支持的文件类型。AngioPose 可读取病例（.angiopose）、中心线（VTP、VTK、CSV、SWC、.mrk.json）、扫描和分割（DICOM、NIfTI、NRRD、MetaImage）、表面（STL、PLY、OBJ）、血管造影（DICOM、PNG、TIFF、JPEG）以及位姿（.json、.tfm）。</translation>
    </message>
    <message>
        <source>this is %1, which AngioPose does not read. AngioPose reads cases (.angiopose), centerlines (VTP, VTK, CSV, SWC, .mrk.json), scans and segmentations (DICOM, NIfTI, NRRD, MetaImage), surfaces (STL, PLY, OBJ), angiograms (DICOM, PNG, TIFF, JPEG) and poses (.json, .tfm).</source>
        <comment>info.other</comment>
        <translation>这是%1，AngioPose 不能读取。可读取病例（.angiopose）、中心线（VTP、VTK、CSV、SWC、.mrk.json）、扫描和分割（DICOM、NIfTI、NRRD、MetaImage）、表面（STL、PLY、OBJ）、血管造影（DICOM、PNG、TIFF、JPEG）以及位姿（.json、.tfm）。</translation>
    </message>
    <message>
        <source>Not enough memory. Close other programs, or use smaller inputs.</source>
        <comment>run.not-enough-memory</comment>
        <translation>内存不足。请关闭其他程序或使用较小的数据。</translation>
    </message>
    <message>
        <source>A software library reported an error: %1. Check the inputs.</source>
        <comment>run.library-gave-up</comment>
        <translation>某个库报告错误：%1。请检查输入。</translation>
    </message>
    <message>
        <source>The registration was stopped before it began.</source>
        <comment>run.stopped-before</comment>
        <translation>配准在开始前已停止。</translation>
    </message>
    <message>
        <source>There is nothing to show yet.</source>
        <comment>run.not-shown</comment>
        <translation>还没有可显示的内容。</translation>
    </message>
    <message>
        <source>The scan does not cover the vessels. Show the whole scan, or open the scan that contains them.</source>
        <comment>scan.beside-vessels</comment>
        <translation>扫描未覆盖血管。请显示整个扫描，或打开包含血管的扫描。</translation>
    </message>
    <message>
        <source>An overlay requires a vessel tree and an angiogram. Open both first.</source>
        <comment>picture.overlay-incomplete</comment>
        <translation>叠加图需要血管树和造影图像。请先打开两者。</translation>
    </message>
    <message>
        <source>Exporting an image requires a vessel tree and an angiogram. Open both first.</source>
        <comment>picture.incomplete</comment>
        <translation>导出图像需要血管树和造影图像。请先打开两者。</translation>
    </message>
    <message>
        <source>stopped; objects already received in full are kept.</source>
        <comment>archive.stopped</comment>
        <translation>已停止；已完整收到的对象予以保留。</translation>
    </message>
    <message>
        <source>host %1 is unknown. Check the host name in the PACS list and the network connection.</source>
        <comment>archive.unknown-host</comment>
        <translation>主机 %1 未知。请检查 PACS 列表中的名称和网络。</translation>
    </message>
    <message>
        <source>%1 cannot be reached (%2). Check the host, the port and the network connection, and check that the PACS is running.</source>
        <comment>archive.no-connection</comment>
        <translation>无法连接 %1（%2）。请检查主机、端口和网络，以及 PACS 是否在运行。</translation>
    </message>
    <message>
        <source>%1 accepted the connection but did not answer within %2. Check that the port belongs to a PACS.</source>
        <comment>archive.silent</comment>
        <translation>%1 接受了连接，但在 %2 内没有应答。请检查该端口是否属于 PACS。</translation>
    </message>
    <message>
        <source>no response within %1. Try again later, or increase the response timeout of this PACS; objects already received in full are kept.</source>
        <comment>archive.no-answer</comment>
        <translation>在 %1 内没有应答。请稍后再试，或延长该 PACS 的响应超时；已完整收到的对象予以保留。</translation>
    </message>
    <message>
        <source>the connection was lost (%1). Try again; objects already received in full are kept.</source>
        <comment>archive.broken</comment>
        <translation>连接中断（%1）。请再试一次；已完整收到的对象予以保留。</translation>
    </message>
    <message>
        <source>%2 does not recognize the called AE title %1. Correct the AE title of this PACS in the PACS list.</source>
        <comment>archive.unknown-title</comment>
        <translation>%2 不识别被叫方 AE 标题 %1。请在 PACS 列表中更正该 PACS 的 AE 标题。</translation>
    </message>
    <message>
        <source>the PACS does not recognize our calling AE title %1. Have it registered there, or correct it in the PACS list.</source>
        <comment>archive.title-not-allowed</comment>
        <translation>PACS 不识别我方呼叫方 AE 标题 %1。请在对方登记，或在 PACS 列表中更正。</translation>
    </message>
    <message>
        <source>the association was rejected (%1). Ask the PACS administrator whether this computer may connect.</source>
        <comment>archive.refused</comment>
        <translation>关联被拒绝（%1）。请询问 PACS 管理员本机是否可以连接。</translation>
    </message>
    <message>
        <source>the PACS aborted the association. Check its log, or try again; objects already received in full are kept.</source>
        <comment>archive.aborted</comment>
        <translation>PACS 中止了关联。请查看其日志，或再试一次；已完整收到的对象予以保留。</translation>
    </message>
    <message>
        <source>the PACS does not offer the requested service (%1). Ask its administrator to enable it for our AE title %2.</source>
        <comment>archive.no-service</comment>
        <translation>PACS 不提供 %1。请管理员为我方 AE 标题 %2 开放。</translation>
    </message>
    <message>
        <source>%1 failed with %2. Check the PACS log, or ask the PACS administrator.</source>
        <comment>archive.status</comment>
        <translation>%1 失败：%2。请查看 PACS 日志，或询问管理员。</translation>
    </message>
    <message>
        <source>the response is invalid (%1). Check that the host, port and address belong to a PACS.</source>
        <comment>archive.nonsense</comment>
        <translation>应答无效（%1）。请检查主机、端口和地址是否属于 PACS。</translation>
    </message>
    <message>
        <source>the TLS handshake failed (%1). Check the CA file of this PACS and the certificates, and check whether this port uses TLS.</source>
        <comment>archive.tls-refused</comment>
        <translation>TLS 握手失败（%1）。请检查该 PACS 的 CA 文件、证书，以及该端口是否使用 TLS。</translation>
    </message>
    <message>
        <source>the file %1 cannot be used for TLS (%2). Check its path and contents.</source>
        <comment>archive.tls-file</comment>
        <translation>文件 %1 不能用于 TLS（%2）。请检查其路径和内容。</translation>
    </message>
    <message>
        <source>the certificate was not issued for host %1. Check the host; if it is correct, turn off the host name check for this PACS.</source>
        <comment>archive.tls-host</comment>
        <translation>证书不是为主机 %1 签发的。请检查主机；如无误，请为该 PACS 关闭主机名校验。</translation>
    </message>
    <message>
        <source>this is not a PACS list (%1). Correct or delete the file.</source>
        <comment>archive.list-invalid</comment>
        <translation>这不是 PACS 列表（%1）。请更正或删除该文件。</translation>
    </message>
    <message>
        <source>the PACS %1 is not listed in %2; available: %3. Add the PACS, or correct the name.</source>
        <comment>archive.unknown</comment>
        <translation>%2 中没有 PACS %1；已知：%3。请添加，或更正名称。</translation>
    </message>
    <message>
        <source>a PACS has no valid name. Enter a name of 1 to 64 characters.</source>
        <comment>archive.no-name</comment>
        <translation>有 PACS 缺少有效名称。请输入 1 至 64 个字符。</translation>
    </message>
    <message>
        <source>the PACS has neither a host nor a DICOMweb address. Enter one of them.</source>
        <comment>archive.no-address</comment>
        <translation>该 PACS 既没有主机也没有 DICOMweb 地址。请输入其一。</translation>
    </message>
    <message>
        <source>%1 is not a valid host. Enter a host name or IP address without port or spaces.</source>
        <comment>archive.bad-host</comment>
        <translation>%1 不是有效的主机。请输入不含端口和空格的主机名或 IP 地址。</translation>
    </message>
    <message>
        <source>port %1 is invalid. Enter a number from 1 to 65535.</source>
        <comment>archive.bad-port</comment>
        <translation>端口 %1 无效。请输入 1 至 65535 之间的数。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a valid AE title. Enter 1 to 16 letters, digits or symbols except the backslash.</source>
        <comment>archive.bad-title</comment>
        <translation>“%1”不是有效的 AE 标题。请输入 1 至 16 个字母、数字或除反斜杠外的符号。</translation>
    </message>
    <message>
        <source>%1 is not a DICOMweb address. Enter one that begins with https:// or http://.</source>
        <comment>archive.bad-url</comment>
        <translation>%1 不是 DICOMweb 地址。请输入以 https:// 或 http:// 开头的地址。</translation>
    </message>
    <message>
        <source>the response timeout is invalid. Enter a value from 1 to 600 s.</source>
        <comment>archive.bad-time</comment>
        <translation>响应超时无效。请输入 1 至 600 秒。</translation>
    </message>
    <message>
        <source>a client certificate and its private key must be specified together; one of them is missing. Specify both files.</source>
        <comment>archive.key-without-certificate</comment>
        <translation>客户端证书和私钥须成对提供，现缺其一。请指定两个文件。</translation>
    </message>
    <message>
        <source>the PACS has only a DICOMweb address. Enter a host and port as well, or use DICOMweb.</source>
        <comment>archive.no-dimse</comment>
        <translation>该 PACS 只有 DICOMweb 地址。请同时输入主机和端口，或使用 DICOMweb。</translation>
    </message>
    <message>
        <source>the PACS has no DICOMweb address. Enter one, or use DIMSE.</source>
        <comment>archive.no-web</comment>
        <translation>该 PACS 没有 DICOMweb 地址。请输入一个，或使用 DIMSE。</translation>
    </message>
    <message>
        <source>names and images are sent to %1 unencrypted. On a shared network, use TLS or https://.</source>
        <comment>archive.plain-text</comment>
        <translation>姓名和图像未加密地发往 %1。在共用网络上请使用 https:// 或 TLS。</translation>
    </message>
    <message>
        <source>%1 is not a date. Enter YYYY-MM-DD, or a range such as 2024-01-01..2024-02-01.</source>
        <comment>archive.bad-date</comment>
        <translation>%1 不是日期。请写成 YYYY-MM-DD，或日期范围：2024-01-01..2024-02-01。</translation>
    </message>
    <message>
        <source>there are more than %1 matches; the others are omitted. Narrow the query.</source>
        <comment>archive.many-matches</comment>
        <translation>匹配项多于 %1 个；其余略去。请缩小查询范围。</translation>
    </message>
    <message>
        <source>the PACS has no data for %1. Repeat the query.</source>
        <comment>archive.nothing-there</comment>
        <translation>PACS 中没有 %1 的数据。请重新查询。</translation>
    </message>
    <message>
        <source>%1 is not a UID. Copy it from the output of `find`.</source>
        <comment>archive.bad-uid</comment>
        <translation>%1 不是 UID。请从 `find` 的输出中复制。</translation>
    </message>
    <message>
        <source>%1 of %2 objects were received; the PACS did not send the others (%3). Retrieve them again, or check the PACS log.</source>
        <comment>archive.not-all-came</comment>
        <translation>%2 个对象中收到 %1 个，其余 PACS 没有发送（%3）。请再次获取，或查看其日志。</translation>
    </message>
    <message>
        <source>the PACS does not offer C-GET, and C-MOVE requires a local port. Set the C-MOVE port, and have the AE title, host and port of this computer registered at the PACS.</source>
        <comment>archive.no-way-back</comment>
        <translation>PACS 不提供 C-GET，而 C-MOVE 需要本地端口。请设置 C-MOVE 端口，并在 PACS 登记 AE 标题、主机和端口。</translation>
    </message>
    <message>
        <source>cannot listen on port %1 (%2). Choose another port above 1024.</source>
        <comment>archive.port-taken</comment>
        <translation>无法监听端口 %1（%2）。请选择 1024 以上的其他端口。</translation>
    </message>
    <message>
        <source>an object exceeds the limit of %1 and was discarded. Raise the limit (--max-object) if you need this object.</source>
        <comment>archive.object-too-large</comment>
        <translation>有对象超过上限 %1，已丢弃。如有需要请提高上限（--max-object）。</translation>
    </message>
    <message>
        <source>a received object is not readable DICOM and was discarded. Check the PACS log.</source>
        <comment>archive.object-unreadable</comment>
        <translation>收到的一个对象不是可读的 DICOM，已丢弃。请查看 PACS 日志。</translation>
    </message>
    <message>
        <source>a received object does not match the announced one (%1) and was discarded. Check the PACS log.</source>
        <comment>archive.object-foreign</comment>
        <translation>收到的一个对象与所通知的不符（%1），已丢弃。请查看 PACS 日志。</translation>
    </message>
    <message>
        <source>a received object has the same UID (%1) as a different local object; the local one is kept. Determine which one is correct.</source>
        <comment>archive.object-differs</comment>
        <translation>收到的对象与本地另一对象的 UID（%1）相同；保留本地对象。请查明哪个正确。</translation>
    </message>
    <message>
        <source>the series does not fit into the cache (limit %1). Raise the limit, or empty the cache.</source>
        <comment>archive.cache-too-small</comment>
        <translation>该序列放不进 %1 的缓存。请提高上限，或清空缓存。</translation>
    </message>
    <message>
        <source>the folder cannot be created or used (%1). Choose another folder, or free disk space.</source>
        <comment>archive.no-folder</comment>
        <translation>无法创建或使用该文件夹（%1）。请选择其他文件夹，或释放磁盘空间。</translation>
    </message>
    <message>
        <source>this is not a complete DICOM file with a specified transfer syntax, so it was not sent. Export it again, or choose another file.</source>
        <comment>archive.not-sendable</comment>
        <translation>这不是带有传输语法的完整 DICOM 文件，未发送。请重新写出，或选择其他文件。</translation>
    </message>
    <message>
        <source>the PACS does not accept this SOP class in the stored transfer syntax (class %1, transfer syntax %2). Convert the object, or ask the PACS administrator.</source>
        <comment>archive.not-taken</comment>
        <translation>PACS 不接受以所存传输语法发送的此 SOP 类（类 %1，传输语法 %2）。请转换该对象，或询问 PACS 管理员。</translation>
    </message>
    <message>
        <source>the PACS rejected the object with %1. Check the PACS log, or ask the PACS administrator.</source>
        <comment>archive.store-refused</comment>
        <translation>PACS 以 %1 拒绝了该对象。请查看其日志，或询问管理员。</translation>
    </message>
    <message>
        <source>%1 returned HTTP status %2. Check the DICOMweb address, or ask the PACS administrator.</source>
        <comment>archive.http-status</comment>
        <translation>%1 返回 HTTP 状态 %2。请检查 DICOMweb 地址，或询问 PACS 管理员。</translation>
    </message>
    <message>
        <source>access was denied (HTTP status %1). Check the client certificate or the authorization file of this PACS.</source>
        <comment>archive.http-forbidden</comment>
        <translation>访问被拒绝（HTTP 状态 %1）。请检查该 PACS 的客户端证书或授权文件。</translation>
    </message>
    <message>
        <source>the response is larger than %1. Narrow the query.</source>
        <comment>archive.http-too-large</comment>
        <translation>应答大于 %1。请缩小查询范围。</translation>
    </message>
    <message>
        <source>%1 (AE title %2) was rejected: it is not in the list of allowed calling AE titles.</source>
        <comment>archive.title-turned-away</comment>
        <translation>%1（AE 标题 %2）被拒绝：不在允许的呼叫方 AE 标题列表中。</translation>
    </message>
    <message>
        <source>%1 (AE title %2) was rejected: its called AE title %3 is not ours. Correct the title at the sender.</source>
        <comment>archive.called-otherwise</comment>
        <translation>%1（AE 标题 %2）被拒绝：被叫方 AE 标题 %3 不是我方的。请在发送方更正。</translation>
    </message>
    <message>
        <source>an incoming connection failed (%1). Check the address, port and TLS settings at the sender.</source>
        <comment>archive.call-failed</comment>
        <translation>一个传入连接失败（%1）。请检查发送方：地址、端口、TLS。</translation>
    </message>
    <message>
        <source>an incoming connection was rejected: the TLS handshake failed (%1). Check the sender&apos;s certificate and the certificates accepted here, and check whether the sender uses TLS.</source>
        <comment>archive.call-not-secured</comment>
        <translation>一个传入连接被拒绝：TLS 握手失败（%1）。请检查发送方证书、此处接受的证书，以及发送方是否使用 TLS。</translation>
    </message>
    <message>
        <source>TLS on a listening port requires a local certificate and its private key. Specify both files.</source>
        <comment>archive.port-unsecured</comment>
        <translation>监听端口上的 TLS 需要本地证书及其私钥。请指定两个文件。</translation>
    </message>
    <message>
        <source>%1 does not exist. Check the name, and check whether the drive is mounted.</source>
        <comment>open.missing</comment>
        <translation>%1 不存在。请检查名称或驱动器是否挂载。</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2. Check its permissions.</source>
        <comment>open.unreadable</comment>
        <translation>无法读取 %1：%2。请检查权限。</translation>
    </message>
    <message>
        <source>%1 is empty. Copy the file again from its source.</source>
        <comment>open.empty</comment>
        <translation>%1 为空。请从来源重新复制。</translation>
    </message>
    <message>
        <source>Unsupported file type: %1. Open a case (.angiopose), a centerline (VTP, VTK, CSV, SWC), a CT scan (DICOM folder, NIfTI, NRRD, MetaImage), a surface (STL, PLY, OBJ) or an angiogram (DICOM, PNG, TIFF).</source>
        <comment>open.unknown</comment>
        <translation>不支持的文件类型：%1。请打开病例（.angiopose）、中心线（VTP、VTK、CSV、SWC）、CT 扫描（DICOM 文件夹、NIfTI、NRRD、MetaImage）、表面（STL、PLY、OBJ）或造影图像（DICOM、PNG、TIFF）。</translation>
    </message>
    <message>
        <source>%1 is a case. Open it on its own, without other files.</source>
        <comment>open.case-alone</comment>
        <translation>%1 是病例。请单独打开，不要与其他文件一起。</translation>
    </message>
    <message>
        <source>%1 is a second vessel tree. Open one vessel tree at a time.</source>
        <comment>open.second-tree</comment>
        <translation>%1 是第二个血管树。一次只能打开一个血管树。</translation>
    </message>
    <message>
        <source>%1 is a second 2-D centerline. Open one 2-D centerline at a time.</source>
        <comment>open.second-centreline</comment>
        <translation>%1 是第二条二维中心线。一次只能打开一条二维中心线。</translation>
    </message>
    <message>
        <source>%1 is a second angiogram. Open one angiogram at a time; add others as views.</source>
        <comment>open.second-angiogram</comment>
        <translation>%1 是第二个血管造影。一次只能打开一个；其余的请作为视图添加。</translation>
    </message>
    <message>
        <source>%1 is no longer at its saved path; it was found at %2. Save the case to keep the new path.</source>
        <comment>open.moved</comment>
        <translation>%1 已移动，在 %2 找到。请保存病例以记录新路径。</translation>
    </message>
    <message>
        <source>this is not an angiogram. Choose an XA image, or a case that contains one.</source>
        <comment>open.no-angiogram</comment>
        <translation>这不是血管造影。请选择 XA 图像，或含有血管造影的病例。</translation>
    </message>
    <message>
        <source>none of the %1 series can be opened. %2</source>
        <comment>open.no-series</comment>
        <translation>%1 个序列都无法打开。%2</translation>
    </message>
    <message>
        <source>Not for clinical use</source>
        <comment>picture.not-for-clinical-use</comment>
        <translation>不得用于临床</translation>
    </message>
    <message>
        <source>identity hidden</source>
        <comment>picture.identity-hidden</comment>
        <translation>患者信息已隐藏</translation>
    </message>
    <message>
        <source>before: initial pose</source>
        <comment>picture.before</comment>
        <translation>之前：初始位姿</translation>
    </message>
    <message>
        <source>after: this pose</source>
        <comment>picture.after</comment>
        <translation>之后：此位姿</translation>
    </message>
    <message>
        <source>%1 · median %2</source>
        <comment>picture.pose</comment>
        <translation>%1 · 中位数 %2</translation>
    </message>
    <message>
        <source>%1 · median %2 · not reliable</source>
        <comment>picture.pose-not-trustworthy</comment>
        <translation>%1 · 中位数 %2 · 不可靠</translation>
    </message>
    <message>
        <source>displacement (mm)</source>
        <comment>picture.motion-scale</comment>
        <translation>位移（mm）</translation>
    </message>
    <message>
        <source>deformation from frame %1, not from this frame</source>
        <comment>picture.bent-on-frame</comment>
        <translation>形变取自第 %1 帧，而非此帧</translation>
    </message>
    <message>
        <source>deformation in depth: unknown</source>
        <comment>picture.bent-depth-untold</comment>
        <translation>深度方向的形变：未知</translation>
    </message>
    <message>
        <source>rigid: %1</source>
        <comment>picture.of-rigid-vessels</comment>
        <translation>刚性：%1</translation>
    </message>
    <message>
        <source>vessels shown without deformation; deformation available</source>
        <comment>picture.vessels-rigid</comment>
        <translation>显示未形变的血管；有形变结果</translation>
    </message>
    <message>
        <source>vessels deformed by up to %1 (uncertain)</source>
        <comment>picture.vessels-bent-unsure</comment>
        <translation>血管形变最大 %1，不确定</translation>
    </message>
    <message>
        <source>vessels deformed by up to %1</source>
        <comment>picture.vessels-bent</comment>
        <translation>血管形变最大 %1</translation>
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
        <translation>探测器 %1（%2）</translation>
    </message>
    <message>
        <source>%1 at the vessels</source>
        <comment>picture.scale-at-vessels</comment>
        <translation>血管处 %1</translation>
    </message>
    <message>
        <source>header</source>
        <comment>origin.header</comment>
        <translation>文件头</translation>
    </message>
    <message>
        <source>derived</source>
        <comment>origin.derived</comment>
        <translation>推算</translation>
    </message>
    <message>
        <source>entered</source>
        <comment>origin.user</comment>
        <translation>手动输入</translation>
    </message>
    <message>
        <source>assumed</source>
        <comment>origin.assumed</comment>
        <translation>假定</translation>
    </message>
    <message>
        <source>missing</source>
        <comment>origin.missing</comment>
        <translation>缺失</translation>
    </message>
    <message>
        <source>The %1 of the simulation must be between %2 and %3, not %4.</source>
        <comment>simulation.out-of-range</comment>
        <translation>模拟的 %1 须在 %2 至 %3 之间，不能是 %4。</translation>
    </message>
    <message>
        <source>Method &apos;%1&apos; has no option with the value &apos;%2&apos;. Specify it as option=value.</source>
        <comment>contest.no-such-choice</comment>
        <translation>方法“%1”没有可取“%2”的选项。请写成 option=value。</translation>
    </message>
    <message>
        <source>Method &apos;%1&apos; has several options with the value &apos;%2&apos;. Specify it as option=value.</source>
        <comment>contest.choice-of-several</comment>
        <translation>方法“%1”有多个可取“%2”的选项。请写成 option=value。</translation>
    </message>
    <message>
        <source>No method specified. For a list of methods, run: angiopose-cli evaluate --help</source>
        <comment>contest.no-method-named</comment>
        <translation>没有指定方法。可用方法见：angiopose-cli evaluate --help</translation>
    </message>
    <message>
        <source>The experiment &apos;%1&apos; has no condition &apos;%2&apos;. For a list of conditions, run: angiopose-cli evaluate --help</source>
        <comment>experiment.no-such-condition</comment>
        <translation>实验“%1”没有条件“%2”。可用条件见：angiopose-cli evaluate --help</translation>
    </message>
    <message>
        <source>The condition &apos;%1&apos; does not belong to &apos;%2&apos;. Merge only results of this program version.</source>
        <comment>merge.foreign-condition</comment>
        <translation>条件“%1”不属于“%2”。请只合并本程序版本的结果。</translation>
    </message>
    <message>
        <source>Two parts contain different results of method %1 in trial %2 of &apos;%3&apos;. Merge only results of the same program version and settings.</source>
        <comment>merge.parts-disagree</comment>
        <translation>两部分在“%3”的第 %2 次试验中方法 %1 的结果不一致。请只合并程序版本和设置相同的结果。</translation>
    </message>
    <message>
        <source>There are no results to merge.</source>
        <comment>merge.nothing</comment>
        <translation>没有可合并的结果。</translation>
    </message>
    <message>
        <source>The results of &apos;%1&apos; (seed %2) and &apos;%3&apos; (seed %4) do not belong together. Merge only parts of the same experiment.</source>
        <comment>merge.runs-of-others</comment>
        <translation>“%1”（种子 %2）与“%3”（种子 %4）的结果不属于同一实验。请只合并同一实验的各部分。</translation>
    </message>
    <message>
        <source>The focal lengths fx and fy must be finite and nonzero.</source>
        <comment>camera.focal-lengths</comment>
        <translation>焦距 fx 和 fy 必须有限且非零。</translation>
    </message>
    <message>
        <source>The principal point (cx, cy) must be finite.</source>
        <comment>camera.principal-point</comment>
        <translation>主点 cx、cy 必须有限。</translation>
    </message>
    <message>
        <source>The image size of the camera is invalid: width and height must be positive.</source>
        <comment>camera.image-size</comment>
        <translation>相机的图像尺寸无效：宽和高必须为正。</translation>
    </message>
    <message>
        <source>The camera belongs to images of %1 × %2 pixels, but the angiogram is %3 × %4 pixels. Use the camera that belongs to this angiogram.</source>
        <comment>camera.other-image</comment>
        <translation>相机对应 %1 × %2 像素的图像，而造影图像为 %3 × %4。请使用该造影图像对应的相机。</translation>
    </message>
    <message>
        <source>Image width and height must each be between 1 and %1 px. Choose another size.</source>
        <comment>picture.size</comment>
        <translation>图像的宽和高须为 1 至 %1 px；请选择其他尺寸。</translation>
    </message>
    <message>
        <source>%1 is missing or not positive. Enter it in the C-arm geometry; the image header does not contain it.</source>
        <comment>geometry.value-missing</comment>
        <translation>%1 缺失或不为正。请在 C 形臂几何中输入（图像头未给出）。</translation>
    </message>
    <message>
        <source>The source-to-detector distance (SID)</source>
        <comment>geometry.the-sid</comment>
        <translation>源到探测器距离（SID）</translation>
    </message>
    <message>
        <source>The source-to-isocenter distance (SOD)</source>
        <comment>geometry.the-sod</comment>
        <translation>源到等中心距离（SOD）</translation>
    </message>
    <message>
        <source>The detector pixel spacing</source>
        <comment>geometry.the-spacing</comment>
        <translation>探测器像素间距</translation>
    </message>
    <message>
        <source>The gantry angles (LAO/RAO, CRA/CAU) are missing or invalid. Enter them in the C-arm geometry.</source>
        <comment>geometry.angles-missing</comment>
        <translation>机架角度（LAO/RAO、CRA/CAU）缺失或无效。请在 C 形臂几何中输入。</translation>
    </message>
    <message>
        <source>A coordinate of the isocenter is not a finite number. Enter the position of the isocenter in patient coordinates (mm).</source>
        <comment>geometry.isocentre-not-finite</comment>
        <translation>等中心的某个坐标不是有限数。请以患者坐标（mm）输入等中心的位置。</translation>
    </message>
    <message>
        <source>Enter the source-to-detector distance (SID), typically 900 to 1200 mm.</source>
        <comment>geometry.ask-sid</comment>
        <translation>请输入源到探测器距离（SID），通常 900 至 1200 mm。</translation>
    </message>
    <message>
        <source>Enter the source-to-isocenter distance (SOD), typically 700 to 800 mm.</source>
        <comment>geometry.ask-sod</comment>
        <translation>请输入源到等中心距离（SOD），通常 700 至 800 mm。</translation>
    </message>
    <message>
        <source>Enter the detector pixel spacing, or the width of the field of view at the detector divided by the number of columns.</source>
        <comment>geometry.ask-spacing</comment>
        <translation>请输入探测器像素间距，或探测器上视野宽度除以列数所得的值。</translation>
    </message>
    <message>
        <source>Enter the LAO/RAO angle, or register from landmarks.</source>
        <comment>geometry.ask-primary-angle</comment>
        <translation>请输入 LAO/RAO 角，或按标志点配准。</translation>
    </message>
    <message>
        <source>Enter the CRA/CAU angle, or register from landmarks.</source>
        <comment>geometry.ask-secondary-angle</comment>
        <translation>请输入 CRA/CAU 角，或按标志点配准。</translation>
    </message>
    <message>
        <source>A source-to-detector distance (SID) of %1 is implausible for a C-arm (500 to 2000 mm): check the unit.</source>
        <comment>geometry.sid-unusual</comment>
        <translation>源到探测器距离（SID）%1 对 C 形臂不合理（500 至 2000 mm）：请检查单位。</translation>
    </message>
    <message>
        <source>The SOD (%1) is not smaller than the SID (%2): the isocenter would lie behind the detector. Correct one of the two distances.</source>
        <comment>geometry.sod-beyond-sid</comment>
        <translation>SOD（%1）不小于 SID（%2）：等中心将位于探测器之后。请更正其一。</translation>
    </message>
    <message>
        <source>The SID is %1 times the SOD, but the typical angiographic magnification is 1.0 to 2.5. Check both distances.</source>
        <comment>geometry.magnification-unusual</comment>
        <translation>SID 为 SOD 的 %1 倍；血管造影的放大率通常为 1.0 至 2.5。请检查两个距离。</translation>
    </message>
    <message>
        <source>The magnification in the header (0018,1114) is %1, which does not match SID/SOD = %2: one of the three values is outdated. Check the SID and the SOD.</source>
        <comment>geometry.magnification-stale</comment>
        <translation>文件头中的放大倍数 %1 (0018,1114) 与 SID/SOD = %2 不符：三者之一已过时。请检查 SID 和 SOD。</translation>
    </message>
    <message>
        <source>The detector pixel spacing of %1 is outside the range of 0.05 to 2 mm: check its unit.</source>
        <comment>geometry.spacing-unusual</comment>
        <translation>探测器像素间距 %1 不在 0.05 至 2 mm 之间：请检查单位。</translation>
    </message>
    <message>
        <source>The ratio of pixel height to width is %1 according to the pixel spacing, but %2 according to the pixel aspect ratio: check the pixel spacing.</source>
        <comment>geometry.aspect-differs</comment>
        <translation>像素高宽比按间距为 %1，按像素长宽比为 %2：请检查像素间距。</translation>
    </message>
    <message>
        <source>According to its pixel spacing, the image covers %1 × %2 of the detector</source>
        <comment>geometry.image-covers</comment>
        <translation>按像素间距图像覆盖探测器 %1 × %2</translation>
    </message>
    <message>
        <source>%1: no C-arm detector has this size. Check the pixel spacing.</source>
        <comment>geometry.extent-unlike-detector</comment>
        <translation>%1：没有这种尺寸的 C 形臂探测器。请检查像素间距。</translation>
    </message>
    <message>
        <source>%1, but the field of view is %2 × %3: the image may have been zoomed, cropped or resampled. Check the pixel spacing.</source>
        <comment>geometry.extent-unlike-field</comment>
        <translation>%1，而视野为 %2 × %3：图像可能经过缩放、裁剪或重采样。请检查像素间距。</translation>
    </message>
    <message>
        <source>%1, which exceeds the diameter of the image intensifier (%2). Check the pixel spacing.</source>
        <comment>geometry.extent-beyond-intensifier</comment>
        <translation>%1，超过 %2 的影像增强器。请检查像素间距。</translation>
    </message>
    <message>
        <source>%1, which exceeds the active area of the detector (%2 × %3). Check the pixel spacing.</source>
        <comment>geometry.extent-beyond-detector</comment>
        <translation>%1，超过其有效面积 %2 × %3。请检查像素间距。</translation>
    </message>
    <message>
        <source>The calibrated pixel spacing (%1) multiplied by SID/SOD is %2, but the detector pixel spacing is %3: the calibration or one of the distances is wrong.</source>
        <comment>geometry.calibration-off</comment>
        <translation>校准像素间距 %1 乘以 SID/SOD 为 %2，而非探测器的 %3：校准或距离有误。</translation>
    </message>
    <message>
        <source>The uncalibrated Pixel Spacing (0028,0030) is %1, but the detector pixel spacing is %2: check which one applies.</source>
        <comment>geometry.spacings-differ</comment>
        <translation>Pixel Spacing (0028,0030) 未校准为 %1，而探测器像素间距为 %2：请核对应采用哪个。</translation>
    </message>
    <message>
        <source>The primary angle (LAO/RAO) is outside ±180°. Correct it.</source>
        <comment>geometry.primary-angle-outside</comment>
        <translation>主角度（LAO/RAO）超出 ±180°。请更正。</translation>
    </message>
    <message>
        <source>The secondary angle (CRA/CAU) is outside ±90°. Correct it.</source>
        <comment>geometry.secondary-angle-outside</comment>
        <translation>次角度（CRA/CAU）超出 ±90°。请更正。</translation>
    </message>
    <message>
        <source>The roll is outside ±180°. Correct it.</source>
        <comment>geometry.roll-outside</comment>
        <translation>滚转超出 ±180°。请更正。</translation>
    </message>
    <message>
        <source>The principal point (%1, %2) is outside the image, which is plausible only if the image was cropped.</source>
        <comment>geometry.principal-point-outside</comment>
        <translation>主点（%1，%2）在图像之外：仅对裁剪过的图像正确。</translation>
    </message>
    <message>
        <source>Two of the angiograms appear to belong to different patients (%1 differs). Check that the correct files are open.</source>
        <comment>patient.of-runs-differs</comment>
        <translation>其中两个血管造影似乎来自不同患者（%1不同）。请检查是否正确。</translation>
    </message>
    <message>
        <source>Two of the angiograms appear to belong to different patients (%1 differ). Check that the correct files are open.</source>
        <comment>patient.of-runs-differs-in-several</comment>
        <translation>其中两个血管造影似乎来自不同患者（%1不同）。请检查是否正确。</translation>
    </message>
    <message>
        <source>Two of the angiograms show opposite sides of the patient. Check that the correct files are open.</source>
        <comment>patient.side-of-runs-differs</comment>
        <translation>其中两个血管造影显示患者相反的两侧。请检查是否正确。</translation>
    </message>
    <message>
        <source>The registration rated this pose as unreliable.</source>
        <comment>pose.run-distrusted</comment>
        <translation>配准将此位姿评为不可靠。</translation>
    </message>
    <message>
        <source>Images may be from different patients</source>
        <comment>picture.not-same-patient</comment>
        <translation>图像可能来自不同患者</translation>
    </message>
    <message>
        <source>Two of the angiograms are from different examinations (different accession numbers): the vessels may have moved between them.</source>
        <comment>patient.examination-of-runs-differs</comment>
        <translation>两幅造影图像来自不同的检查（检查号不同）：其间血管可能已移动。</translation>
    </message>
    <message>
        <source>Images may not belong together</source>
        <comment>picture.not-together</comment>
        <translation>图像可能不属于同一检查</translation>
    </message>
    <message>
        <source>The scan and the angiogram appear to belong to different patients (%1 differs). Check that the correct files are open.</source>
        <comment>patient.differs</comment>
        <translation>扫描与血管造影似乎来自不同患者（%1不同）。请检查两者是否正确。</translation>
    </message>
    <message>
        <source>The scan and the angiogram appear to belong to different patients (%1 differ). Check that the correct files are open.</source>
        <comment>patient.differs-in-several</comment>
        <translation>扫描与血管造影似乎来自不同患者（%1不同）。请检查两者是否正确。</translation>
    </message>
    <message>
        <source>patient ID</source>
        <comment>patient.number</comment>
        <translation>患者编号</translation>
    </message>
    <message>
        <source>name</source>
        <comment>patient.name</comment>
        <translation>姓名</translation>
    </message>
    <message>
        <source>birth date</source>
        <comment>patient.birth-date</comment>
        <translation>出生日期</translation>
    </message>
    <message>
        <source>sex</source>
        <comment>patient.sex</comment>
        <translation>性别</translation>
    </message>
    <message>
        <source>The scan shows the patient&apos;s %1 side, but the angiogram shows the other side. Check that the correct files are open.</source>
        <comment>patient.side-differs</comment>
        <translation>扫描为患者%1侧，造影图像为另一侧。请核对两者是否正确。</translation>
    </message>
    <message>
        <source>left</source>
        <comment>patient.side-left</comment>
        <translation>左</translation>
    </message>
    <message>
        <source>right</source>
        <comment>patient.side-right</comment>
        <translation>右</translation>
    </message>
    <message>
        <source>There is no angiogram yet. Open an image first.</source>
        <comment>case.no-angiogram</comment>
        <translation>尚无造影图像。请先打开图像。</translation>
    </message>
    <message>
        <source>There is no vessel tree yet. Open a centerline first.</source>
        <comment>case.no-vessel-tree</comment>
        <translation>尚无血管树。请先打开中心线。</translation>
    </message>
    <message>
        <source>All six degrees of freedom are locked: there is nothing to optimize. Unlock at least one.</source>
        <comment>options.all-locked</comment>
        <translation>六个自由度均已锁定：没有可优化的参数。请至少解锁一个。</translation>
    </message>
    <message>
        <source>%1 solves for all six degrees of freedom at once and cannot lock any. Unlock them, or choose another method.</source>
        <comment>options.method-cannot-lock</comment>
        <translation>%1 同时求解全部六个自由度，无法锁定其中任何一个。请解锁或选择其他方法。</translation>
    </message>
    <message>
        <source>There is no method &apos;%1&apos;. Choose one of: %2.</source>
        <comment>options.no-such-method</comment>
        <translation>没有方法“%1”。可选：%2。</translation>
    </message>
    <message>
        <source>Option %1 is out of range. Enter a number from %2 to %3.</source>
        <comment>options.out-of-range</comment>
        <translation>选项 %1 超出范围。请输入 %2 至 %3 之间的数。</translation>
    </message>
    <message>
        <source>Option &apos;%1&apos; requires a value, not &apos;%2&apos;.</source>
        <comment>options.needs-value</comment>
        <translation>选项“%1”需要一个值，而不是“%2”。</translation>
    </message>
    <message>
        <source>Option &apos;%1&apos; must be one of %2, not &apos;%3&apos;.</source>
        <comment>options.needs-choice</comment>
        <translation>选项“%1”须为 %2 之一，不能是“%3”。</translation>
    </message>
    <message>
        <source>Option &apos;%1&apos; must be an integer, not %2.</source>
        <comment>options.needs-whole-number</comment>
        <translation>选项“%1”须为整数，而不是 %2。</translation>
    </message>
    <message>
        <source>Option &apos;%1&apos; must be between %2 and %3, not %4.</source>
        <comment>options.value-out-of-range</comment>
        <translation>选项“%1”须在 %2 与 %3 之间，而不是 %4。</translation>
    </message>
    <message>
        <source>Unknown option &apos;%1&apos;. For a list of options, run: angiopose-cli register --help</source>
        <comment>options.no-such-option</comment>
        <translation>选项“%1”未知。可用选项见：angiopose-cli register --help</translation>
    </message>
    <message>
        <source>Branch %1 is selected as %2, but does not exist in the vessel tree. Select an existing branch.</source>
        <comment>input.chosen-branch-missing</comment>
        <translation>分支 %1 被选为%2，但血管树中没有该分支。请在现有分支中选择。</translation>
    </message>
    <message>
        <source>auxiliary</source>
        <comment>input.role-auxiliary</comment>
        <translation>辅助分支</translation>
    </message>
    <message>
        <source>excluded</source>
        <comment>input.role-excluded</comment>
        <translation>排除</translation>
    </message>
    <message>
        <source>All branches of the vessel tree are excluded. Include at least one branch.</source>
        <comment>input.all-branches-excluded</comment>
        <translation>血管树的所有分支均已排除。请至少恢复一个。</translation>
    </message>
    <message>
        <source>The image size does not match the camera. Use the camera that belongs to this image.</source>
        <comment>input.image-not-of-camera</comment>
        <translation>图像尺寸与相机不符。请使用该图像对应的相机。</translation>
    </message>
    <message>
        <source>Unordered points of the traced vessels were connected to their neighbors (number of points: %1).</source>
        <comment>input.target-reordered</comment>
        <translation>提取血管的 %1 个点没有顺序：每个点已与其相邻点相连。</translation>
    </message>
    <message>
        <source>Auxiliary branches: median distance to the traced vessels %1 (%2 in the fit of all branches). The pose changed by %3 and %4.</source>
        <comment>result.chosen-branches-fitted</comment>
        <translation>辅助分支：与提取血管距离的中位数 %1（拟合全部分支时为 %2）。位姿变化 %3、%4。</translation>
    </message>
    <message>
        <source>With deformation allowed, the vessels move toward the matched branches by %1 (RMS; maximum %2), which changes the median distance from %4 (rigid pose) to %3. The rigid pose is reported.</source>
        <comment>result.matched-branches-moved</comment>
        <translation>若允许形变，血管向匹配的分支移动 %1（RMS；最大 %2）：距离中位数变为 %3，刚性位姿时为 %4。所报告的是刚性位姿。</translation>
    </message>
    <message>
        <source>The initial pose is not a rigid transform: its rotation must be orthonormal with determinant +1, and all values must be finite. Correct cameraFromPatient, or derive the initial pose from the angles.</source>
        <comment>input.start-pose-not-rigid</comment>
        <translation>初始位姿不是刚体变换：旋转须正交且行列式为 +1，所有数须有限。请更正 cameraFromPatient，或由角度推导初始位姿。</translation>
    </message>
    <message>
        <source>The initial pose places vessels at or behind the X-ray source, where they cannot be projected. Check the source-to-isocenter distance and the direction of the initial pose.</source>
        <comment>input.start-pose-behind-source</comment>
        <translation>初始位姿使血管位于 X 射线源处或其后方，无法投影。请检查源到等中心距离和初始位姿的方向。</translation>
    </message>
    <message>
        <source>The pose to evaluate is not a rigid transform: its rotation must be orthonormal with determinant +1, and all values must be finite.</source>
        <comment>input.judged-pose-not-rigid</comment>
        <translation>待评估位姿不是刚体变换：旋转须正交且行列式为 +1，所有数有限。</translation>
    </message>
    <message>
        <source>There are no landmarks yet. Click a point on the vessels and the same point in the image.</source>
        <comment>landmarks.missing</comment>
        <translation>尚无标志点。请单击血管上的一点和图像中的同一点。</translation>
    </message>
    <message>
        <source>Without gantry angles, four landmarks are required to determine a pose; there are %1. Add landmarks, or enter the angles; one landmark is then enough.</source>
        <comment>landmarks.too-few</comment>
        <translation>没有机架角度时，位姿需要四个标志点；现有 %1 个。请添加，或输入角度：此时一个即可。</translation>
    </message>
    <message>
        <source>A landmark has a coordinate that is not a finite number. Remove it.</source>
        <comment>landmarks.not-finite</comment>
        <translation>有标志点的坐标不是有限数。请移除。</translation>
    </message>
    <message>
        <source>All landmarks are at the same position. Place them farther apart.</source>
        <comment>landmarks.in-one-place</comment>
        <translation>标志点都在同一位置。请选择相距较远的。</translation>
    </message>
    <message>
        <source>The landmarks are collinear, so the rotation about their line is undetermined. Add a landmark off that line.</source>
        <comment>landmarks.on-one-line</comment>
        <translation>标志点共线，绕该线的旋转无法确定。请添加线外一点。</translation>
    </message>
    <message>
        <source>No pose projects these landmarks onto their pixels. Check that the two points of each pair mark the same anatomical location.</source>
        <comment>landmarks.no-pose</comment>
        <translation>没有位姿能将这些标志点投影到其像素上。请检查每对是否标记同一点。</translation>
    </message>
    <message>
        <source>View %1: %2</source>
        <comment>views.in-view</comment>
        <translation>视图 %1：%2</translation>
    </message>
    <message>
        <source>A joint registration requires at least two views.</source>
        <comment>views.too-few</comment>
        <translation>联合配准至少需要两个视图。</translation>
    </message>
    <message>
        <source>A joint registration cannot lock individual degrees of freedom. Unlock them first.</source>
        <comment>views.cannot-lock</comment>
        <translation>联合配准无法锁定单个自由度。请先解锁。</translation>
    </message>
    <message>
        <source>View %1 uses a different vessel tree or different branches than view %2. Use the same tree and branches in all views.</source>
        <comment>views.other-tree</comment>
        <translation>视图 %1 使用的血管树或分支与视图 %2 不同。请在所有视图中使用相同的。</translation>
    </message>
    <message>
        <source>View %1 is inconsistent with the joint pose.</source>
        <comment>views.disagrees</comment>
        <translation>视图 %1 与联合位姿不符。</translation>
    </message>
    <message>
        <source>The geometry of view %1 differs substantially from the values in its header. Check the angles and distances.</source>
        <comment>views.far-from-header</comment>
        <translation>视图 %1 的几何参数与文件头相差很大。请检查角度和距离。</translation>
    </message>
    <message>
        <source>There is only one frame, so there is nothing to track. Open a run with several frames.</source>
        <comment>follow.one-frame</comment>
        <translation>只有一帧：无可跟踪。请打开多帧序列。</translation>
    </message>
    <message>
        <source>The centerline of this frame comes from a file, and the other frames have none. Remove this centerline from the case so that every frame is traced.</source>
        <comment>follow.given-target</comment>
        <translation>此帧的中心线来自文件，其他帧没有。请从病例中移除该中心线，以提取每一帧。</translation>
    </message>
    <message>
        <source>The gantry rotates during this run: the frames differ not only by vessel motion but also in the projection angles. Register the frames individually, or jointly as views.</source>
        <comment>follow.gantry-turns</comment>
        <translation>采集中机架旋转：各帧投照角度不同，而不仅是运动。请逐帧配准，或作为多个视图联合配准。</translation>
    </message>
    <message>
        <source>Only %1 of the vessel tree is inside the image.</source>
        <comment>trust.outside-image</comment>
        <translation>血管树仅 %1 位于图像内。</translation>
    </message>
    <message>
        <source>Only %1 of the vessel tree matches a traced vessel, and the tree accounts for %2 of the traced vessels.</source>
        <comment>trust.little-agreement</comment>
        <translation>血管树仅 %1 与提取血管匹配，解释了提取血管的 %2。</translation>
    </message>
    <message>
        <source>The vessel tree accounts for only %1 of the traced vessels. Check that it belongs to the image and that its unit is mm.</source>
        <comment>trust.little-explained</comment>
        <translation>血管树仅能解释 %1 的提取血管。请检查它是否属于该图像，且单位为 mm。</translation>
    </message>
    <message>
        <source>A better fit exists %1 away.</source>
        <comment>trust.better-aside</comment>
        <translation>相距 %1 处吻合更好。</translation>
    </message>
    <message>
        <source>The out-of-plane tilt of the vessels is poorly determined by the image.</source>
        <comment>trust.out-of-plane-uncertain</comment>
        <translation>图像几乎无法确定血管的平面外倾斜。</translation>
    </message>
    <message>
        <source>The in-plane rotation of the vessels is poorly determined by the image.</source>
        <comment>trust.in-plane-turn-uncertain</comment>
        <translation>图像几乎无法确定血管的平面内旋转。</translation>
    </message>
    <message>
        <source>The position of the tree along the vessels is poorly determined by the image.</source>
        <comment>trust.shift-uncertain</comment>
        <translation>图像几乎无法确定血管树沿血管方向的位置。</translation>
    </message>
    <message>
        <source>The pose uncertainty is about %1.</source>
        <comment>trust.pose-uncertain</comment>
        <translation>位姿不确定性约为 %1。</translation>
    </message>
    <message>
        <source>Another pose fits the image almost as well: compare the other solutions.</source>
        <comment>trust.rival</comment>
        <translation>另一位姿几乎同样符合图像：请比较其他解。</translation>
    </message>
    <message>
        <source>Only %1 of fits of this quality are within 2 mm of the vessels.</source>
        <comment>trust.often-fails</comment>
        <translation>与此相似的配准中，只有 %1 落在血管 2 mm 以内。</translation>
    </message>
    <message>
        <source>The registration was stopped before it finished.</source>
        <comment>trust.stopped</comment>
        <translation>配准在完成前被停止。</translation>
    </message>
    <message>
        <source>The image shows %1 of the vessel tree. These branches appear unopacified: %2. The pose is based on the remaining branches.</source>
        <comment>trust.part-filled</comment>
        <translation>图像显示了血管树的 %1。以下分支似乎未显影：%2。位姿依据其余分支。</translation>
    </message>
    <message>
        <source>The image shows %1 of the vessel tree: %2 of %3 branches appear unopacified. The pose is based on the remaining branches.</source>
        <comment>trust.few-filled</comment>
        <translation>图像显示了血管树的 %1：%3 个分支中有 %2 个似乎未显影。位姿依据其余分支。</translation>
    </message>
    <message>
        <source>The image shows %1 of the vessel tree and less than half of each branch. The pose is based on the visible segments.</source>
        <comment>trust.pieces-filled</comment>
        <translation>图像显示血管树的 %1，每个分支的可见部分均不足一半。位姿依据可见的节段。</translation>
    </message>
    <message>
        <source>Only part of the vessel tree appears opacified, and this part accounts for too little of the image for a reliable result.</source>
        <comment>trust.filled-doubtful</comment>
        <translation>似乎只有部分血管树显影，其对图像的解释不足以确定位姿。</translation>
    </message>
    <message>
        <source>Only a single vessel path is visible. It fits at many positions, and a guidewire or catheter does not follow the centerline exactly. The guidewire method ranks the possible paths.</source>
        <comment>trust.single-path</comment>
        <translation>只见一条血管路径。它与多处相符，而且导丝或导管并不严格沿中心线走行。导丝方法会给出各可能路径的排序。</translation>
    </message>
    <message>
        <source>Depth cannot be determined from this single view: the distance from the source stays close to that of the initial pose.</source>
        <comment>trust.depth-unknown</comment>
        <translation>此单一视图无法确定深度：到射线源的距离保持接近初始位姿。</translation>
    </message>
    <message>
        <source>Depth cannot be determined from this single view: the distance from the source differs by %1 from that of the initial pose and may be wrong. Lock the depth, or add a view.</source>
        <comment>trust.depth-moved</comment>
        <translation>此单一视图无法确定深度：到射线源的距离偏离初始位姿 %1，可能有误。请锁定深度，或增加一个视图。</translation>
    </message>
    <message>
        <source>The vessels fit clearly better with a focal length that is %1 longer. Check the source-to-detector distance (it may be larger) and the pixel spacing (it may be smaller). The option “Estimate geometry” uses the values that best fit the images.</source>
        <comment>camera.focal-longer</comment>
        <translation>焦距增大 %1 时血管明显更吻合。请检查源到探测器距离（可能更大）和像素间距（可能更小）。选项“估计几何参数”会采用与图像相符的值。</translation>
    </message>
    <message>
        <source>The vessels fit clearly better with a focal length that is %1 shorter. Check the source-to-detector distance (it may be smaller) and the pixel spacing (it may be larger). The option “Estimate geometry” uses the values that best fit the images.</source>
        <comment>camera.focal-shorter</comment>
        <translation>焦距减小 %1 时血管明显更吻合。请检查源到探测器距离（可能更小）和像素间距（可能更大）。选项“估计几何参数”会采用与图像相符的值。</translation>
    </message>
    <message>
        <source>The images contradicted the specified geometry, so the geometry was estimated from the images: the focal length is %1 of the specified value, and the principal point is shifted by (%2, %3) px.</source>
        <comment>camera.estimated</comment>
        <translation>图像与几何参数不符，已据图像重新估计：焦距为给定值的 %1，主点偏移 (%2, %3) px。</translation>
    </message>
    <message>
        <source>The vessels fit clearly better with the principal point shifted by %1, to (%2, %3). Check the principal point, and check whether the image was cropped or shifted.</source>
        <comment>camera.principal-point-off</comment>
        <translation>主点偏移 %1、位于 (%2, %3) 时血管明显更吻合。请检查主点，以及图像是否被裁剪或平移。</translation>
    </message>
    <message>
        <source>The image appears to be rotated 90° clockwise: when it is rotated back, the agreement between vessels and image is %1 instead of %2. Check the image export, or the roll.</source>
        <comment>frame.turned-clockwise</comment>
        <translation>图像似乎顺时针旋转了 90°：转回后血管与图像的吻合度为 %1，而非 %2。请检查图像导出方式或滚转角。</translation>
    </message>
    <message>
        <source>The image appears to be rotated 90° counterclockwise: when it is rotated back, the agreement between vessels and image is %1 instead of %2. Check the image export, or the roll.</source>
        <comment>frame.turned-anticlockwise</comment>
        <translation>图像似乎逆时针旋转了 90°：转回后血管与图像的吻合度为 %1，而非 %2。请检查图像导出方式或滚转角。</translation>
    </message>
    <message>
        <source>The image appears to be rotated 180°: when it is rotated back, the agreement between vessels and image is %1 instead of %2. Check the image export, the roll and the patient position.</source>
        <comment>frame.upside-down</comment>
        <translation>图像似乎旋转了 180°：转回后血管与图像的吻合度为 %1，而非 %2。请检查图像导出方式、滚转角和患者体位。</translation>
    </message>
    <message>
        <source>The image appears to be mirrored left to right: when it is mirrored back, the agreement between vessels and image is %1 instead of %2. Check the viewing side in the geometry.</source>
        <comment>frame.mirrored-left-right</comment>
        <translation>图像似乎左右镜像：镜像还原后血管与图像的吻合度为 %1，而非 %2。请在几何中检查观察侧。</translation>
    </message>
    <message>
        <source>The image appears to be mirrored top to bottom: when it is mirrored back, the agreement between vessels and image is %1 instead of %2. Check the image export.</source>
        <comment>frame.mirrored-up-down</comment>
        <translation>图像似乎上下镜像：镜像还原后血管与图像的吻合度为 %1，而非 %2。请检查图像导出方式。</translation>
    </message>
    <message>
        <source>The image appears to be mirrored and rotated 90°: when both are undone, the agreement between vessels and image is %1 instead of %2. Check the image export.</source>
        <comment>frame.mirrored-and-turned</comment>
        <translation>图像似乎既镜像又旋转了 90°：校正后血管与图像的吻合度为 %1，而非 %2。请检查图像导出方式。</translation>
    </message>
    <message>
        <source>The patient position was %1, and the device appears to define its angles relative to the table: with this interpretation, the agreement between vessels and image is %2 instead of %3. Enter these angles in the geometry: LAO/RAO %4, CRA/CAU %5, roll %6.</source>
        <comment>frame.counted-from-table</comment>
        <translation>患者体位为 %1，该设备似乎以检查床为基准计角：按此理解，血管与图像的吻合度为 %2，而非 %3。请在几何中输入：LAO/RAO %4，CRA/CAU %5，滚转 %6。</translation>
    </message>
    <message>
        <source>The mirrored image fits the vessels about equally well (agreement %1; currently %2): check the viewing side in the geometry.</source>
        <comment>frame.mirror-rival</comment>
        <translation>镜像后的图像与血管几乎同样吻合（吻合度 %1，当前为 %2）：请检查图像的观察侧。</translation>
    </message>
    <message>
        <source>The patient position is %1 (0018,5100), not head-first supine (HFS). The angles are interpreted as the DICOM standard defines them: relative to the patient, with the head up in the image. If this device defines them relative to the table, the initial pose is incorrectly rotated. If a registration fails, AngioPose tests this interpretation and reports the angles to enter.</source>
        <comment>dicom.patient-lies</comment>
        <translation>患者体位为 %1 (0018,5100)，而非头先进仰卧。角度按 DICOM 标准解释：以患者为基准，图像中头部朝上。若该设备以检查床为基准计角，初始位姿会被旋转；配准失败时会尝试这种解释，并报告应输入的角度。</translation>
    </message>
    <message>
        <source>The table moved during this run (%1). The motion is ignored: a pose is valid only for its own frame, and different frames do not show the same table position.</source>
        <comment>dicom.table-moved</comment>
        <translation>采集过程中检查床发生移动（%1）。该移动不予考虑：位姿只对其所在帧有效，各帧并非同一位置的视图。</translation>
    </message>
    <message>
        <source>distance not specified in the header</source>
        <comment>dicom.table-moved-unknown</comment>
        <translation>文件头未说明移动距离</translation>
    </message>
    <message>
        <source>Deformable registration requires at least one registered view.</source>
        <comment>bend.no-view</comment>
        <translation>形变配准至少需要一个已配准的视图。</translation>
    </message>
    <message>
        <source>The traced vessels consist of isolated points. Connect the points to form curves before deforming the tree.</source>
        <comment>bend.needs-curves</comment>
        <translation>提取的血管是孤立的点。形变配准之前请先将其连成曲线。</translation>
    </message>
    <message>
        <source>The pose priors and the knot spacing must be positive numbers.</source>
        <comment>bend.options-unusable</comment>
        <translation>位姿先验和节点间距必须是正数。</translation>
    </message>
    <message>
        <source>The vessels are deformed relative to the tree: the rigid overlay deviates by %1 on average and most at branch %3 (%2).</source>
        <comment>bend.rigid-off</comment>
        <translation>血管相对于血管树发生形变：刚性叠加平均偏离 %1，在分支 %3 处最大（%2）。</translation>
    </message>
    <message>
        <source>The vessels may be deformed relative to the tree, but the image is inconclusive: the rigid overlay would deviate by %1 on average and most at branch %3 (%2).</source>
        <comment>bend.may-be-off</comment>
        <translation>血管可能相对于血管树发生形变，但图像不足以确定：刚性叠加平均将偏离 %1，在分支 %3 处最大（%2）。</translation>
    </message>
    <message>
        <source>Deformable registration was stopped before it finished; the rigid pose is kept.</source>
        <comment>bend.stopped</comment>
        <translation>形变配准在完成前被停止：保留刚性位姿。</translation>
    </message>
    <message>
        <source>Deformable registrations from different initial values differ by %1: some branches may be matched to the wrong vessels.</source>
        <comment>bend.runs-differ</comment>
        <translation>不同起始值的形变配准结果相差 %1：某些分支可能被匹配到错误的血管。</translation>
    </message>
    <message>
        <source>Only %1 of the vessel tree was matched to vessels in the image.</source>
        <comment>bend.little-seen</comment>
        <translation>只有 %1 的血管树在图像中找到了对应血管。</translation>
    </message>
    <message>
        <source>The traced vessels are still about %1 away from the deformed tree: the vessel motion is more local than the model can represent.</source>
        <comment>bend.not-followed</comment>
        <translation>提取的血管与形变后的血管树仍相差约 %1：其运动比模型所能描述的更局部。</translation>
    </message>
    <message>
        <source>The %1 vessels (%2 of the total vessel length) are displaced by %3 relative to the rest (direction: %4).</source>
        <comment>bend.part-moved</comment>
        <translation>%1侧血管（占血管总长的 %2）相对其余部分偏移 %3（方向：%4）。</translation>
    </message>
    <message>
        <source>Vessel motion in depth cannot be determined from a single view.</source>
        <comment>bend.depth-unknown</comment>
        <translation>单个视图无法确定血管在深度方向的移动。</translation>
    </message>
    <message>
        <source>anterior</source>
        <comment>side.front</comment>
        <translation>前</translation>
    </message>
    <message>
        <source>posterior</source>
        <comment>side.back</comment>
        <translation>后</translation>
    </message>
    <message>
        <source>superior</source>
        <comment>side.head</comment>
        <translation>头</translation>
    </message>
    <message>
        <source>inferior</source>
        <comment>side.feet</comment>
        <translation>足</translation>
    </message>
    <message>
        <source>The angiogram frame is empty. Choose another frame or file.</source>
        <comment>frame.empty</comment>
        <translation>此帧为空。请选择其他帧或文件。</translation>
    </message>
    <message>
        <source>The angiogram frame contains pixel values that are not finite numbers. Choose another frame, or export the image again.</source>
        <comment>frame.not-finite</comment>
        <translation>此帧含有非有限的像素值。请选择其他帧，或重新导出图像。</translation>
    </message>
    <message>
        <source>All pixels of the angiogram frame have the same gray value, so there is nothing to trace. Choose another frame or file.</source>
        <comment>frame.one-colour</comment>
        <translation>此帧只有单一灰度值：没有可提取的内容。请选择其他帧或文件。</translation>
    </message>
    <message>
        <source>This is a page of text, such as a dose report, not an angiogram. Choose the corresponding run, or another frame.</source>
        <comment>frame.report-page</comment>
        <translation>这是文字页（如剂量报告），不是血管造影。请选择其所属的序列，或其他帧。</translation>
    </message>
    <message>
        <source>The structures traced here are already visible in the first frame of the run: no contrast agent arrives between the two frames. If the run contains no contrast agent, the structures are catheters, guidewires and bone edges, not vessels.</source>
        <comment>frame.nothing-new</comment>
        <translation>此处提取的结构在序列第一帧中已经可见：两帧之间没有对比剂到达。若该序列不含对比剂，则这些是导管、导丝和骨缘，而不是血管。</translation>
    </message>
    <message>
        <source>Few structures in this frame resemble opacified vessels: the traced curves are short or faint, or may be catheters, guidewires and bone edges. Choose a frame with more contrast agent; if there is no such frame, check the curves with “Edit traced vessels”.</source>
        <comment>frame.little-contrast</comment>
        <translation>此帧中几乎没有看起来像显影血管的结构：提取的曲线很短或很淡，或可能是导管、导丝和骨缘。请选择对比剂更多的帧；若没有，请用“编辑提取的血管”检查这些曲线。</translation>
    </message>
    <message>
        <source>No vessel was found in the angiogram frame. Choose a frame with more contrast agent, raise the sensitivity, or check whether the vessels are dark or bright.</source>
        <comment>frame.no-vessels</comment>
        <translation>此帧造影图像中未发现血管。请选择对比剂更多的帧、提高灵敏度，或检查血管是暗还是亮。</translation>
    </message>
    <message>
        <source>The minimum vessel radius (%1) must be positive and not larger than the maximum vessel radius (%2).</source>
        <comment>trace.radii-unusable</comment>
        <translation>最小血管半径（%1）须为正，且不得大于最大血管半径（%2）。</translation>
    </message>
    <message>
        <source>The tracing sensitivity must be greater than 0, not %1.</source>
        <comment>trace.sensitivity-unusable</comment>
        <translation>提取灵敏度须大于 0，不能是 %1。</translation>
    </message>
    <message>
        <source>The vessel mask contains no vessel with a length of at least %1. Draw longer vessels, or lower the minimum length.</source>
        <comment>frame.mask-without-vessels</comment>
        <translation>血管掩膜中没有至少 %1 的血管。请画更长的血管或降低最短长度。</translation>
    </message>
    <message>
        <source>The run has only one frame, so no mask can be subtracted. Choose a run with frames before the arrival of contrast agent.</source>
        <comment>subtraction.one-frame</comment>
        <translation>该序列只有一帧：无法减影。请选择含对比剂到达前各帧的序列。</translation>
    </message>
    <message>
        <source>The frames of the run differ in size and cannot be subtracted.</source>
        <comment>subtraction.sizes-differ</comment>
        <translation>该序列各帧大小不同，无法减影。</translation>
    </message>
    <message>
        <source>The run shows contrast agent from the first frame on, so no frame can serve as the mask. Specify the mask frames, or trace without subtraction.</source>
        <comment>subtraction.no-mask</comment>
        <translation>该序列从第一帧起即有对比剂，没有可作蒙片的帧。请指定蒙片帧，或不减影提取。</translation>
    </message>
    <message>
        <source>The subtraction was stopped.</source>
        <comment>subtraction.stopped</comment>
        <translation>减影已停止。</translation>
    </message>
    <message>
        <source>The volume is empty. Choose another series or file.</source>
        <comment>volume.empty</comment>
        <translation>体数据为空。请选择其他序列或文件。</translation>
    </message>
    <message>
        <source>The volume has more than 4 billion voxels. Crop or resample it first.</source>
        <comment>volume.too-large</comment>
        <translation>体数据超过 40 亿体素。请先裁剪或重采样。</translation>
    </message>
    <message>
        <source>The volume has no valid voxel spacing. Enter the spacing in mm, or export the volume again.</source>
        <comment>volume.no-spacing</comment>
        <translation>体数据没有有效的体素间距。请输入以 mm 为单位的间距，或重新导出。</translation>
    </message>
    <message>
        <source>All voxels of the volume have the same value, so there is nothing to trace. Choose another series or file.</source>
        <comment>volume.one-value</comment>
        <translation>体数据只有一个值：没有可提取的内容。请选择其他序列或文件。</translation>
    </message>
    <message>
        <source>Tracing was stopped; no result was kept.</source>
        <comment>tracing.stopped</comment>
        <translation>提取已停止；未保留结果。</translation>
    </message>
    <message>
        <source>The volume contains no vessel: no voxel belongs to the mask. Lower the threshold, or load another file.</source>
        <comment>tracing.nothing-set</comment>
        <translation>体数据中没有血管：没有置位体素。请降低阈值，或载入其他文件。</translation>
    </message>
    <message>
        <source>The volume contains no vessel-like structure: no branch is long enough. Lower the threshold or the minimum branch length.</source>
        <comment>tracing.no-long-branch</comment>
        <translation>体数据中没有类似血管的结构：没有足够长的分支。请降低阈值或最短分支长度。</translation>
    </message>
    <message>
        <source>No opacified vessels were found: soft tissue measures %1, and no uniform region shows vascular enhancement. Is this the arterial phase? Choose the CT angiogram, or set the lower vessel threshold.</source>
        <comment>tracing.no-contrast</comment>
        <translation>未找到强化的血管：软组织为 %1，没有均匀区域显示血管强化。这是动脉期吗？请选择 CT 血管造影，或设定血管的下限阈值。</translation>
    </message>
    <message>
        <source>No opacified vessels were found: apart from bone, the brightest region measures %1 (soft tissue %2) and is not vessel-like. Is this the arterial phase? Choose the CT angiogram, or set the lower vessel threshold.</source>
        <comment>tracing.brightest-is-no-vessel</comment>
        <translation>未找到强化的血管：除骨骼外最亮区域为 %1（软组织 %2），且形态不似血管。这是动脉期吗？请选择 CT 血管造影，或设定血管的下限阈值。</translation>
    </message>
    <message>
        <source>There are points to avoid, but no seed. Place at least one seed in the vessels.</source>
        <comment>tracing.avoid-without-seed</comment>
        <translation>有避开点但没有种子点。请在血管中至少放一个种子点。</translation>
    </message>
    <message>
        <source>(%1, %2, %3)</source>
        <comment>tracing.place</comment>
        <translation>(%1, %2, %3)</translation>
    </message>
    <message>
        <source>The seed at %1 mm (LPS) is not inside a vessel. Place the seed inside a vessel, or lower the threshold.</source>
        <comment>tracing.seed-in-no-vessel</comment>
        <translation>种子点 %1 mm（LPS）不在血管内。请放入血管或降低阈值。</translation>
    </message>
    <message>
        <source>The seed at %1 mm (LPS) is not inside an enhanced vessel: the vessel at a distance of %2 was used.</source>
        <comment>tracing.seed-moved</comment>
        <translation>种子点 %1 mm（LPS）不在强化的血管内：已采用距其 %2 的血管。</translation>
    </message>
    <message>
        <source>No seed was placed: the aorta (or main artery) was found automatically at %1 mm (LPS) and traced. If it is the wrong vessel, place a seed in the correct one.</source>
        <comment>tracing.no-seed-found-vessel</comment>
        <translation>未放置种子点：已自动找到并提取位于 %1 mm（LPS）的主动脉（或主要动脉）。如果不对，请在正确的血管中放置种子点。</translation>
    </message>
    <message>
        <source>No seed was placed, and no aorta or main artery was found: the largest component was traced. If it does not contain the desired vessels, place a seed in those vessels.</source>
        <comment>tracing.no-seed-largest-piece</comment>
        <translation>未放置种子点，也未找到主动脉或主要动脉：已提取最大的连通部分。如果它不是所需血管，请在血管中放置种子点。</translation>
    </message>
    <message>
        <source>This is a head scan, in which arteries cannot be identified reliably: venous sinuses and veins may also be enhanced. Place a seed in the artery to trace, for example in a carotid artery in the neck or at the skull base.</source>
        <comment>tracing.head-needs-seed</comment>
        <translation>这是头部扫描，无法可靠识别动脉：静脉窦和静脉也可能强化。请在要提取的动脉中放置种子点，例如颈部或颅底处的颈动脉。</translation>
    </message>
    <message>
        <source>The values of this scan are not in Hounsfield units, so no large vessel can be identified reliably. Place a seed in a wide part of the artery to trace.</source>
        <comment>tracing.scan-needs-seed</comment>
        <translation>该扫描的数值不是 Hounsfield 单位，无法可靠识别大血管。请在要提取的动脉较宽处放置种子点。</translation>
    </message>
    <message>
        <source>In this head scan, arteries and venous sinuses are connected and equally enhanced: the vessel that was found without a seed runs along the skull. Place a seed in the artery to trace, and mark the sinuses as points to avoid.</source>
        <comment>tracing.veins-with-arteries</comment>
        <translation>该头部的动脉与静脉窦相连且强化程度相同：不用种子点找到的血管沿颅骨走行。请在要提取的动脉中放置种子点，并将静脉窦标记为应避开。</translation>
    </message>
    <message>
        <source>Intensity inhomogeneity due to coil sensitivity (up to %1×) was corrected: the threshold refers to intensities where the sensitivity is highest.</source>
        <comment>tracing.coil-evened-out</comment>
        <translation>已校正线圈灵敏度引起的强度不均匀（最大 %1×）：阈值以灵敏度最高处的强度为准。</translation>
    </message>
    <message>
        <source>The centerlines follow %1 of the mask&apos;s skeleton within two voxels; most of the rest is at %2 mm (LPS). Where the lumen is wide or its wall is rough, the centerlines follow the center of the lumen instead. Check there for a missing vessel.</source>
        <comment>tracing.skeleton-not-followed</comment>
        <translation>中心线在两个体素以内与掩膜骨架的 %1 相符；其余大部分位于 %2 mm（LPS）。在管腔较宽或管壁粗糙处，中心线改为沿管腔中央走行。请检查该处是否缺少血管。</translation>
    </message>
    <message>
        <source>The point at %1 mm (LPS) is outside the scan. Choose a point inside the scan.</source>
        <comment>tracing.path-end-outside-scan</comment>
        <translation>点 %1 mm (LPS) 在扫描之外。请选择扫描内的点。</translation>
    </message>
    <message>
        <source>The point at %1 mm (LPS) is not inside a structure brighter than its surroundings. Place the point inside the vessel.</source>
        <comment>tracing.path-end-in-nothing</comment>
        <translation>点 %1 mm (LPS) 处没有比周围更亮的结构。请将其放在血管内。</translation>
    </message>
    <message>
        <source>Both points are at the same position in the vessel. Place them farther apart.</source>
        <comment>tracing.path-ends-too-near</comment>
        <translation>两个点位于血管的同一位置。请放得更远一些。</translation>
    </message>
    <message>
        <source>No path was found between the two points. Place them closer together.</source>
        <comment>tracing.path-not-found</comment>
        <translation>两点之间未找到路径。请放得更近一些。</translation>
    </message>
    <message>
        <source>Over a length of %1, the path does not run through a vessel-like structure. Check the path, or place a point in between.</source>
        <comment>tracing.path-outside</comment>
        <translation>路径有 %1 未经过血管样结构。请检查，或在中间放置一点。</translation>
    </message>
    <message>
        <source>Tracing thin vessels requires seeds, but none has been placed. Place one in each vessel, near its origin.</source>
        <comment>tracing.tubes-need-seed</comment>
        <translation>提取细血管需要种子点，但尚未放置。请在每条血管的起始处附近放置一个。</translation>
    </message>
    <message>
        <source>No thin vessel of sufficient length was found starting from the seeds. Place the seeds at the center of the vessels, or turn off the restriction to thin vessels.</source>
        <comment>tracing.no-tube-at-seed</comment>
        <translation>从种子点出发没有找到足够长的细血管。请将种子点放在血管中央，或取消仅提取细血管的限制。</translation>
    </message>
    <message>
        <source>The search limit was reached, so the vessels are truncated. Check for leakage into lung, liver or bone.</source>
        <comment>tracing.tubes-cut-short</comment>
        <translation>已达到搜索上限：血管被截断。请检查是否泄漏到肺、肝或骨骼。</translation>
    </message>
    <message>
        <source>The vessels consist of %1 unconnected components, each with its own root: %2. Connect those that belong together, or select the desired components by placing a seed in each.</source>
        <comment>tracing.vessels-in-pieces</comment>
        <translation>血管由 %1 个互不相连的部分组成，每部分各有一个根：%2。请连接同属一体的部分，或在所需的各部分中放置种子点。</translation>
    </message>
    <message>
        <source>%1 (%2 of the voxels) at %3</source>
        <comment>tracing.piece-of-length</comment>
        <translation>%1（占体素 %2），位于 %3</translation>
    </message>
    <message>
        <source>%1 of the voxels at %2</source>
        <comment>tracing.piece-of-share</comment>
        <translation>占体素 %1，位于 %2</translation>
    </message>
    <message>
        <source>%1 more with %2</source>
        <comment>tracing.other-pieces</comment>
        <translation>另有 %1 段共 %2</translation>
    </message>
    <message>
        <source>A component that is not connected to the traced vessels was omitted: at %1 mm (LPS). Place a seed in it if it belongs to the tree.</source>
        <comment>tracing.one-piece-left-out</comment>
        <translation>有一个与提取血管不相连的部分已略去：%1 mm（LPS）。若属于血管树，请在其中放置种子点。</translation>
    </message>
    <message>
        <source>%1 components with %2 of the voxels are not connected to the traced vessels and were omitted: %3. Place a seed in each that belongs to the tree.</source>
        <comment>tracing.pieces-left-out</comment>
        <translation>有 %1 个部分（占体素 %2）与提取血管不相连，已略去：%3。请在属于血管树的各部分中放置种子点。</translation>
    </message>
    <message>
        <source>A component contains no branch of the minimum length and was omitted: at %1 mm (LPS). Lower the minimum branch length if it is a vessel.</source>
        <comment>tracing.one-piece-too-short</comment>
        <translation>有一个部分不含达到最短长度的分支，已略去：%1 mm（LPS）。若为血管，请减小最短分支长度。</translation>
    </message>
    <message>
        <source>%1 components with %2 of the voxels contain no branch of the minimum length and were omitted: %3. Lower the minimum branch length if they are vessels.</source>
        <comment>tracing.pieces-too-short</comment>
        <translation>有 %1 个部分（占体素 %2）不含达到最短长度的分支，已略去：%3。若为血管，请减小最短分支长度。</translation>
    </message>
    <message>
        <source>Gaps across which a vessel clearly continues were closed (number: %1; length: up to %2). Check that the connected vessels belong together.</source>
        <comment>tracing.gaps-closed</comment>
        <translation>已闭合血管明显延续的断口（数量：%1；长度：最大 %2）。请检查所连接的血管是否同属一体。</translation>
    </message>
    <message>
        <source>1 loop was cut at its narrowest point; check whether vessels merely touch there.</source>
        <comment>tracing.one-loop-opened</comment>
        <translation>1 个环已在最窄处断开；请检查该处血管是否仅相互接触。</translation>
    </message>
    <message>
        <source>%1 loops were cut at their narrowest points; check whether vessels merely touch there.</source>
        <comment>tracing.loops-opened</comment>
        <translation>%1 个环已在最窄处断开；请检查这些地方血管是否仅相互接触。</translation>
    </message>
    <message>
        <source>Loops kept as requested: %1. Where a loop closes, one branch ends on another.</source>
        <comment>tracing.loops-kept</comment>
        <translation>按要求保留的环：%1 个。环闭合处，一条分支止于另一条。</translation>
    </message>
    <message>
        <source>A region darker than the vessels was omitted; it may be a vein or soft tissue. Place a seed in it if it belongs to the tree.</source>
        <comment>tracing.one-dim-part-left-out</comment>
        <translation>一个比血管暗的部分已略去；它可能是静脉或软组织。若属于血管树，请在其中放置种子点。</translation>
    </message>
    <message>
        <source>%1 regions darker than the vessels were omitted; they may be veins or soft tissue. Place seeds in those that belong to the tree.</source>
        <comment>tracing.dim-parts-left-out</comment>
        <translation>%1 个比血管暗的部分已略去；它们可能是静脉或软组织。请在属于血管树的部分中放置种子点。</translation>
    </message>
    <message>
        <source>No voxel of the scan has a value as low as that of air in Hounsfield units. If the values are not in Hounsfield units, bone cannot be separated reliably from vessels. Check the vessels for bone, or export the scan in Hounsfield units.</source>
        <comment>tracing.perhaps-no-hounsfield</comment>
        <translation>扫描中没有像 Hounsfield 单位下的空气那样暗的体素：如果其数值不是 HU，就无法可靠地区分骨骼和血管。请检查血管中是否混入骨骼，或以 Hounsfield 单位重新导出扫描。</translation>
    </message>
    <message>
        <source>The vessel tree has no branches. Provide a centerline with at least one branch.</source>
        <comment>tree.no-branches</comment>
        <translation>血管树没有分支。请提供至少含一个分支的中心线。</translation>
    </message>
    <message>
        <source>Branch %1 occurs twice in the vessel tree. Branch IDs must be unique.</source>
        <comment>tree.branch-twice</comment>
        <translation>分支 %1 在血管树中重复。分支编号必须唯一。</translation>
    </message>
    <message>
        <source>Branch %1 of the vessel tree has fewer than two points. Remove the branch, or add points.</source>
        <comment>tree.branch-too-few-points</comment>
        <translation>血管树的分支 %1 少于两个点。请移除该分支或补充点。</translation>
    </message>
    <message>
        <source>Branch %1 of the vessel tree has a coordinate that is not a finite number.</source>
        <comment>tree.branch-not-finite</comment>
        <translation>血管树的分支 %1 有非有限的坐标。</translation>
    </message>
    <message>
        <source>Branch %1 of the vessel tree has zero length: all its points coincide.</source>
        <comment>tree.branch-without-length</comment>
        <translation>血管树的分支 %1 长度为零：所有点重合。</translation>
    </message>
    <message>
        <source>Branch %1 of the vessel tree has different numbers of radii and points.</source>
        <comment>tree.branch-radii-missing</comment>
        <translation>血管树分支 %1 的半径数与点数不符。</translation>
    </message>
    <message>
        <source>Branch %1 of the vessel tree has a radius that is negative or not a number. Correct the radius, or omit the radii of this branch.</source>
        <comment>tree.branch-radius-unusable</comment>
        <translation>血管树的分支 %1 有为负或非数值的半径。请更正，或省略该分支的半径。</translation>
    </message>
    <message>
        <source>The vessel tree has no branch %1.</source>
        <comment>tree.no-such-branch</comment>
        <translation>血管树没有分支 %1。</translation>
    </message>
    <message>
        <source>The range of %1 must consist of two angles within ±%2°, with the lower one first.</source>
        <comment>angles.range-odd</comment>
        <translation>%1 的范围须为 ±%2° 以内的两个角度，小的在前。</translation>
    </message>
    <message>
        <source>The angle search was stopped.</source>
        <comment>angles.stopped</comment>
        <translation>角度搜索已停止。</translation>
    </message>
    <message>
        <source>The angle step must be at least %1.</source>
        <comment>angles.step-too-fine</comment>
        <translation>角度步长至少为 %1。</translation>
    </message>
    <message>
        <source>Select one branch in the image, in the 3-D view or in the list.</source>
        <comment>angles.select-one-branch</comment>
        <translation>请在图像、三维视图或列表中选择一个分支。</translation>
    </message>
    <message>
        <source>The vessels have no radii: 1 mm is assumed, so the overlap of the branch is an estimate.</source>
        <comment>tree.radii-assumed</comment>
        <translation>血管没有半径：假定为 1 mm，因此分支的重叠程度只是估计。</translation>
    </message>
    <message>
        <source>Branch %1 is not connected to another branch, so it has no takeoff. Specify the branch itself instead.</source>
        <comment>tree.no-take-off</comment>
        <translation>分支 %1 不与其他分支相连，因此没有起始处。请使用分支本身。</translation>
    </message>
    <message>
        <source>All branches descend from branch %1; no branches would remain if it were deleted.</source>
        <comment>edit.all-hang-on-branch</comment>
        <translation>所有分支都源自分支 %1：将一无所剩。</translation>
    </message>
    <message>
        <source>All branches are shorter or thinner than the limits; no branches would remain. Lower the limits.</source>
        <comment>edit.all-pruned</comment>
        <translation>所有分支都短于或细于限值：将一无所剩。请降低限值。</translation>
    </message>
    <message>
        <source>Branch %1 cannot be cut so close to its end. Delete the branch, or cut it farther from the end.</source>
        <comment>edit.cut-too-near-end</comment>
        <translation>分支 %1 不能在如此靠近末端处切断。请删除它，或在离末端更远处切断。</translation>
    </message>
    <message>
        <source>The whole path runs inside vessels that are already traced, so there is nothing to add.</source>
        <comment>edit.branch-runs-inside</comment>
        <translation>整条路径都在已提取的血管内：没有可添加的部分。</translation>
    </message>
    <message>
        <source>A branch cannot be connected to itself. Choose two branches.</source>
        <comment>edit.joined-to-itself</comment>
        <translation>分支不能与自身连接。请选择两个分支。</translation>
    </message>
    <message>
        <source>The 2-D centerline is empty: no vessel was found in the image. Choose another frame or a higher sensitivity, or provide a centerline file.</source>
        <comment>centreline.empty</comment>
        <translation>二维中心线为空：图像中未发现血管。请选择其他帧、提高灵敏度，或提供中心线文件。</translation>
    </message>
    <message>
        <source>Curve %1 of the 2-D centerline has a coordinate that is not a finite number.</source>
        <comment>centreline.curve-not-finite</comment>
        <translation>二维中心线的曲线 %1 有非有限的坐标。</translation>
    </message>
    <message>
        <source>The surface has no triangles, or the voxel size is not positive. Choose another surface.</source>
        <comment>surface.empty</comment>
        <translation>表面没有三角面，或体素大小非正。请选择其他表面。</translation>
    </message>
    <message>
        <source>The surface is flat and encloses no volume. Choose the surface of a vessel wall.</source>
        <comment>surface.flat</comment>
        <translation>表面是平的，不包围任何体积。请选择血管壁。</translation>
    </message>
    <message>
        <source>The voxel size is too small for a surface of this size. Choose a larger voxel size.</source>
        <comment>surface.voxel-too-fine</comment>
        <translation>对于此范围的表面，体素过小。请选择更大的体素。</translation>
    </message>
    <message>
        <source>The surface encloses no volume: it has large openings or is thinner than a voxel. Close its holes, or choose a smaller voxel size.</source>
        <comment>surface.nothing-inside</comment>
        <translation>表面内部为空：开口过大，或比一个体素还薄。请封闭孔洞，或选择更小的体素。</translation>
    </message>
    <message>
        <source>the file is too large for a case. Choose an .angiopose file.</source>
        <comment>case.too-large</comment>
        <translation>作为病例文件过大。请选择 .angiopose 文件。</translation>
    </message>
    <message>
        <source>this is %1, not a case. Choose an .angiopose file.</source>
        <comment>case.is-other</comment>
        <translation>这是%1，不是病例。请选择 .angiopose 文件。</translation>
    </message>
    <message>
        <source>this JSON is not an AngioPose case (its format is not &quot;angiopose-case&quot;). Choose an .angiopose file.</source>
        <comment>case.not-one</comment>
        <translation>此 JSON 不是 AngioPose 病例（format 不是 &quot;angiopose-case&quot;）。请选择 .angiopose 文件。</translation>
    </message>
    <message>
        <source>a value has the wrong type. Compare the file with the published schema.</source>
        <comment>case.wrong-kind</comment>
        <translation>有取值类型错误。请将文件与公布的模式比较。</translation>
    </message>
    <message>
        <source>the case was saved by a newer version of AngioPose. Update the program.</source>
        <comment>case.newer</comment>
        <translation>病例由较新的 AngioPose 保存。请更新程序。</translation>
    </message>
    <message>
        <source>the key %1 is missing. Add it.</source>
        <comment>case.key-missing</comment>
        <translation>缺少键 %1。请补充。</translation>
    </message>
    <message>
        <source>this value is not allowed. See the published schema.</source>
        <comment>case.value-not-allowed</comment>
        <translation>不允许此取值。请参见公布的模式。</translation>
    </message>
    <message>
        <source>the value has the wrong type. See the published schema.</source>
        <comment>case.value-of-wrong-kind</comment>
        <translation>取值类型错误。请参见公布的模式。</translation>
    </message>
    <message>
        <source>%1 Correct this value.</source>
        <comment>case.value-wrong</comment>
        <translation>%1 请更正此值。</translation>
    </message>
    <message>
        <source>the file does not conform to the published schema. Compare it with a valid case.</source>
        <comment>case.against-schema</comment>
        <translation>文件不符合公布的模式。请与有效的病例比较。</translation>
    </message>
    <message>
        <source>this is an input of the case and will not be overwritten. Choose another name.</source>
        <comment>case.is-input</comment>
        <translation>这是病例的输入文件，不会被覆盖。请选择其他文件名。</translation>
    </message>
    <message>
        <source>a file name or other text in the case is not valid UTF-8. Rename the file, or correct the text.</source>
        <comment>case.not-utf8</comment>
        <translation>病例中的文件名或其他文本不是有效的 UTF-8。请重命名文件，或更正文本。</translation>
    </message>
    <message>
        <source>a scan alone is not a case: a case requires traced vessels and an angiogram. Trace the vessels and open an angiogram before saving; the scan file itself is not changed.</source>
        <comment>case.scan-alone</comment>
        <translation>仅有扫描不构成病例：病例文件需要已提取的血管和造影图像。保存前请先提取血管并打开造影图像；扫描文件本身不会改变。</translation>
    </message>
    <message>
        <source>a case requires a vessel tree and an angiogram. Open both before saving.</source>
        <comment>case.incomplete</comment>
        <translation>病例需要血管树和造影图像。保存前请打开两者。</translation>
    </message>
    <message>
        <source>the pose is not a rigid transform with finite values. Reset it before saving.</source>
        <comment>case.pose-not-rigid</comment>
        <translation>该位姿不是数值有限的刚性变换。保存前请重置位姿。</translation>
    </message>
    <message>
        <source>the camera belongs to an image of %1 × %2 pixels, but the angiogram is %3 × %4 pixels. Specify the camera that belongs to this angiogram.</source>
        <comment>case.camera-of-other-image</comment>
        <translation>相机对应 %1 × %2 像素的图像，但造影图像为 %3 × %4 像素。请提供该造影图像对应的相机。</translation>
    </message>
    <message>
        <source>maxVesselRadiusPx is less than minVesselRadiusPx. Swap the two values.</source>
        <comment>case.radii-swapped</comment>
        <translation>maxVesselRadiusPx 小于 minVesselRadiusPx。请对调。</translation>
    </message>
    <message>
        <source>the case specifies no vessel input. Specify the vessel file as centerline, segmentation, surface or volume.</source>
        <comment>case.no-input</comment>
        <translation>病例未指定血管输入。请以 centerline、segmentation、surface 或 volume 指定血管文件。</translation>
    </message>
    <message>
        <source>%1 Remove the key to restore the unedited vessels.</source>
        <comment>case.edited-tree</comment>
        <translation>%1 删除该键可恢复编辑前的血管。</translation>
    </message>
    <message>
        <source>branch %1 occurs twice.</source>
        <comment>case.branch-twice</comment>
        <translation>分支 %1 重复。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is unknown. Use one of %2.</source>
        <comment>case.method-unknown</comment>
        <translation>&quot;%1&quot; 未知。可用：%2。</translation>
    </message>
    <message>
        <source>enter a number from %1 to %2.</source>
        <comment>case.option-number</comment>
        <translation>请输入 %1 至 %2 之间的数。</translation>
    </message>
    <message>
        <source>choose one of %1.</source>
        <comment>case.option-choice</comment>
        <translation>请选择 %1 之一。</translation>
    </message>
    <message>
        <source>the initial pose is missing and cannot be computed from the angles. %1</source>
        <comment>case.no-start-pose</comment>
        <translation>缺少初始位姿，且无法由角度计算。%1</translation>
    </message>
    <message>
        <source>the file has changed since the case was saved. Check that it is the correct file.</source>
        <comment>case.file-changed</comment>
        <translation>文件在病例保存后已更改。请确认是否正确。</translation>
    </message>
    <message>
        <source>the stored result was discarded because the vessels, the image or the traced curves have changed since it was computed. Register again.</source>
        <comment>case.result-stale</comment>
        <translation>保存的结果已舍弃，因为血管、图像或提取的曲线此后已改变。请重新配准。</translation>
    </message>
    <message>
        <source>the stored result was discarded because parts of the case have changed since it was computed: %1. Register again.</source>
        <comment>case.result-beside</comment>
        <translation>保存的结果已舍弃，因为病例的以下部分在计算后已改变：%1。请重新配准。</translation>
    </message>
    <message>
        <source>the tracked poses were discarded because they do not match the run or the pose of the case. Track the vessels again.</source>
        <comment>case.followed-misfit</comment>
        <translation>跟踪得到的位姿已舍弃，因为它们与病例的序列或位姿不符。请重新跟踪血管。</translation>
    </message>
    <message>
        <source>The vessels of a tracked run are shown at the tracked poses, but without deformation: %1 Track the vessels again.</source>
        <comment>case.bends-left-out</comment>
        <translation>已跟踪序列的血管按其位姿显示，但不含形变：%1 请重新跟踪。</translation>
    </message>
    <message>
        <source>the case specifies no deformation file.</source>
        <comment>case.bends-unnamed</comment>
        <translation>病例未指明形变数据文件。</translation>
    </message>
    <message>
        <source>this is not a deformation file.</source>
        <comment>case.bends-none</comment>
        <translation>这不是形变数据文件。</translation>
    </message>
    <message>
        <source>the deformations belong to different vessels or frames.</source>
        <comment>case.bends-of-others</comment>
        <translation>这些形变属于其他血管或帧。</translation>
    </message>
    <message>
        <source>the deformations are damaged or truncated.</source>
        <comment>case.bends-cut</comment>
        <translation>形变数据已损坏或被截断。</translation>
    </message>
    <message>
        <source>the file has changed since the case was saved.</source>
        <comment>case.bends-changed</comment>
        <translation>文件在病例保存后已更改。</translation>
    </message>
    <message>
        <source>the vessels</source>
        <comment>part.vessels</comment>
        <translation>血管</translation>
    </message>
    <message>
        <source>the auxiliary branches</source>
        <comment>part.auxiliary-branches</comment>
        <translation>辅助分支</translation>
    </message>
    <message>
        <source>the excluded branches</source>
        <comment>part.excluded-branches</comment>
        <translation>排除的分支</translation>
    </message>
    <message>
        <source>the image</source>
        <comment>part.image</comment>
        <translation>图像</translation>
    </message>
    <message>
        <source>the frame</source>
        <comment>part.frame</comment>
        <translation>帧</translation>
    </message>
    <message>
        <source>the subtraction</source>
        <comment>part.subtraction</comment>
        <translation>减影</translation>
    </message>
    <message>
        <source>the traced curves</source>
        <comment>part.curves</comment>
        <translation>提取的曲线</translation>
    </message>
    <message>
        <source>the geometry</source>
        <comment>part.geometry</comment>
        <translation>几何参数</translation>
    </message>
    <message>
        <source>the initial pose</source>
        <comment>part.start-pose</comment>
        <translation>初始位姿</translation>
    </message>
    <message>
        <source>the locked degrees of freedom</source>
        <comment>part.locks</comment>
        <translation>锁定的自由度</translation>
    </message>
    <message>
        <source>the method</source>
        <comment>part.method</comment>
        <translation>方法</translation>
    </message>
    <message>
        <source>the options</source>
        <comment>part.options</comment>
        <translation>选项</translation>
    </message>
    <message>
        <source>this is not the DICOM image from which the case was created.</source>
        <comment>case.other-image</comment>
        <translation>这不是创建病例时所用的 DICOM 图像。</translation>
    </message>
    <message>
        <source>%1 The case contains the edited vessels and can be opened without this file.</source>
        <comment>case.opens-without</comment>
        <translation>%1 病例中包含编辑后的血管，无需该文件即可打开。</translation>
    </message>
    <message>
        <source>the tree has no branch %1; this entry is ignored.</source>
        <comment>case.branch-left-out</comment>
        <translation>血管树中没有分支 %1；该条目被忽略。</translation>
    </message>
    <message>
        <source>An additional view was omitted: %1</source>
        <comment>case.view-left-out</comment>
        <translation>另一个视图已略去：%1</translation>
    </message>
    <message>
        <source>line %1: &apos;%2&apos; is not a valid folder name. Use a name without &apos;/&apos;.</source>
        <comment>batch.no-folder-name</comment>
        <translation>第 %1 行：“%2”不是有效的文件夹名。请使用不含“/”的名称。</translation>
    </message>
    <message>
        <source>line %1: the frame number &apos;%2&apos; is not an integer. Correct the line.</source>
        <comment>batch.frame-no-number</comment>
        <translation>第 %1 行：帧号“%2”不是整数。请更正该行。</translation>
    </message>
    <message>
        <source>line %1: the name &apos;%2&apos; is already in use. Use a unique name for each case.</source>
        <comment>batch.name-twice</comment>
        <translation>第 %1 行：名称“%2”已被使用。请为每个病例使用唯一的名称。</translation>
    </message>
    <message>
        <source>the column %1 is missing. Choose a folder written by `angiopose-cli evaluate`.</source>
        <comment>runs.column-missing</comment>
        <translation>缺少列 %1。请选择由 `angiopose-cli evaluate` 写出的文件夹。</translation>
    </message>
    <message>
        <source>the value in line %1, column %2 is not a number. Choose a folder written by `angiopose-cli evaluate`.</source>
        <comment>runs.no-number</comment>
        <translation>第 %1 行第 %2 列不是数字。请选择由 `angiopose-cli evaluate` 写出的文件夹。</translation>
    </message>
    <message>
        <source>the folder contains results of different experiments or seeds. Use a separate folder for each experiment and seed.</source>
        <comment>runs.mixed</comment>
        <translation>该文件夹含有不同实验或种子的结果。请分别使用单独的文件夹。</translation>
    </message>
    <message>
        <source>reading was stopped.</source>
        <comment>file.reading-stopped</comment>
        <translation>读取已停止。</translation>
    </message>
    <message>
        <source>the file does not exist. Check the path.</source>
        <comment>file.missing</comment>
        <translation>文件不存在。请检查路径。</translation>
    </message>
    <message>
        <source>the file cannot be accessed (%1). Check the path.</source>
        <comment>file.unreachable</comment>
        <translation>无法访问该文件（%1）。请检查路径。</translation>
    </message>
    <message>
        <source>the file cannot be opened (%1). Check your read permission.</source>
        <comment>file.not-opened</comment>
        <translation>无法打开该文件（%1）。请检查读取权限。</translation>
    </message>
    <message>
        <source>the file cannot be read (%1). Copy it to a local disk.</source>
        <comment>file.not-read</comment>
        <translation>无法读取该文件（%1）。请复制到本地磁盘。</translation>
    </message>
    <message>
        <source>the file cannot be written (%1). Choose another folder, or free disk space.</source>
        <comment>file.not-written</comment>
        <translation>无法写入该文件（%1）。请选择其他文件夹，或释放磁盘空间。</translation>
    </message>
    <message>
        <source>this is a folder. Choose a file in it.</source>
        <comment>file.is-folder</comment>
        <translation>这是文件夹。请选择其中的文件。</translation>
    </message>
    <message>
        <source>this is not a regular file. Choose a file on a disk.</source>
        <comment>file.not-regular</comment>
        <translation>这不是普通文件。请选择磁盘上的文件。</translation>
    </message>
    <message>
        <source>the file is empty. Export or copy it again.</source>
        <comment>file.empty</comment>
        <translation>文件为空。请重新导出或复制。</translation>
    </message>
    <message>
        <source>this is a Git LFS pointer, not the file itself. Run `git lfs pull` in its repository.</source>
        <comment>file.lfs-pointer</comment>
        <translation>这是 Git LFS 指针而非文件本身。请在其仓库中运行 `git lfs pull`。</translation>
    </message>
    <message>
        <source>the file cannot be saved here. Enter a file name in an existing folder.</source>
        <comment>file.no-place</comment>
        <translation>此处不能保存文件。请输入现有文件夹中的文件名。</translation>
    </message>
    <message>
        <source>the unit must be a positive length in mm.</source>
        <comment>file.wrong-unit</comment>
        <translation>单位须为正的毫米长度。</translation>
    </message>
    <message>
        <source>the file declares more data than fit into memory. It is damaged; export it again.</source>
        <comment>file.larger-than-memory</comment>
        <translation>文件声明的数据超过内存。文件已损坏；请重新导出。</translation>
    </message>
    <message>
        <source>the decoder %1 is missing or cannot be started. Reinstall AngioPose.</source>
        <comment>file.decoder-missing</comment>
        <translation>解码程序 %1 不存在或无法启动。请重新安装 AngioPose。</translation>
    </message>
    <message>
        <source>the decoder could not process the file. The file is damaged; export it again, or in another format.</source>
        <comment>file.decoder-died</comment>
        <translation>解码程序无法处理其内容。文件已损坏；请重新导出，或导出为其他格式。</translation>
    </message>
    <message>
        <source>decoding takes far longer than expected for the file size. The file is damaged; export it again.</source>
        <comment>file.decoder-too-long</comment>
        <translation>解码时间远超该文件大小的预期。文件已损坏；请重新导出。</translation>
    </message>
    <message>
        <source>decoding requires far more memory than expected for the file size. The file is damaged; export it again.</source>
        <comment>file.decoder-too-large</comment>
        <translation>解码所需内存远超该文件大小的预期。文件已损坏；请重新导出。</translation>
    </message>
    <message>
        <source>SHA-256 cannot be computed. Check the OpenSSL installation.</source>
        <comment>file.hash-impossible</comment>
        <translation>无法计算 SHA-256。请检查 OpenSSL 安装。</translation>
    </message>
    <message>
        <source>the folder cannot be read (%1). Check the path.</source>
        <comment>folder.not-read</comment>
        <translation>无法读取文件夹（%1）。请检查路径。</translation>
    </message>
    <message>
        <source>the folder cannot be read completely. Copy it to a local disk.</source>
        <comment>folder.not-read-to-end</comment>
        <translation>无法读完文件夹。请复制到本地磁盘。</translation>
    </message>
    <message>
        <source>the folder contains more than 50,000 files. Choose the folder of one study.</source>
        <comment>folder.too-full</comment>
        <translation>文件夹中超过 50000 个文件。请选择单个检查的文件夹。</translation>
    </message>
    <message>
        <source>the JSON is nested more than %1 levels deep. AngioPose does not write such files.</source>
        <comment>json.too-deep</comment>
        <translation>JSON 嵌套超过 %1 层。AngioPose 不会写出这样的文件。</translation>
    </message>
    <message>
        <source>the JSON is invalid at line %1. Correct the file, or restore a backup.</source>
        <comment>json.invalid</comment>
        <translation>第 %1 行不是有效的 JSON。请更正文件，或恢复备份。</translation>
    </message>
    <message>
        <source>the file contains a number that exceeds double precision. Correct it.</source>
        <comment>json.number-too-large</comment>
        <translation>文件中有超出双精度范围的数。请更正。</translation>
    </message>
    <message>
        <source>this is not a text table. Choose a CSV file with a header row.</source>
        <comment>table.no-text</comment>
        <translation>这不是文本表。请选择有表头的 CSV 文件。</translation>
    </message>
    <message>
        <source>line %1 has %2 columns, but the first line has %3. Separate columns with commas, and use a period as the decimal point.</source>
        <comment>table.columns</comment>
        <translation>第 %1 行有 %2 列，首行有 %3 列。请以逗号分列，用 . 作小数点。</translation>
    </message>
    <message>
        <source>line %1, column %2: &quot;%3&quot; is not a finite number. Correct or remove the line.</source>
        <comment>table.no-number</comment>
        <translation>第 %1 行，%2 列：“%3”不是有限数。请更正或删除该行。</translation>
    </message>
    <message>
        <source>line %1: the value in the branch column must be an integer. Correct the line.</source>
        <comment>table.branch-no-number</comment>
        <translation>第 %1 行：branch 必须为整数。请更正。</translation>
    </message>
    <message>
        <source>the file must contain exactly one ITK transform. Export a single rigid transform.</source>
        <comment>pose.no-transform</comment>
        <translation>文件必须恰好含有一个 ITK 变换。请导出单个刚性变换。</translation>
    </message>
    <message>
        <source>the transform &quot;%1&quot; is not rigid, or parameters are missing. Export a rigid transform (affine, Euler3D or VersorRigid3D).</source>
        <comment>pose.not-rigid-transform</comment>
        <translation>变换“%1”非刚性，或缺少参数。请导出刚性变换（affine、Euler3D 或 VersorRigid3D）。</translation>
    </message>
    <message>
        <source>the center of the transform is not finite. Export the transform again.</source>
        <comment>pose.centre-not-finite</comment>
        <translation>变换中心不是有限数。请重新导出变换。</translation>
    </message>
    <message>
        <source>the file contains no 4 × 4 matrix `cameraFromPatient`, at the top level or in `pose`. Add the matrix.</source>
        <comment>pose.no-matrix</comment>
        <translation>文件顶层或 `pose` 中没有 4 × 4 矩阵 `cameraFromPatient`。请补充。</translation>
    </message>
    <message>
        <source>cameraFromPatient must have four rows of four numbers.</source>
        <comment>pose.rows</comment>
        <translation>cameraFromPatient 须为四行四列数字。</translation>
    </message>
    <message>
        <source>cameraFromPatient contains a value that is not a finite number.</source>
        <comment>pose.not-finite</comment>
        <translation>cameraFromPatient 含有非有限数。</translation>
    </message>
    <message>
        <source>the last row of cameraFromPatient must be 0 0 0 1. Check that the matrix is not transposed.</source>
        <comment>pose.last-row</comment>
        <translation>cameraFromPatient 末行须为 0 0 0 1。请检查矩阵是否被转置。</translation>
    </message>
    <message>
        <source>cameraFromPatient is a reflection (determinant below 0). Represent a mirrored image by the sign of fx, not by the rotation.</source>
        <comment>pose.reflection</comment>
        <translation>cameraFromPatient 为镜像（行列式小于 0）。镜像图像应以 fx 的符号表示，而非旋转。</translation>
    </message>
    <message>
        <source>the upper left 3 × 3 block of cameraFromPatient is not a rotation (it contains scale or shear). Provide a rigid pose in mm.</source>
        <comment>pose.no-rotation</comment>
        <translation>cameraFromPatient 左上 3 × 3 块不是旋转（含缩放或剪切）。请提供以 mm 为单位的刚性位姿。</translation>
    </message>
    <message>
        <source>the file is too large for a pose. Choose a .json, .tfm, .mat or .h5 file.</source>
        <comment>pose.too-large</comment>
        <translation>作为位姿过大。请选择 .json、.tfm、.mat 或 .h5 文件。</translation>
    </message>
    <message>
        <source>this is not a pose. Choose a .json file, or an ITK .tfm, .mat or .h5 file.</source>
        <comment>pose.unknown</comment>
        <translation>这不是位姿。请选择 .json 或 ITK 的 .tfm、.mat、.h5 文件。</translation>
    </message>
    <message>
        <source>the pose is not a rigid transform with finite values. Reset it before saving.</source>
        <comment>pose.not-saved</comment>
        <translation>该位姿不是数值有限的刚性变换。保存前请重置。</translation>
    </message>
    <message>
        <source>poses can be saved as .json, .tfm or .h5. Change the extension.</source>
        <comment>pose.extension</comment>
        <translation>位姿可保存为 .json、.tfm 或 .h5。请更改扩展名。</translation>
    </message>
    <message>
        <source>this is not a blind trial log. Choose another name.</source>
        <comment>observer-log.not-one</comment>
        <translation>这不是盲法试验记录。请选择其他文件名。</translation>
    </message>
    <message>
        <source>a gzip archive</source>
        <comment>content.gzip</comment>
        <translation>gzip 压缩包</translation>
    </message>
    <message>
        <source>a zip archive</source>
        <comment>content.zip</comment>
        <translation>zip 压缩包</translation>
    </message>
    <message>
        <source>an NRRD volume</source>
        <comment>content.nrrd</comment>
        <translation>NRRD 体数据</translation>
    </message>
    <message>
        <source>a NIfTI volume</source>
        <comment>content.nifti</comment>
        <translation>NIfTI 体数据</translation>
    </message>
    <message>
        <source>a NIfTI header</source>
        <comment>content.nifti-header</comment>
        <translation>NIfTI 文件头</translation>
    </message>
    <message>
        <source>an HDF5 file</source>
        <comment>content.hdf5</comment>
        <translation>HDF5 文件</translation>
    </message>
    <message>
        <source>a NetCDF (MINC) volume</source>
        <comment>content.netcdf</comment>
        <translation>NetCDF（MINC）体数据</translation>
    </message>
    <message>
        <source>an MRtrix tractogram</source>
        <comment>content.mrtrix</comment>
        <translation>MRtrix 纤维束图</translation>
    </message>
    <message>
        <source>a TrackVis tractogram</source>
        <comment>content.trackvis</comment>
        <translation>TrackVis 纤维束图</translation>
    </message>
    <message>
        <source>an STL surface</source>
        <comment>content.stl</comment>
        <translation>STL 表面</translation>
    </message>
    <message>
        <source>a PLY surface</source>
        <comment>content.ply</comment>
        <translation>PLY 表面</translation>
    </message>
    <message>
        <source>a glTF scene</source>
        <comment>content.gltf</comment>
        <translation>glTF 场景</translation>
    </message>
    <message>
        <source>a legacy VTK file</source>
        <comment>content.legacy-vtk</comment>
        <translation>旧版 VTK 文件</translation>
    </message>
    <message>
        <source>a VTK XML file</source>
        <comment>content.vtk-xml</comment>
        <translation>VTK XML 文件</translation>
    </message>
    <message>
        <source>an XML file</source>
        <comment>content.xml</comment>
        <translation>XML 文件</translation>
    </message>
    <message>
        <source>a MetaImage header</source>
        <comment>content.metaimage</comment>
        <translation>MetaImage 文件头</translation>
    </message>
    <message>
        <source>a DICOM file</source>
        <comment>content.dicom</comment>
        <translation>DICOM 文件</translation>
    </message>
    <message>
        <source>a JPEG image</source>
        <comment>content.jpeg</comment>
        <translation>JPEG 图像</translation>
    </message>
    <message>
        <source>a PNG image</source>
        <comment>content.png</comment>
        <translation>PNG 图像</translation>
    </message>
    <message>
        <source>a TIFF image</source>
        <comment>content.tiff</comment>
        <translation>TIFF 图像</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <comment>content.pdf</comment>
        <translation>PDF 文档</translation>
    </message>
    <message>
        <source>a JSON file</source>
        <comment>content.json</comment>
        <translation>JSON 文件</translation>
    </message>
    <message>
        <source>The color image was converted to grayscale.</source>
        <comment>image.colour-to-grey</comment>
        <translation>彩色图像已转换为灰度。</translation>
    </message>
    <message>
        <source>The transparency of the image is ignored.</source>
        <comment>image.transparency-ignored</comment>
        <translation>忽略图像透明度。</translation>
    </message>
    <message>
        <source>A non-DICOM image contains no C-arm geometry. Enter the geometry manually.</source>
        <comment>image.no-geometry</comment>
        <translation>非 DICOM 图像不含 C 形臂几何。请在病例的几何中输入。</translation>
    </message>
    <message>
        <source>The image is a binary mask: the vessels are used as drawn.</source>
        <comment>image.is-mask</comment>
        <translation>该图像是二值掩膜：血管按所画的样子采用。</translation>
    </message>
    <message>
        <source>unsupported image format. Choose a DICOM XA run, or a PNG, TIFF or JPEG image.</source>
        <comment>image.unknown</comment>
        <translation>不支持的图像格式。请选择 DICOM XA 序列，或 PNG、TIFF、JPEG 图像。</translation>
    </message>
    <message>
        <source>this is %1, not an angiogram. Choose a DICOM XA run, or a PNG, TIFF or JPEG image.</source>
        <comment>image.is-other</comment>
        <translation>这是%1，不是造影图像。请选择 DICOM XA 序列，或 PNG、TIFF、JPEG 图像。</translation>
    </message>
    <message>
        <source>this gzip archive contains no readable DICOM file. Unpack it and choose the angiogram itself.</source>
        <comment>image.gzip-without-dicom</comment>
        <translation>此 gzip 压缩包中没有可读的 DICOM 文件。请解压后选择造影图像。</translation>
    </message>
    <message>
        <source>the image is damaged or truncated. Copy or export it again.</source>
        <comment>image.damaged</comment>
        <translation>图像损坏或截断。请重新复制或导出。</translation>
    </message>
    <message>
        <source>the image is damaged or in an unsupported format. Export it as an untiled grayscale or RGB image with 8 or 16 bits per channel.</source>
        <comment>image.unusual</comment>
        <translation>图像已损坏或格式不受支持。请以 8 或 16 位灰度或 RGB、不分块导出。</translation>
    </message>
    <message>
        <source>the image has fewer than 8 pixels per side, or more than AngioPose supports. Export the angiogram at its original size.</source>
        <comment>image.size</comment>
        <translation>图像边长少于 8 像素，或超出 AngioPose 的上限。请按原尺寸导出造影图像。</translation>
    </message>
    <message>
        <source>the frames differ in size. All frames of a run must have the same size.</source>
        <comment>image.frames-differ</comment>
        <translation>各帧大小不同。同一序列的所有帧须大小相同。</translation>
    </message>
    <message>
        <source>there is no image to write. Render an image or trace the vessels first.</source>
        <comment>image.no-picture</comment>
        <translation>没有可写入的图像。请先生成或提取。</translation>
    </message>
    <message>
        <source>a pixel value is not a finite number. Correct the image before writing it.</source>
        <comment>image.pixel-not-finite-writing</comment>
        <translation>有像素不是有限数。写入前请更正图像。</translation>
    </message>
    <message>
        <source>a pixel value is not a finite number. Export the image again.</source>
        <comment>image.pixel-not-finite</comment>
        <translation>有像素不是有限数。请重新导出图像。</translation>
    </message>
    <message>
        <source>this is %1, not a 2-D centerline. Choose a CSV table or a PNG mask.</source>
        <comment>centreline.is-other</comment>
        <translation>这是%1，不是二维中心线。请选择 CSV 表或 PNG 掩膜。</translation>
    </message>
    <message>
        <source>this is not a binary mask. Draw the vessels in white on a black background.</source>
        <comment>centreline.no-mask</comment>
        <translation>这不是二值掩膜。请以黑底白色画血管。</translation>
    </message>
    <message>
        <source>the header row has no x and y columns. The first line must specify the columns: x,y and, if available, branch,radius (px).</source>
        <comment>centreline.no-columns</comment>
        <translation>表头缺少 x 和 y 列。首行须为列名：x,y，以及 branch,radius（px，如有）。</translation>
    </message>
    <message>
        <source>the file has a z column, so it is a 3-D centerline. Choose the centerline traced in the image.</source>
        <comment>centreline.is-3d</comment>
        <translation>文件含 z 列，因此是三维中心线。请选择图像中提取的中心线。</translation>
    </message>
    <message>
        <source>the file has more than a million points. Resample the centerline.</source>
        <comment>centreline.too-long</comment>
        <translation>超过一百万个点。请重采样中心线。</translation>
    </message>
    <message>
        <source>the point in line %1 is far outside any image. Coordinates must be in pixels.</source>
        <comment>centreline.outside</comment>
        <translation>第 %1 行的点远超出任何图像的范围。坐标须以像素为单位。</translation>
    </message>
    <message>
        <source>this is not a DICOM file. Choose a scan.</source>
        <comment>dicom.not-one</comment>
        <translation>这不是 DICOM 文件。请选择扫描。</translation>
    </message>
    <message>
        <source>the deflate-compressed data are damaged or truncated. Copy or export the file again.</source>
        <comment>dicom.deflate-damaged</comment>
        <translation>其 deflate 压缩内容损坏或截断。请重新复制或导出。</translation>
    </message>
    <message>
        <source>the file contains no readable DICOM element. It is damaged; copy or export it again.</source>
        <comment>dicom.no-element</comment>
        <translation>无法读取任何 DICOM 元素。文件损坏；请重新复制或导出。</translation>
    </message>
    <message>
        <source>element %1 declares %2 bytes, but only %3 remain</source>
        <comment>dicom.element-too-long</comment>
        <translation>元素 %1 声明 %2 字节，但仅剩 %3</translation>
    </message>
    <message>
        <source>the sequence %1 is not terminated</source>
        <comment>dicom.sequence-without-end</comment>
        <translation>序列 %1 未终止</translation>
    </message>
    <message>
        <source>the file ends within an element</source>
        <comment>dicom.ends-within</comment>
        <translation>文件在某个元素中间结束</translation>
    </message>
    <message>
        <source>The end of the file is damaged (%1); the image is complete.</source>
        <comment>dicom.end-damaged</comment>
        <translation>文件末尾损坏（%1）；图像完整。</translation>
    </message>
    <message>
        <source>%1 is damaged at a position before the pixel data: %2. Copy or export it again.</source>
        <comment>dicom.damaged-before-pixels</comment>
        <translation>%1 在像素之前损坏：%2。请重新复制或导出。</translation>
    </message>
    <message>
        <source>%1 contains no image. Choose the X-ray angiography run.</source>
        <comment>dicom.holds-no-image</comment>
        <translation>%1 不含图像。请选择 X 线血管造影序列。</translation>
    </message>
    <message>
        <source>this DICOM file</source>
        <comment>dicom.this-file</comment>
        <translation>此 DICOM 文件</translation>
    </message>
    <message>
        <source>this DICOM file (%1)</source>
        <comment>dicom.this-file-of</comment>
        <translation>此 DICOM 文件（%1）</translation>
    </message>
    <message>
        <source>the header contains contradictory values for the bits per pixel. The header is damaged; export the run again.</source>
        <comment>dicom.bits-contradict</comment>
        <translation>文件头中的每像素位数相互矛盾。文件头损坏；请重新导出。</translation>
    </message>
    <message>
        <source>the image is stored in palette color. Export the angiogram in grayscale.</source>
        <comment>dicom.palette-colours</comment>
        <translation>以调色板颜色存储。请以灰度导出造影图像。</translation>
    </message>
    <message>
        <source>the pixels (%1, %2 samples per pixel) are neither grayscale nor color. Export the angiogram in grayscale.</source>
        <comment>dicom.not-grey</comment>
        <translation>像素（%1，%2 个采样）既非灰度也非彩色。请以灰度导出。</translation>
    </message>
    <message>
        <source>the pixels have %1 bits. Export the angiogram with 8 or 16 bits per pixel.</source>
        <comment>dicom.pixel-bits</comment>
        <translation>像素为 %1 位。请以 8 或 16 位导出。</translation>
    </message>
    <message>
        <source>the header contains no image size. The file is damaged; export the run again.</source>
        <comment>dicom.no-image-size</comment>
        <translation>文件头无图像尺寸。文件损坏；请重新导出。</translation>
    </message>
    <message>
        <source>the file declares %1 frames of %2 × %3 pixels, more than AngioPose supports. Export fewer frames.</source>
        <comment>dicom.too-many-frames</comment>
        <translation>声明 %1 帧、每帧 %2 × %3 像素，超出 AngioPose 的上限。请导出较少的帧。</translation>
    </message>
    <message>
        <source>the pixel data are truncated: %1 of %2 bytes are present. Copy or export the file again.</source>
        <comment>dicom.pixels-cut-short</comment>
        <translation>像素数据被截断：%2 字节中仅有 %1。请重新复制或导出。</translation>
    </message>
    <message>
        <source>the compressed pixel data are truncated. Copy or export the file again.</source>
        <comment>dicom.packed-pixels-cut-short</comment>
        <translation>压缩像素数据被截断。请重新复制或导出。</translation>
    </message>
    <message>
        <source>only %1 of %2 frames are present. Copy or export the file again.</source>
        <comment>dicom.frames-missing</comment>
        <translation>%2 帧中仅有 %1 帧。请重新复制或导出。</translation>
    </message>
    <message>
        <source>frame %1 cannot be decoded (transfer syntax %2): it is damaged or truncated, or its compression is not supported. Export the run again, uncompressed if possible.</source>
        <comment>dicom.frame-undecodable</comment>
        <translation>第 %1 帧无法解码（传输语法 %2）：损坏、截断或压缩方式不受支持。请重新导出，尽量不压缩。</translation>
    </message>
    <message>
        <source>Some frames cannot be decoded and are shown blank: %1 (of %2 frames). Export the run again if you need these frames.</source>
        <comment>dicom.frames-lost</comment>
        <translation>部分帧无法解码，显示为空白：第 %1 帧（共 %2 帧）。如需要这些帧，请重新导出。</translation>
    </message>
    <message>
        <source>Some frames are partly damaged and are shown as far as they could be decoded: %1 (of %2 frames). Check them in another viewer before using them.</source>
        <comment>dicom.frames-flawed</comment>
        <translation>部分帧有损坏，仅显示能够解码的部分：第 %1 帧（共 %2 帧）。使用前请用其他阅片软件核对。</translation>
    </message>
    <message>
        <source>The image is partly damaged and is shown as far as it could be decoded. Check it in another viewer before using it.</source>
        <comment>image.flawed</comment>
        <translation>图像部分损坏，仅显示能够解码的部分。使用前请与其他阅片软件对照。</translation>
    </message>
    <message>
        <source>the image has only %1 × %2 pixels. Choose the full-size angiogram.</source>
        <comment>dicom.thumbnail</comment>
        <translation>仅 %1 × %2 像素。请选择原尺寸造影图像。</translation>
    </message>
    <message>
        <source>This is %1, not an X-ray angiogram: it has no C-arm geometry.</source>
        <comment>dicom.not-xray</comment>
        <translation>这是%1，不是 X 线血管造影：没有 C 形臂几何。</translation>
    </message>
    <message>
        <source>the DICOM file could not be written. Choose another format.</source>
        <comment>dicom.not-written</comment>
        <translation>无法写入 DICOM 文件。请选择其他格式。</translation>
    </message>
    <message>
        <source>there are no frames to write. Load or simulate an angiogram first.</source>
        <comment>dicom.no-frames-to-write</comment>
        <translation>没有可写入的帧。请先载入或模拟造影图像。</translation>
    </message>
    <message>
        <source>the run is too large for an uncompressed DICOM file. Write fewer frames.</source>
        <comment>dicom.run-too-large</comment>
        <translation>该序列超出未压缩 DICOM 文件容量。请写入较少帧。</translation>
    </message>
    <message>
        <source>there is not enough memory to write this run. Write fewer frames.</source>
        <comment>dicom.no-memory-to-write</comment>
        <translation>内存不足以写入该序列。请写入较少帧。</translation>
    </message>
    <message>
        <source>an image of modality %1</source>
        <comment>dicom.modality</comment>
        <translation>%1 模态的图像</translation>
    </message>
    <message>
        <source>an image without a specified modality</source>
        <comment>dicom.no-modality</comment>
        <translation>未注明模态的图像</translation>
    </message>
    <message>
        <source>The header contains no imager pixel spacing: %1 was derived from the calibrated pixel spacing. Check it in the geometry.</source>
        <comment>dicom.spacing-from-calibration</comment>
        <translation>文件头无成像器像素间距：由校准像素间距推算为 %1。请在几何中核对。</translation>
    </message>
    <message>
        <source>The header contains no imager pixel spacing (0018,1164): %1 was derived from the field of view. Check it in the geometry.</source>
        <comment>dicom.spacing-from-field</comment>
        <translation>文件头无成像器像素间距（0018,1164）：由视野推算为 %1。请在几何中核对。</translation>
    </message>
    <message>
        <source>The header contains no imager pixel spacing (0018,1164): enter it in the geometry.</source>
        <comment>dicom.spacing-missing</comment>
        <translation>文件头无成像器像素间距（0018,1164）：请在几何中输入。</translation>
    </message>
    <message>
        <source>The header contains no imager pixel spacing (0018,1164): enter it in the geometry. An image intensifier of %1 suggests at most %2.</source>
        <comment>dicom.spacing-missing-intensifier</comment>
        <translation>文件头无成像器像素间距（0018,1164）：请在几何中输入。影像增强器为 %1，提示最大为 %2。</translation>
    </message>
    <message>
        <source>The header contains only isocenter angles (0018,9463), whose signs are ambiguous. Enter the LAO/RAO and CRA/CAU angles in the geometry.</source>
        <comment>dicom.angles-of-isocentre</comment>
        <translation>文件头仅有等中心角度（0018,9463），符号不确定：请在几何中输入 LAO/RAO 和 CRA/CAU。</translation>
    </message>
    <message>
        <source>The detector is tilted by %1 (0018,1530): the principal point is uncertain.</source>
        <comment>dicom.detector-tilted</comment>
        <translation>探测器倾斜 %1（0018,1530）：主点不确定。</translation>
    </message>
    <message>
        <source>Based on %1, the image is assumed to be mirrored. Check the orientation markers (L, R).</source>
        <comment>dicom.image-mirrored</comment>
        <translation>根据 %1，图像按镜像处理。请核对方位标记（L、R）。</translation>
    </message>
    <message>
        <source>The C-arm moved during this run, but the header does not specify the angles of all %2 frames (specified: %1). The angles of the first frame are used. Check them for the selected frame.</source>
        <comment>dicom.gantry-moved</comment>
        <translation>采集中 C 形臂有移动，但文件头未给出全部 %2 帧的角度（已给出：%1）。角度取自第一帧。请针对所选帧核对。</translation>
    </message>
    <message>
        <source>none</source>
        <comment>dicom.gantry-no-angles</comment>
        <translation>无</translation>
    </message>
    <message>
        <source>%1</source>
        <comment>dicom.gantry-angles</comment>
        <translation>%1</translation>
    </message>
    <message>
        <source>The traced structure is hardly longer than it is wide: check that it is a vessel.</source>
        <comment>vessels.compact</comment>
        <translation>提取的结构长度几乎不大于宽度：请检查是否为血管。</translation>
    </message>
    <message>
        <source>The extent (%1) or the diameter of the vessels is unusual: if the unit of the file is not the millimeter, specify the unit.</source>
        <comment>vessels.unusual-size</comment>
        <translation>血管的总跨度（%1）或直径异常：若文件单位不是毫米，请指定单位。</translation>
    </message>
    <message>
        <source>unsupported surface format. Choose a .vtp, .vtk, .stl, .ply or .obj file.</source>
        <comment>surface.unknown</comment>
        <translation>不支持的表面格式。请选择 .vtp、.vtk、.stl、.ply 或 .obj 文件。</translation>
    </message>
    <message>
        <source>this is %1, not a surface. Choose a .vtp, .vtk, .stl, .ply or .obj file.</source>
        <comment>surface.is-other</comment>
        <translation>这是%1，不是表面。请选择 .vtp、.vtk、.stl、.ply 或 .obj 文件。</translation>
    </message>
    <message>
        <source>the file contains no triangles. Choose the surface of a vessel.</source>
        <comment>surface.no-triangles</comment>
        <translation>文件中没有三角面。请选择血管表面。</translation>
    </message>
    <message>
        <source>all triangles have zero area. Choose the surface of a vessel.</source>
        <comment>surface.no-area</comment>
        <translation>所有三角面的面积均为零。请选择血管表面。</translation>
    </message>
    <message>
        <source>the surface has more triangles than AngioPose supports. Decimate the surface.</source>
        <comment>surface.too-large</comment>
        <translation>三角面数量超出 AngioPose 的上限。请简化表面。</translation>
    </message>
    <message>
        <source>a coordinate is not a number or exceeds one kilometer. Correct the coordinate, or export the surface again.</source>
        <comment>surface.coordinate</comment>
        <translation>某个坐标不是数字，或超过一公里。请更正，或重新导出表面。</translation>
    </message>
    <message>
        <source>a triangle refers to a point that does not exist. The file is damaged; export it again.</source>
        <comment>surface.bad-index</comment>
        <translation>三角面引用了不存在的点。文件损坏；请重新导出。</translation>
    </message>
    <message>
        <source>the triangles are damaged or truncated. Copy or export the file again.</source>
        <comment>surface.cut-short</comment>
        <translation>三角面损坏或截断。请重新复制或导出。</translation>
    </message>
    <message>
        <source>surfaces can be saved as .stl. Change the extension.</source>
        <comment>surface.extension</comment>
        <translation>表面可保存为 .stl。请更改扩展名。</translation>
    </message>
    <message>
        <source>The surface is not closed (%1 open and %2 non-manifold edges): its interior is determined by majority vote. Check the result, or close the holes.</source>
        <comment>surface.open</comment>
        <translation>表面未闭合（%1 条开放边、%2 条非流形边）：内部按多数判定。请检查结果，或封闭孔洞。</translation>
    </message>
    <message>
        <source>The triangles are inconsistently oriented, so overlapping parts may cancel each other out.</source>
        <comment>surface.disoriented</comment>
        <translation>三角面方向不一致；重叠部分可能抵消。</translation>
    </message>
    <message>
        <source>The surface measures %1 across, which is unusual: if its unit is not the millimeter, specify the unit.</source>
        <comment>surface.unusual-size</comment>
        <translation>表面跨度为 %1，属异常：若单位不是毫米，请指定单位。</translation>
    </message>
    <message>
        <source>Outlier points (%1) were removed together with their triangles because they are not finite or lie farther than %2 from the center. Check the surface.</source>
        <comment>surface.stray-points</comment>
        <translation>已去除离群点（%1 个）及其三角形，因其坐标非有限或距中心超过 %2。请检查该表面。</translation>
    </message>
    <message>
        <source>the surface measures %1 across, which is larger than any human body. Specify the unit of the file, or remove outlier points.</source>
        <comment>surface.larger-than-body</comment>
        <translation>表面跨度为 %1，大于任何人体。请指定文件的单位，或去除离群点。</translation>
    </message>
    <message>
        <source>line %1 does not define a valid point. The file is damaged; export it again.</source>
        <comment>surface.obj-bad-point</comment>
        <translation>第 %1 行不是有效的点。文件损坏；请重新导出。</translation>
    </message>
    <message>
        <source>the PLY header is damaged or truncated. Export the file again.</source>
        <comment>surface.ply-header-damaged</comment>
        <translation>PLY 文件头损坏或截断。请重新导出。</translation>
    </message>
    <message>
        <source>the PLY header is damaged: the element &quot;%1&quot; has no properties. Export the file again.</source>
        <comment>surface.ply-element-empty</comment>
        <translation>PLY 文件头损坏：元素“%1”没有属性。请重新导出。</translation>
    </message>
    <message>
        <source>the PLY data are damaged or truncated, or a face has more than 255 vertices. Export the file again, as triangles.</source>
        <comment>surface.ply-data-damaged</comment>
        <translation>其 PLY 数据已损坏或截断，或某个面超过 255 个顶点。请重新导出为三角形。</translation>
    </message>
    <message>
        <source>this is %1, not a centerline. Choose a centerline file: .vtp, .vtk, .vtu, .csv, .swc or .mrk.json.</source>
        <comment>tree.is-other</comment>
        <translation>这是%1，不是中心线。请选择中心线文件：.vtp、.vtk、.vtu、.csv、.swc 或 .mrk.json。</translation>
    </message>
    <message>
        <source>unsupported centerline format. Choose a centerline file: .vtp, .vtk, .vtu, .csv, .swc or .mrk.json.</source>
        <comment>tree.format-unknown</comment>
        <translation>不支持的中心线格式。请选择中心线文件：.vtp、.vtk、.vtu、.csv、.swc 或 .mrk.json。</translation>
    </message>
    <message>
        <source>the file does not start with a VTK header. Export the centerlines again.</source>
        <comment>tree.no-vtk-beginning</comment>
        <translation>文件开头不是 VTK 文件头。请重新导出中心线。</translation>
    </message>
    <message>
        <source>vessel trees can be saved as .vtp, .csv, .swc or .mrk.json. Change the extension.</source>
        <comment>tree.extension</comment>
        <translation>血管树可保存为 .vtp、.csv、.swc 或 .mrk.json。请更改扩展名。</translation>
    </message>
    <message>
        <source>the file has %1 points; a centerline tree may have at most %2. Resample the centerlines.</source>
        <comment>tree.too-many-points</comment>
        <translation>有 %1 个点；中心线树最多 %2 个。请重采样中心线。</translation>
    </message>
    <message>
        <source>the file has %1 separate lines; a centerline tree may have at most %2. Keep only the vessels of interest.</source>
        <comment>tree.too-many-lines</comment>
        <translation>有 %1 条独立线；中心线树最多 %2 条。请只保留感兴趣的血管。</translation>
    </message>
    <message>
        <source>the file contains no lines. Choose a file with vessel centerlines.</source>
        <comment>tree.no-lines</comment>
        <translation>文件中没有线。请选择含血管中心线的文件。</translation>
    </message>
    <message>
        <source>the file contains a surface, not centerlines. Extract the centerlines first (e.g., with VMTK or 3D Slicer), and open them instead.</source>
        <comment>tree.is-surface</comment>
        <translation>文件含表面而非中心线。请先提取中心线（如用 VMTK 或 Slicer），再打开。</translation>
    </message>
    <message>
        <source>a line refers to a point that does not exist. The file is damaged; export it again.</source>
        <comment>tree.bad-index</comment>
        <translation>线引用了不存在的点。文件损坏；请重新导出。</translation>
    </message>
    <message>
        <source>the lines pass through the same points too often. The file is damaged; export it again.</source>
        <comment>tree.points-repeated</comment>
        <translation>线过多经过相同的点。文件损坏；请重新导出。</translation>
    </message>
    <message>
        <source>no line has two distinct points. Choose a file with vessel centerlines.</source>
        <comment>tree.no-length</comment>
        <translation>没有一条线含两个不同的点。请选择含血管中心线的文件。</translation>
    </message>
    <message>
        <source>the third line of a legacy VTK file must be ASCII or BINARY. Export the file again.</source>
        <comment>tree.vtk-third-line</comment>
        <translation>旧版 VTK 文件第三行须为 ASCII 或 BINARY。请重新导出。</translation>
    </message>
    <message>
        <source>the file contains no POLYDATA or UNSTRUCTURED_GRID data set. Export the centerlines as polylines.</source>
        <comment>tree.vtk-no-data-set</comment>
        <translation>文件中没有 POLYDATA 或 UNSTRUCTURED_GRID 数据集。请将中心线导出为折线。</translation>
    </message>
    <message>
        <source>the file contains %1, not POLYDATA or UNSTRUCTURED_GRID. Export the centerlines as polylines.</source>
        <comment>tree.vtk-other-data-set</comment>
        <translation>文件含 %1，而非 POLYDATA 或 UNSTRUCTURED_GRID。请将中心线导出为折线。</translation>
    </message>
    <message>
        <source>the section &quot;%1&quot; is damaged or truncated. Export the file again.</source>
        <comment>tree.vtk-section-damaged</comment>
        <translation>“%1”部分损坏或截断。请重新导出。</translation>
    </message>
    <message>
        <source>the VTK XML data are damaged or truncated. Export the file again.</source>
        <comment>tree.vtk-xml-damaged</comment>
        <translation>其中的 VTK XML 数据损坏或截断。请重新导出。</translation>
    </message>
    <message>
        <source>the file contains neither VTK XML PolyData nor UnstructuredGrid. Export the centerlines as .vtp.</source>
        <comment>tree.vtk-xml-other</comment>
        <translation>不是 VTK XML PolyData 或 UnstructuredGrid。请导出为 .vtp。</translation>
    </message>
    <message>
        <source>the file declares %1, which is impossible. It is damaged; export it again.</source>
        <comment>tree.vtk-xml-impossible-count</comment>
        <translation>其声明为 %1，这不可能。文件损坏；请重新导出。</translation>
    </message>
    <message>
        <source>this is not a 3D Slicer markups file with curves. Export the centerlines as .mrk.json curves, .vtp, .vtk, .csv or .swc.</source>
        <comment>tree.markups-none</comment>
        <translation>不是含曲线的 Slicer markups 文件。请将中心线导出为 .mrk.json 曲线、.vtp、.vtk、.csv 或 .swc。</translation>
    </message>
    <message>
        <source>line %1 does not have the form `id type x y z radius parent`. Correct the line, or export the file again.</source>
        <comment>tree.swc-line</comment>
        <translation>第 %1 行不符合 `id type x y z radius parent` 格式。请更正或重新导出。</translation>
    </message>
    <message>
        <source>line %1 repeats an ID. IDs must be unique.</source>
        <comment>tree.swc-id-twice</comment>
        <translation>第 %1 行 ID 重复。ID 必须唯一。</translation>
    </message>
    <message>
        <source>line %1 refers to parent %2, which does not exist. Export the whole tree.</source>
        <comment>tree.swc-parent-missing</comment>
        <translation>第 %1 行的父节点 %2 不存在。请导出整棵树。</translation>
    </message>
    <message>
        <source>the first line must specify the columns: x,y,z and, if available, radius,branch.</source>
        <comment>tree.table-no-header</comment>
        <translation>首行须为列名：x,y,z，以及 radius,branch（如有）。</translation>
    </message>
    <message>
        <source>the header row has no x, y and z columns. Name the columns accordingly (coordinates in mm, LPS).</source>
        <comment>tree.table-no-columns</comment>
        <translation>表头缺少 x、y、z 列。请命名（mm，患者 LPS）。</translation>
    </message>
    <message>
        <source>the file appears to be a list of graph nodes (it has an id column) without an order along the vessels. Add a branch column, or export the centerlines themselves.</source>
        <comment>tree.table-is-graph</comment>
        <translation>像是图节点列表（id 列），没有沿血管的顺序。请添加 branch 列，或导出中心线本身。</translation>
    </message>
    <message>
        <source>this folder contains no DICOM image. Choose the folder of a DICOM scan, or a volume file.</source>
        <comment>series.none</comment>
        <translation>此文件夹中没有 DICOM 图像。请选择 DICOM 扫描所在文件夹，或直接选择体数据文件。</translation>
    </message>
    <message>
        <source>this DICOM file contains no image. Choose a scan.</source>
        <comment>series.file-without-image</comment>
        <translation>此 DICOM 文件不含图像。请选择扫描。</translation>
    </message>
    <message>
        <source>the series %1 is not in this folder. Choose the folder that contains it.</source>
        <comment>series.not-here</comment>
        <translation>序列 %1 不在此文件夹。请选择包含它的文件夹。</translation>
    </message>
    <message>
        <source>the series of the case is not in this folder. Choose the folder that contains it.</source>
        <comment>series.of-case-not-here</comment>
        <translation>病例的序列不在此文件夹。请选择包含它的文件夹。</translation>
    </message>
    <message>
        <source>no series in this folder forms a volume. Choose another folder.</source>
        <comment>series.none-makes-volume</comment>
        <translation>此文件夹中没有序列可组成体数据。请选择其他文件夹。</translation>
    </message>
    <message>
        <source>the input contains %1 volumes (%2). Choose one of them by its series ID; `info` lists the IDs.</source>
        <comment>series.several</comment>
        <translation>含 %1 个体数据（%2）。请按序列 ID 选择；`info` 可列出。</translation>
    </message>
    <message>
        <source>this is an X-ray run, not a volume. Open it as the angiogram.</source>
        <comment>series.is-xray</comment>
        <translation>这是 X 线序列，不是体数据。请作为造影图像打开。</translation>
    </message>
    <message>
        <source>this is a DICOM segmentation. Export it as a NIfTI or NRRD label image.</source>
        <comment>series.is-segmentation</comment>
        <translation>这是 DICOM 分割。请导出为 NIfTI 或 NRRD 标签图像。</translation>
    </message>
    <message>
        <source>this is a single slice, not a volume. Copy all slices of the series, or choose another series.</source>
        <comment>series.single-slice</comment>
        <translation>这是单个层面而非体数据。请复制该序列全部层面，或选择其他序列。</translation>
    </message>
    <message>
        <source>the images specify no pixel size, so they do not form a volume. Choose another series.</source>
        <comment>series.no-pixel-size</comment>
        <translation>图像不含像素大小，无法组成体数据。请选择其他序列。</translation>
    </message>
    <message>
        <source>the images specify no position in the patient, so they do not form a volume. Choose another series.</source>
        <comment>series.no-place</comment>
        <translation>图像不含在患者中的位置，无法组成体数据。请选择其他序列。</translation>
    </message>
    <message>
        <source>the slices lie side by side instead of being stacked. Choose another series.</source>
        <comment>series.beside-each-other</comment>
        <translation>层面并排而非堆叠。请选择其他序列。</translation>
    </message>
    <message>
        <source>the slice spacing is too uneven for a volume (%1 slices over %2). Copy all slices of the series, or choose another series.</source>
        <comment>series.too-uneven</comment>
        <translation>层间距过于不均，无法组成体数据（%2 内 %1 层）。请复制该序列全部层面，或选择其他序列。</translation>
    </message>
    <message>
        <source>this is a color image. Choose the grayscale scan itself.</source>
        <comment>series.colour</comment>
        <translation>这是彩色图像。请选择灰度扫描本身。</translation>
    </message>
    <message>
        <source>the image size does not match the header. Export the series again.</source>
        <comment>series.slice-size</comment>
        <translation>图像尺寸与文件头不符。请重新导出。</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced (%1 to %2) and were resampled to a spacing of %3.</source>
        <comment>series.uneven-slices</comment>
        <translation>层间距不均（%1 至 %2）：已重采样为 %3。</translation>
    </message>
    <message>
        <source>The slices are not stacked perpendicularly (deviation of %1, as with a tilted gantry): they were shifted in plane to their true positions.</source>
        <comment>series.slanted</comment>
        <translation>层面未垂直堆叠（偏 %1，如机架倾斜）：已在层面内平移到实际位置。</translation>
    </message>
    <message>
        <source>1 of %1 slices is missing (%2) and was interpolated from its neighbors. Copy the series again if possible.</source>
        <comment>series.slice-missing</comment>
        <translation>%1 层中缺 1 层（%2）：已由相邻层插补。如可能请重新复制该序列。</translation>
    </message>
    <message>
        <source>%1 of %2 slices are missing (%3) and were interpolated from their neighbors. Copy the series again if possible.</source>
        <comment>series.slices-missing</comment>
        <translation>%2 层中缺 %1 层（%3）：已由相邻层插补。如可能请重新复制该序列。</translation>
    </message>
    <message>
        <source>after slice %1</source>
        <comment>series.after-slices</comment>
        <translation>第 %1 层之后</translation>
    </message>
    <message>
        <source>after slice %1 and elsewhere</source>
        <comment>series.after-slices-and-elsewhere</comment>
        <translation>第 %1 层之后等处</translation>
    </message>
    <message>
        <source>%1 of %2 slices have the same position as another slice; only the slice acquired first at each position is used.</source>
        <comment>series.overlap</comment>
        <translation>%2 层中 %1 层位置重复；采用最先采集的层面。</translation>
    </message>
    <message>
        <source>Duplicate files of the series are ignored (number: %1).</source>
        <comment>series.files-twice</comment>
        <translation>该序列的重复文件已忽略（数量：%1）。</translation>
    </message>
    <message>
        <source>Some files of the series are damaged at the end (number: %1).</source>
        <comment>series.files-damaged</comment>
        <translation>该序列有 %1 个文件末尾损坏。</translation>
    </message>
    <message>
        <source>The series contains images of %1 different sizes or orientations; each is listed separately.</source>
        <comment>series.mixed</comment>
        <translation>该序列混有 %1 种尺寸或方位的图像；已分别列出。</translation>
    </message>
    <message>
        <source>part %1 of %2</source>
        <comment>series.part</comment>
        <translation>第 %1 部分，共 %2</translation>
    </message>
    <message>
        <source>The slices are stored with different rescale factors or as floating-point values. %1</source>
        <comment>series.scales</comment>
        <translation>层面以不同的缩放系数或浮点存储。%1</translation>
    </message>
    <message>
        <source>unsupported volume format. Choose a DICOM folder, NIfTI, NRRD or MetaImage (.mha, .mhd).</source>
        <comment>volume.unknown</comment>
        <translation>不支持的体数据格式。请选择 DICOM 文件夹、NIfTI、NRRD 或 MetaImage（.mha、.mhd）。</translation>
    </message>
    <message>
        <source>this is %1, not a volume. Choose a DICOM folder, NIfTI, NRRD or MetaImage (.mha, .mhd).</source>
        <comment>volume.is-other</comment>
        <translation>这是%1，不是体数据。请选择 DICOM 文件夹、NIfTI、NRRD 或 MetaImage（.mha、.mhd）。</translation>
    </message>
    <message>
        <source>the file contains an object of type %1, not an image. Choose the scan.</source>
        <comment>volume.holds-other</comment>
        <translation>文件含有类型为 %1 的对象，而非图像。请选择扫描。</translation>
    </message>
    <message>
        <source>the file declares %1, more than AngioPose supports. Crop the scan to the vessels.</source>
        <comment>volume.declares</comment>
        <translation>声明 %1，超出 AngioPose 的上限。请将扫描裁剪到血管范围。</translation>
    </message>
    <message>
        <source>the volume exceeds the memory of this computer. Crop the scan to the vessels.</source>
        <comment>volume.larger-than-memory</comment>
        <translation>体数据超过本机内存。请裁剪到血管范围。</translation>
    </message>
    <message>
        <source>the file has %1: a single slice is not a volume. Choose the whole scan.</source>
        <comment>volume.single-slice</comment>
        <translation>有 %1：单层不是体数据。请选择完整扫描。</translation>
    </message>
    <message>
        <source>the file is %1-dimensional, but a volume has three dimensions. Choose the whole scan.</source>
        <comment>volume.not-three-dimensional</comment>
        <translation>为 %1 维，而体数据为三维。请选择完整扫描。</translation>
    </message>
    <message>
        <source>the file has %1 dimensions, but a volume has three. Save the volume you need as a separate file, and open that file.</source>
        <comment>volume.dimensions</comment>
        <translation>文件有 %1 个维度，而体数据应为三维。请将所需的体数据另存为单独的文件，再打开该文件。</translation>
    </message>
    <message>
        <source>the file contains %1 volumes or values per voxel (4-D). Extract the volume you need, and open it.</source>
        <comment>volume.several-4d</comment>
        <translation>含 %1 个体数据或每体素多值（四维）。请提取所需的再打开。</translation>
    </message>
    <message>
        <source>the file contains %1 volumes, layers or values per voxel (4-D). Save the volume you need as a separate file, and open that file.</source>
        <comment>volume.several-layers</comment>
        <translation>含 %1 个体数据、层或每体素多值（四维）。请单独保存所需的再打开。</translation>
    </message>
    <message>
        <source>the file has %1 values per voxel. Choose the grayscale scan itself.</source>
        <comment>volume.channels</comment>
        <translation>每体素有 %1 个值。请选择灰度扫描本身。</translation>
    </message>
    <message>
        <source>the first axis has %1 entries, so the file is a color image, not a volume. Choose the scan.</source>
        <comment>volume.colour-axis</comment>
        <translation>第一轴有 %1 项，因此是彩色图像而非体数据。请选择扫描。</translation>
    </message>
    <message>
        <source>the voxel values are colors. Choose the grayscale scan itself.</source>
        <comment>volume.colours</comment>
        <translation>体素为彩色。请选择灰度扫描本身。</translation>
    </message>
    <message>
        <source>the header declares %1. The file is damaged; export it again.</source>
        <comment>volume.header-gives</comment>
        <translation>文件头声明为 %1。文件损坏；请重新导出。</translation>
    </message>
    <message>
        <source>the header contains no usable voxel size or position. Export the volume again.</source>
        <comment>volume.no-place</comment>
        <translation>文件头无可用的体素大小或位置。请重新导出。</translation>
    </message>
    <message>
        <source>the header is damaged: it declares %1 dimensions. Export the file again.</source>
        <comment>volume.header-dimensions</comment>
        <translation>文件头损坏：标注 %1 维。请重新导出。</translation>
    </message>
    <message>
        <source>the header is damaged: the voxel data offset is invalid. Export the file again.</source>
        <comment>volume.impossible-start</comment>
        <translation>文件头损坏：体素数据偏移量无效。请重新导出。</translation>
    </message>
    <message>
        <source>the angle between the axes is %1 instead of 90°. Resample the volume to orthogonal axes.</source>
        <comment>volume.skewed</comment>
        <translation>各轴夹角为 %1 而非 90°。请重采样到正交轴。</translation>
    </message>
    <message>
        <source>the header cannot be read (%1). Export the file again.</source>
        <comment>volume.header-not-read</comment>
        <translation>文件头无法读取（%1）。请重新导出。</translation>
    </message>
    <message>
        <source>the %1 header cannot be read. Export the file again.</source>
        <comment>volume.format-header-not-read</comment>
        <translation>其 %1 文件头无法读取。请重新导出。</translation>
    </message>
    <message>
        <source>HeaderSize is invalid. Correct the header.</source>
        <comment>volume.header-size</comment>
        <translation>HeaderSize 无效。请更正文件头。</translation>
    </message>
    <message>
        <source>the header does not specify the voxel data file (ElementDataFile). Export the volume again.</source>
        <comment>volume.no-data-file</comment>
        <translation>文件头未指明体素数据文件（ElementDataFile）。请重新导出。</translation>
    </message>
    <message>
        <source>the line skip or byte skip is invalid. Correct the header.</source>
        <comment>volume.skips</comment>
        <translation>line skip 或 byte skip 无效。请更正文件头。</translation>
    </message>
    <message>
        <source>the header skips lines in a separate data file. Save the header and the voxels as one file.</source>
        <comment>volume.skips-lines-elsewhere</comment>
        <translation>文件头要求在另一数据文件中跳过若干行。请将文件头与体素保存为一个文件。</translation>
    </message>
    <message>
        <source>the voxel data are split across several files. Save the volume as one file.</source>
        <comment>volume.several-files</comment>
        <translation>体素分散在多个文件中。请保存为一个文件。</translation>
    </message>
    <message>
        <source>the voxel type &quot;%1&quot; is not supported. Save the volume with 16-bit integer or floating-point voxels.</source>
        <comment>volume.voxel-type</comment>
        <translation>不支持体素类型“%1”。请保存为 16 位或浮点。</translation>
    </message>
    <message>
        <source>the voxel type (NIfTI datatype %1) is not supported. Save the volume with 16-bit integer or floating-point voxels.</source>
        <comment>volume.nifti-type</comment>
        <translation>不支持该体素类型（NIfTI 类型 %1）。请保存为 16 位或浮点。</translation>
    </message>
    <message>
        <source>the voxel type is not supported. Save the volume with 16-bit integer or floating-point voxels.</source>
        <comment>volume.other-voxel-type</comment>
        <translation>不支持其体素类型。请保存为 16 位或浮点。</translation>
    </message>
    <message>
        <source>the voxels are compressed with bzip2. Save the volume with gzip or raw encoding.</source>
        <comment>volume.bzip2</comment>
        <translation>体素以 bzip2 压缩。请用 gzip 或 raw 编码保存。</translation>
    </message>
    <message>
        <source>the voxels are stored as text (%1). Save the volume with gzip or raw encoding.</source>
        <comment>volume.text-encoding</comment>
        <translation>体素以文本存储（%1）。请用 gzip 或 raw 编码保存。</translation>
    </message>
    <message>
        <source>the voxels are stored as text. Save the volume in binary form.</source>
        <comment>volume.text</comment>
        <translation>体素以文本存储。请以二进制保存。</translation>
    </message>
    <message>
        <source>the voxel data are truncated, or their compression is damaged. Copy or export the volume again.</source>
        <comment>volume.packing-damaged</comment>
        <translation>体素数据被截断，或压缩损坏。请重新复制或导出。</translation>
    </message>
    <message>
        <source>the voxel data are truncated or damaged. Copy or export the volume again.</source>
        <comment>volume.voxels-damaged</comment>
        <translation>体素数据被截断或损坏。请重新复制或导出。</translation>
    </message>
    <message>
        <source>the voxel data are truncated. Copy or export the volume again.</source>
        <comment>volume.cut-short</comment>
        <translation>体素数据被截断。请重新复制或导出。</translation>
    </message>
    <message>
        <source>the voxel data are truncated: %1 of %2 bytes are present. Copy or export the volume again.</source>
        <comment>volume.cut-short-by</comment>
        <translation>体素数据被截断：%2 字节中仅有 %1。请重新复制或导出。</translation>
    </message>
    <message>
        <source>the voxel data file %1 is missing. Copy both files together.</source>
        <comment>volume.voxels-not-there</comment>
        <translation>体素数据文件 %1 不存在。请将两个文件一起复制。</translation>
    </message>
    <message>
        <source>the voxel data file cannot be read (%1).</source>
        <comment>volume.voxel-file-not-read</comment>
        <translation>无法读取体素文件（%1）。</translation>
    </message>
    <message>
        <source>the voxel data start with the header of another volume. Open that file itself, or set the number of bytes to skip (-1 if the voxels are at the end).</source>
        <comment>volume.voxels-are-header</comment>
        <translation>其体素数据以另一个体数据的文件头开始。请直接打开该文件，或指定要跳过的字节数：体素位于末尾时为 -1。</translation>
    </message>
    <message>
        <source>the volume contains no finite voxel values. Export it again.</source>
        <comment>volume.no-numbers</comment>
        <translation>体数据中没有有限的体素值。请重新导出。</translation>
    </message>
    <message>
        <source>Some voxel values are not numbers (%1 voxels); they are set to the lowest value.</source>
        <comment>volume.not-numbers</comment>
        <translation>%1 个体素不是数字；设为最低值。</translation>
    </message>
    <message>
        <source>The %1 voxels are rounded to 16 bits, in steps of %2.</source>
        <comment>volume.rounded</comment>
        <translation>%1 体素舍入为 16 位，步长 %2。</translation>
    </message>
    <message>
        <source>The header does not specify the orientation of the axes: i toward the left, j posterior and k superior are assumed. Check left and right.</source>
        <comment>volume.axes-assumed</comment>
        <translation>文件头未说明轴的方向：假定 i 向左、j 向后、k 向头。请核对左右。</translation>
    </message>
    <message>
        <source>The header does not specify the orientation of the voxels: +x (right to left), +y (anterior to posterior) and +z (superior) are assumed to correspond to i, reversed j and k. Check left and right.</source>
        <comment>volume.voxels-assumed</comment>
        <translation>文件头未说明体素方位：假定 +x（右到左）、+y（前到后）、+z（向上）分别为 i、反向 j 和 k。请核对左右。</translation>
    </message>
    <message>
        <source>The header contains no voxel size: 1 × 1 × 1 mm is assumed.</source>
        <comment>volume.size-assumed</comment>
        <translation>文件头无体素大小：假定为 1 × 1 × 1 mm。</translation>
    </message>
    <message>
        <source>The voxel size is specified as 1 × 1 × 1 mm: check that the true size was not lost in a conversion.</source>
        <comment>volume.size-of-one</comment>
        <translation>体素大小为 1 × 1 × 1 mm：请确认未在转换中丢失。</translation>
    </message>
    <message>
        <source>NIfTI supports at most 32767 voxels along an axis. Save the volume as .nrrd or .mha.</source>
        <comment>volume.nifti-too-long</comment>
        <translation>NIfTI 每轴最多 32767 个体素。请保存为 .nrrd 或 .mha。</translation>
    </message>
    <message>
        <source>volumes can be written as .nii, .nii.gz, .nrrd or .mha. Change the extension.</source>
        <comment>volume.extension</comment>
        <translation>体数据可写为 .nii、.nii.gz、.nrrd 或 .mha。请更改扩展名。</translation>
    </message>
    <message>
        <source>there are no voxels to write. Load a volume first.</source>
        <comment>volume.nothing-to-write</comment>
        <translation>没有可写入的体素。请先载入体数据。</translation>
    </message>
    <message>
        <source>there is not enough memory to compress the volume.</source>
        <comment>volume.no-memory-to-pack</comment>
        <translation>内存不足，无法压缩体数据。</translation>
    </message>
    <message>
        <source>this DICOM file is not a segmentation. Choose a label image.</source>
        <comment>labels.no-segmentation</comment>
        <translation>该 DICOM 文件不是分割结果。请选择标签图像。</translation>
    </message>
    <message>
        <source>the file contains only a single slice, not a volume. Choose the complete segmentation.</source>
        <comment>labels.one-plane</comment>
        <translation>它只含一个层面，不是体数据。请选择完整的分割。</translation>
    </message>
    <message>
        <source>the file contains the value %1, which is not a label: labels are non-negative integers. Choose a label image.</source>
        <comment>labels.no-whole-number</comment>
        <translation>文件含有数值 %1，不是标签：标签为非负整数。请选择标签图像。</translation>
    </message>
    <message>
        <source>the file contains no labeled voxels: all voxels are background. Choose another segmentation.</source>
        <comment>labels.nothing-marked</comment>
        <translation>其中没有标记的体素：所有体素均为背景。请选择其他分割。</translation>
    </message>
    <message>
        <source>there is no label %1. Choose one of the available labels: %2.</source>
        <comment>labels.no-such-number</comment>
        <translation>没有标签 %1。可用标签：%2。请从中选择。</translation>
    </message>
    <message>
        <source>there is no label &quot;%1&quot;. Choose one of the available labels: %2.</source>
        <comment>labels.no-such-name</comment>
        <translation>没有标签“%1”。可用标签：%2。请从中选择。</translation>
    </message>
    <message>
        <source>none</source>
        <comment>labels.none</comment>
        <translation>无</translation>
    </message>
    <message>
        <source>Labels traced: %1.</source>
        <comment>labels.traced</comment>
        <translation>已提取的标签：%1。</translation>
    </message>
    <message>
        <source>Labels skipped because of their names: %1.</source>
        <comment>labels.left-out</comment>
        <translation>因名称而跳过的标签：%1。</translation>
    </message>
    <message>
        <source>The volume contains labels; the vessels are taken directly from these.</source>
        <comment>labels.volume-holds-labels</comment>
        <translation>该体数据含有标签；血管直接取自这些标签。</translation>
    </message>
    <message>
        <source>Measuring lengths at the vessels requires the depth of the vessels. Open a vessel tree, or measure at the detector or in pixels.</source>
        <comment>measure.needs-vessels</comment>
        <translation>测量血管处的长度需要血管的深度。请打开血管，或在探测器处测量，或以像素测量。</translation>
    </message>
    <message>
        <source>The vessels lie behind the X-ray source, so lengths at the vessels cannot be measured. Correct the pose, or measure in pixels.</source>
        <comment>measure.behind-source</comment>
        <translation>血管位于 X 射线源后方，无法在该处测量。请修正位姿，或以像素测量。</translation>
    </message>
    <message>
        <source>The pixel spacing of the detector is unknown. Enter it under Geometry, or measure in pixels.</source>
        <comment>measure.needs-spacing</comment>
        <translation>探测器的像素间距未知。请在“几何”中输入，或以像素测量。</translation>
    </message>
    <message>
        <source>This type of measurement requires at least %1 points, but has only %2. Draw the measurement again.</source>
        <comment>measure.points</comment>
        <translation>此类测量至少需要 %1 个点；此处只有 %2 个。请重新绘制。</translation>
    </message>
    <message>
        <source>A point of the measurement has a non-finite coordinate. Draw the measurement again.</source>
        <comment>measure.not-finite</comment>
        <translation>测量的某个点含有非有限坐标。请重新绘制。</translation>
    </message>
    <message>
        <source>One side of the angle has zero length. Move its two points apart.</source>
        <comment>measure.angle-open</comment>
        <translation>该角有一条边长度为零。请移开各点。</translation>
    </message>
    <message>
        <source>The outline intersects itself, so its area is undefined. Move its points.</source>
        <comment>measure.crossed</comment>
        <translation>轮廓自相交，面积无定义。请移动各点。</translation>
    </message>
    <message>
        <source>%1 at the vessels</source>
        <comment>measure.at-vessels</comment>
        <translation>%1（血管处）</translation>
    </message>
    <message>
        <source>%1 at the detector</source>
        <comment>measure.at-detector</comment>
        <translation>%1（探测器处）</translation>
    </message>
    <message>
        <source>%1</source>
        <comment>measure.plain</comment>
        <translation>%1</translation>
    </message>
    <message>
        <source>%1 (scale assumed)</source>
        <comment>measure.assumed</comment>
        <translation>%1（比例尺为假定值）</translation>
    </message>
    <message>
        <source>Pixel size %2 at the depth of the vessel centroid (%1 from the source). Segments that run toward or away from the source are longer than they appear.</source>
        <comment>measure.basis-vessels</comment>
        <translation>在血管质心的深度（距射线源 %1），像素大小为 %2。朝向或背离射线源走行的血管段比看起来更长。</translation>
    </message>
    <message>
        <source>Pixel size %1 at the detector. Structures in the patient are smaller by the magnification factor.</source>
        <comment>measure.basis-detector</comment>
        <translation>探测器处像素大小为 %1。患者体内的结构按放大倍数更小。</translation>
    </message>
    <message>
        <source>In image pixels only; no physical scale.</source>
        <comment>measure.basis-pixels</comment>
        <translation>仅为图像像素；无物理比例尺。</translation>
    </message>
    <message>
        <source>Projected angle; the true 3-D angle differs.</source>
        <comment>measure.basis-angle</comment>
        <translation>投影角度；真实的三维角度不同。</translation>
    </message>
    <message>
        <source>Pixels are assumed to be square.</source>
        <comment>measure.square-pixels</comment>
        <translation>假定像素为正方形。</translation>
    </message>
    <message>
        <source>The geometry used for this scale is assumed, not measured; its relative error carries over to this value.</source>
        <comment>measure.scale-assumed</comment>
        <translation>此比例尺所依据的几何为假定值，并非实测；其相对误差会传递到该数值。</translation>
    </message>
    <message>
        <source>The geometry used for this scale was entered manually.</source>
        <comment>measure.scale-typed</comment>
        <translation>此比例尺所依据的几何为手动输入。</translation>
    </message>
    <message>
        <source>This pose was not determined by a registration; the depth of the vessels is unverified.</source>
        <comment>measure.depth-unchecked</comment>
        <translation>此位姿并非由配准得到；血管深度未经验证。</translation>
    </message>
    <message>
        <source>The registration that determined this pose is not reliable, and neither is the depth of the vessels.</source>
        <comment>measure.pose-doubtful</comment>
        <translation>此位姿所依据的配准不可靠，血管深度亦不可靠。</translation>
    </message>
    <message>
        <source>Depth uncertainty: ±%1 (1-σ), which corresponds to ±%2 of the measured length.</source>
        <comment>measure.depth-spread</comment>
        <translation>深度不确定度：±%1（1-σ），即长度的 ±%2。</translation>
    </message>
    <message>
        <source>this type of measurement requires at least %1 points, not %2. Add points, or remove the measurement.</source>
        <comment>case.measurement-points</comment>
        <translation>此类测量至少需要 %1 个点，而非 %2 个。请补充点或移除该测量。</translation>
    </message>
    <message>
        <source>Branch %1 has zero length, so nothing can be measured along it. Trace the branch again.</source>
        <comment>measure.branch-no-length</comment>
        <translation>分支 %1 没有长度，无法沿其测量。请重新提取。</translation>
    </message>
    <message>
        <source>This branch has no radii, so its diameter is unknown. Trace the vessels in a scan, or open a tree with radii.</source>
        <comment>measure.branch-no-radii</comment>
        <translation>此分支没有半径，因此直径未知。请从扫描提取血管，或打开带半径的血管树。</translation>
    </message>
    <message>
        <source>No segment of this branch is uniform enough to serve as a reference; no stenosis is reported.</source>
        <comment>measure.branch-no-reference</comment>
        <translation>此分支没有足够均匀的节段可作参考；不报告狭窄。</translation>
    </message>
    <message>
        <source>No scale was entered for this image. Enter the pixel size, or measure in pixels.</source>
        <comment>measure.needs-typed-scale</comment>
        <translation>此图像未输入比例尺。请输入一个像素的大小，或以像素测量。</translation>
    </message>
    <message>
        <source>%1 (scale entered)</source>
        <comment>measure.by-typed</comment>
        <translation>%1（比例尺为输入值）</translation>
    </message>
    <message>
        <source>Pixel size %1, as entered for this image. Valid only at the depth at which it was determined.</source>
        <comment>measure.basis-typed</comment>
        <translation>像素大小 %1，按为此图像输入的值。仅在测定该值的深度处成立。</translation>
    </message>
    <message>
        <source>Not marked in this frame. Choose “Mark target point in image” and click the point.</source>
        <comment>check.not-seen</comment>
        <translation>在此帧中未标记。请选择“在图像中标记目标点”，然后点击该点。</translation>
    </message>
    <message>
        <source>Marked in frame %1, but the pose belongs to frame %2. Go to the marked frame, or mark the point in the current frame.</source>
        <comment>check.other-frame</comment>
        <translation>在第 %1 帧中标记，但位姿属于第 %2 帧。请转到已标记的帧，或在本帧中标记该点。</translation>
    </message>
    <message>
        <source>At this pose, the point lies behind the X-ray source. Correct the pose.</source>
        <comment>check.behind-source</comment>
        <translation>在此位姿下该点位于 X 射线源后方。请修正位姿。</translation>
    </message>
    <message>
        <source>In the image plane at the depth of the point (%1 from the source): %2, %3. The pixel size there is %4, which limits the click accuracy.</source>
        <comment>check.image-error</comment>
        <translation>在该点深度的图像平面内（距射线源 %1）：%2，%3。该处一个像素为 %4，这限制了点击的精度。</translation>
    </message>
    <message>
        <source>The pose covariance predicts an error of %1 at this point (1-σ).</source>
        <comment>check.claimed</comment>
        <translation>由位姿协方差预测该点处为 %1（1-σ）。</translation>
    </message>
    <message>
        <source>This pose was not determined by a registration; no error is predicted.</source>
        <comment>check.nothing-claimed</comment>
        <translation>此位姿并非由配准得到；不预测误差。</translation>
    </message>
    <message>
        <source>With deformed vessels: %1.</source>
        <comment>check.bent</comment>
        <translation>血管变形后：%1。</translation>
    </message>
    <message>
        <source>In 3-D, where the rays of views %1 are closest to each other (angle %2): %3. Distance between the rays: %4.</source>
        <comment>check.space-error</comment>
        <translation>在三维空间中，视图 %1 的射线最接近处（夹角 %2）：%3。射线间距：%4。</translation>
    </message>
    <message>
        <source>A 3-D error can be computed only if the point is marked in two views; it is currently marked in at most one.</source>
        <comment>check.needs-two-views</comment>
        <translation>三维误差要求在两个视图中标记该点；目前至多在一个视图中标记。</translation>
    </message>
    <message>
        <source>The views show the point from almost the same direction (angle between the rays: %1), so its depth cannot be determined.</source>
        <comment>check.rays-alike</comment>
        <translation>各视图几乎从同一方向观察该点（射线夹角 %1），无法确定其深度。</translation>
    </message>
    <message>
        <source>error %1</source>
        <comment>check.label</comment>
        <translation>误差 %1</translation>
    </message>
    <message>
        <source>error %1, predicted %2</source>
        <comment>check.label-claimed</comment>
        <translation>误差 %1，预测 %2</translation>
    </message>
    <message>
        <source>⌀ %1</source>
        <comment>check.ring-width</comment>
        <translation>⌀ %1</translation>
    </message>
    <message>
        <source>This branch has no radius here, so the size of a ring is undefined. Add a target point instead.</source>
        <comment>check.ring-needs-radius</comment>
        <translation>该分支在此处没有半径，环将没有大小。请改为添加目标点。</translation>
    </message>
    <message>
        <source>Click the vessels: target points and rings must lie on them.</source>
        <comment>check.needs-vessels</comment>
        <translation>请点击血管：目标点和环必须位于血管上。</translation>
    </message>
    <message>
        <source>Patient coordinates: x %1, y %2, z %3.</source>
        <comment>check.place</comment>
        <translation>患者坐标 x %1，y %2，z %3。</translation>
    </message>
    <message>
        <source>two marks have the number %1. Give each a unique number.</source>
        <comment>case.mark-twice</comment>
        <translation>两个标记的编号均为 %1。请为每个指定唯一编号。</translation>
    </message>
    <message>
        <source>a ring requires a radius greater than 0 and a direction. Add both, or remove the ring.</source>
        <comment>case.ring-open</comment>
        <translation>环需要大于 0 的半径和方向。请补充，或移除该环。</translation>
    </message>
    <message>
        <source>an arrow requires two points and a text annotation one point. Correct the points, or remove the annotation.</source>
        <comment>case.annotation-points</comment>
        <translation>箭头需要两个点，文字需要一个点。请修正这些点，或移除该标注。</translation>
    </message>
    <message>
        <source>Scan voxel size: %1 × %2 × %3.</source>
        <comment>measure.basis-scan</comment>
        <translation>扫描体素大小：%1 × %2 × %3。</translation>
    </message>
    <message>
        <source>In scan voxels; the voxel size is unknown because the scan is not open.</source>
        <comment>measure.basis-scan-away</comment>
        <translation>扫描体素；扫描未打开，因此大小未知。</translation>
    </message>
    <message>
        <source>Angle in the slice plane; if a side leaves the plane, the 3-D angle differs.</source>
        <comment>measure.basis-scan-angle</comment>
        <translation>层面内的角度；若有一边离开该平面，三维角度会不同。</translation>
    </message>
    <message>
        <source>this is a report, not an image.</source>
        <comment>study.report</comment>
        <translation>这是报告，不是图像。</translation>
    </message>
    <message>
        <source>this object only defines how other images are displayed.</source>
        <comment>study.presentation</comment>
        <translation>它只规定其他图像如何显示。</translation>
    </message>
    <message>
        <source>this object contains no image (%1).</source>
        <comment>study.no-image</comment>
        <translation>其中没有图像（%1）。</translation>
    </message>
    <message>
        <source>this is a scout (localizer), neither a volume nor an angiogram.</source>
        <comment>study.scout</comment>
        <translation>这是定位像，既非体数据也非血管造影。</translation>
    </message>
    <message>
        <source>the frames are compressed as video, which is not supported. Export the run in another format.</source>
        <comment>study.video</comment>
        <translation>其帧以视频方式压缩，不受支持。请以其他格式导出。</translation>
    </message>
    <message>
        <source>AngioPose does not trace vessels in images of modality %1.</source>
        <comment>study.modality</comment>
        <translation>AngioPose 不在 %1 模态的图像中提取血管。</translation>
    </message>
    <message>
        <source>this is listed in the DICOMDIR, but the files are missing.</source>
        <comment>study.missing</comment>
        <translation>DICOMDIR 中已列出，但文件缺失。</translation>
    </message>
    <message>
        <source>it contains no file list</source>
        <comment>directory.no-records</comment>
        <translation>其中没有文件列表</translation>
    </message>
    <message>
        <source>the records are not linked consistently</source>
        <comment>directory.torn</comment>
        <translation>其记录之间的链接不一致</translation>
    </message>
    <message>
        <source>it ends in the middle of a record</source>
        <comment>directory.unfinished</comment>
        <translation>它在记录中间被截断</translation>
    </message>
    <message>
        <source>movies can be saved as .mp4 or .gif. Choose one of these.</source>
        <comment>movie.kind</comment>
        <translation>影片可写为 .mp4 或 .gif 格式。请选择其一。</translation>
    </message>
    <message>
        <source>a movie must have at least %1 pixels per side. Choose a larger size.</source>
        <comment>movie.too-small</comment>
        <translation>影片每边至少 %1 像素。请选择更大的尺寸。</translation>
    </message>
    <message>
        <source>MP4 does not support frames of %1 × %2 pixels: the limits are 9,437,184 pixels per frame (4096 × 2304) and 8688 pixels per side. Choose a smaller size, or GIF.</source>
        <comment>movie.too-large</comment>
        <translation>MP4 不支持 %1 × %2 像素的帧：上限为 9,437,184 像素（4096 × 2304），每边 8688。请选择更小的尺寸或 GIF。</translation>
    </message>
    <message>
        <source>a GIF of %1 × %2 pixels is too large: the limit is %3 pixels per side. Choose a smaller size.</source>
        <comment>movie.gif-too-large</comment>
        <translation>%1 × %2 像素的 GIF 过大：每边上限为 %3。请选择更小的尺寸。</translation>
    </message>
    <message>
        <source>all frames of a movie must have the same size.</source>
        <comment>movie.sizes-differ</comment>
        <translation>影片的所有帧大小必须相同。</translation>
    </message>
    <message>
        <source>the movie could not be encoded. Choose another size, or GIF.</source>
        <comment>movie.encoder-failed</comment>
        <translation>影片无法编码。请选择其他尺寸或 GIF。</translation>
    </message>
    <message>
        <source>the movie would exceed 1 GB. Choose fewer frames or a smaller size.</source>
        <comment>movie.too-long</comment>
        <translation>影片将超过 1 GB。请选择更少的帧或更小的尺寸。</translation>
    </message>
    <message>
        <source>the movie could not be written. Choose another size or format.</source>
        <comment>movie.not-made</comment>
        <translation>影片无法写出。请选择其他尺寸或格式。</translation>
    </message>
    <message>
        <source>The report template %1 cannot be read: a template must be UTF-8 text of at most 1 MB. Choose another template, or the built-in one.</source>
        <comment>report.template-unreadable</comment>
        <translation>无法读取报告模板 %1：模板必须是不超过 1 MB 的 UTF-8 文本。请选择其他模板或内置模板。</translation>
    </message>
    <message>
        <source>The report template does not contain %1. Without it, a report could omit information that must be read together with the result. Add it to the template.</source>
        <comment>report.template-lacks</comment>
        <translation>报告模板缺少 %1。没有它，报告可能遗漏必须与结果一并阅读的信息。请补上。</translation>
    </message>
    <message>
        <source>The report template contains %1, which is not a known placeholder. Known placeholders: %2.</source>
        <comment>report.template-unknown</comment>
        <translation>报告模板含有 %1，不是已知的占位符。已知的占位符：%2。</translation>
    </message>
    <message>
        <source>The report template contains “%1”, which could load or run other content. Remove it.</source>
        <comment>report.template-fetches</comment>
        <translation>报告模板含有“%1”，可能借此加载或运行其他内容。请将其删除。</translation>
    </message>
    <message>
        <source>The image %1 of the report template cannot be read. Place it next to the template, as a PNG or JPEG file of at most 16 MB and 8192 pixels per side.</source>
        <comment>report.template-picture</comment>
        <translation>无法读取报告模板的图像 %1。请将其放在模板旁边，格式为 PNG 或 JPEG，不超过 16 MB，每边不超过 8192 像素。</translation>
    </message>
    <message>
        <source>the images together exceed the size limit of a DICOM object. Choose a smaller width or fewer frames.</source>
        <comment>object.too-large</comment>
        <translation>这些图像的总量超过一个 DICOM 对象的大小上限。请选择较小的宽度或较少的帧。</translation>
    </message>
    <message>
        <source>this is not a PDF. Export the report as PDF first.</source>
        <comment>object.no-pdf</comment>
        <translation>这不是 PDF。请先将报告导出为 PDF。</translation>
    </message>
    <message>
        <source>a presentation state must reference a DICOM image, but this angiogram cannot be referenced. Open it as DICOM, or leave out the presentation state.</source>
        <comment>object.no-reference</comment>
        <translation>显示状态必须引用一幅 DICOM 图像，而此血管造影无法被引用。请以 DICOM 打开，或不导出显示状态。</translation>
    </message>
    <message>
        <source>no vessels lie within the image. Move the vessels into the image first, or leave out the presentation state.</source>
        <comment>object.no-lines</comment>
        <translation>图像上没有血管。请先将血管移到图像上，或不导出显示状态。</translation>
    </message>
    <message>
        <source>the pose is not a rigid transform with finite values. Reset it first.</source>
        <comment>object.pose-not-rigid</comment>
        <translation>该位姿不是数值有限的刚性变换。请先重置位姿。</translation>
    </message>
    <message>
        <source>no vessel lies within the scan. Check that the scan and the vessels belong to the same patient, or leave out the segmentation.</source>
        <comment>object.no-voxels</comment>
        <translation>扫描中没有血管。请检查扫描与血管是否属于同一患者，或不导出分割。</translation>
    </message>
    <message>
        <source>there is neither a measurement nor a registration result. Create one of them first, or leave out the measurements.</source>
        <comment>object.nothing-measured</comment>
        <translation>既没有测量，也没有配准结果。请先完成其中之一，或不导出测量。</translation>
    </message>
    <message>
        <source>this DICOM file contains no registration between two frames of reference. Choose a Spatial Registration object.</source>
        <comment>pose.no-registration</comment>
        <translation>此 DICOM 文件不含两个参考坐标系之间的配准。请选择空间配准。</translation>
    </message>
    <message>
        <source>a segmentation requires the scan or mask from which the vessels were traced. Open it first, or leave out the segmentation.</source>
        <comment>dicom-export.no-scan</comment>
        <translation>分割需要血管所来自的扫描或掩膜。请先打开，或不导出分割。</translation>
    </message>
    <message>
        <source>the program angiopose, which creates the reports, was not found at &apos;%1&apos;. Install it next to angiopose-cli, or build the target angiopose.</source>
        <comment>report.program-missing</comment>
        <translation>“%1”处没有写出报告的程序 angiopose。请将其安装在 angiopose-cli 旁，或构建目标 angiopose。</translation>
    </message>
    <message>
        <source>The program angiopose was terminated by signal %1; no report was written. Run angiopose-cli support-bundle to collect diagnostic data.</source>
        <comment>report.program-fault</comment>
        <translation>程序 angiopose 被信号 %1 终止；未写出报告。请运行 angiopose-cli support-bundle 收集诊断信息。</translation>
    </message>
    <message>
        <source>the report was written. It states that this pose is not reliable, and why.</source>
        <comment>report.distrusted</comment>
        <translation>报告已写出。其中说明此位姿不可靠及其原因。</translation>
    </message>
    <message>
        <source>stopped; no report was written.</source>
        <comment>report.stopped</comment>
        <translation>已停止；未写出报告。</translation>
    </message>
    <message>
        <source>reports are created with `angiopose-cli report` or in the window. Pass the PDF with --report, or leave out the report.</source>
        <comment>dicom-export.no-report</comment>
        <translation>报告由 angiopose-cli report 或在窗口中生成。请用 --report 给出其 PDF，或不导出。</translation>
    </message>
    <message>
        <source>Not exported: %1: %2</source>
        <comment>dicom-export.left-out</comment>
        <translation>未导出：%1：%2</translation>
    </message>
    <message>
        <source>The angiogram is not a DICOM image: the exported objects form a new study without a patient.</source>
        <comment>dicom-export.new-study</comment>
        <translation>此血管造影不是 DICOM 图像：导出的对象自成一个新检查，不含患者。</translation>
    </message>
    <message>
        <source>The scan is not a DICOM series: the segmentation references no series and has its own frame of reference.</source>
        <comment>dicom-export.no-scan-study</comment>
        <translation>此扫描不是 DICOM 序列：其分割不引用任何序列，并有自己的参考坐标系。</translation>
    </message>
    <message>
        <source>A Spatial Registration object contains only a rigid matrix. It cannot store the perspective camera, which an overlay requires. The camera is stored in private elements and in the accompanying file camera.json.</source>
        <comment>dicom-export.rigid-only</comment>
        <translation>空间配准只含一个刚性矩阵，无法保存叠加显示所需的透视相机。相机保存在其私有元素和随附的 camera.json 中。</translation>
    </message>
    <message>
        <source>The presentation state shows the image as stored, without subtraction: its gray values differ from those shown here.</source>
        <comment>dicom-export.treated</comment>
        <translation>显示状态显示的是存储的未减影图像：其灰度值与此处所示不同。</translation>
    </message>
    <message>
        <source>none of these objects can be created from this case. Open vessels and an angiogram first.</source>
        <comment>dicom-export.nothing</comment>
        <translation>此病例无法导出为任何一种对象。请先打开血管和血管造影。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is unknown. Use one of these: %2.</source>
        <comment>dicom-export.kind-unknown</comment>
        <translation>“%1”未知。请使用以下之一：%2。</translation>
    </message>
    <message>
        <source>stopped; nothing was written.</source>
        <comment>dicom-export.stopped</comment>
        <translation>已停止；未写出任何内容。</translation>
    </message>
    <message>
        <source>Vessels of a registered 3-D tree overlaid on the image, with the selected window and size</source>
        <comment>dicom-export.derivation</comment>
        <translation>在图像上叠加已配准三维血管树的血管，采用所选窗宽窗位和大小</translation>
    </message>
    <message>
        <source>No registration is recorded for this pose. Register first.</source>
        <comment>movie.no-history</comment>
        <translation>此位姿没有配准记录。请先配准。</translation>
    </message>
    <message>
        <source>stopped before the movie was complete; nothing was written.</source>
        <comment>movie.stopped</comment>
        <translation>影片尚未完成即已停止。未写出任何内容。</translation>
    </message>
    <message>
        <source>pose of frame %1</source>
        <comment>movie.pose-of-frame</comment>
        <translation>第 %1 帧的位姿</translation>
    </message>
    <message>
        <source>pose tracked to this frame</source>
        <comment>movie.followed</comment>
        <translation>跟踪到此帧的位姿</translation>
    </message>
    <message>
        <source>pose tracked to this frame · not reliable</source>
        <comment>movie.followed-distrusted</comment>
        <translation>跟踪到此帧的位姿 · 不可靠</translation>
    </message>
    <message>
        <source>step %1 of %2 · median %3</source>
        <comment>movie.step</comment>
        <translation>第 %1 步，共 %2 步 · 中位数 %3</translation>
    </message>
    <message>
        <source>step %1 of %2 · median %3 · result not reliable</source>
        <comment>movie.step-distrusted</comment>
        <translation>第 %1 步，共 %2 步 · 中位数 %3 · 结果不可靠</translation>
    </message>
    <message>
        <source>frontal view, rotated by %1</source>
        <comment>movie.turned</comment>
        <translation>前视图，旋转 %1</translation>
    </message>
    <message>
        <source>the file cannot be written: it would exceed the file size limit of the system (ulimit -f) or of the drive. Raise the limit, or choose another folder.</source>
        <comment>file.beyond-limit</comment>
        <translation>无法写入：将超过系统（ulimit -f）或驱动器的文件大小上限。请提高上限，或选择另一个文件夹。</translation>
    </message>
    <message>
        <source>the case was changed elsewhere after it was opened here. Save it under another name, or reopen it.</source>
        <comment>case.changed-elsewhere</comment>
        <translation>病例在此处打开后，已在别处被更改。请以其他名称保存，或重新打开。</translation>
    </message>
    <message>
        <source>the case is also open elsewhere (process %1 on %2). Save it under another name, or close it there.</source>
        <comment>case.open-elsewhere</comment>
        <translation>病例也在别处打开（%2 上的进程 %1）。请以其他名称保存，或在那里将其关闭。</translation>
    </message>
    <message>
        <source>the table lists no cases. Start with a header row that contains a case column and either a reference or a pairs column; add one row per case.</source>
        <comment>own.no-header</comment>
        <translation>未列出任何病例。请以表头行开始，包含 case 列以及 reference 或 pairs 列之一；每个病例一行。</translation>
    </message>
    <message>
        <source>line %1 specifies no case. Enter the path of a case file in the case column.</source>
        <comment>own.no-case</comment>
        <translation>第 %1 行没有指定病例。请在 case 列填写病例文件的路径。</translation>
    </message>
    <message>
        <source>line %1 has no ground truth. Specify a pose in the reference column, or a table of point pairs in the pairs column.</source>
        <comment>own.no-truth</comment>
        <translation>第 %1 行没有真值。请在 reference 列给出位姿，或在 pairs 列给出点对表。</translation>
    </message>
    <message>
        <source>line %1 specifies the true vessel positions in the bent column. This requires a pose in the reference column and cannot be combined with landmarks, which would also have to be deformed.</source>
        <comment>own.bent-alone</comment>
        <translation>第 %1 行在 bent 列给出了血管的真实位置。这需要 reference 列中的位姿，且不能同时使用标志点，因为标志点也必须随之变形。</translation>
    </message>
    <message>
        <source>the branches or their numbers of points differ from those of the vessels of the case. Deformed vessels are evaluated point by point: create them by moving the points of the case&apos;s own vessel file.</source>
        <comment>own.bent-other</comment>
        <translation>其分支或各分支的点数与病例血管不一致。变形的血管逐点评估：请移动病例自身血管文件中的点。</translation>
    </message>
    <message>
        <source>line %1: &apos;%2&apos; is not a valid condition name. It is used in file names: use only letters, digits, periods, hyphens and underscores.</source>
        <comment>own.condition-name</comment>
        <translation>第 %1 行：&apos;%2&apos; 不是有效的条件名称。该名称用于文件名：请只使用字母、数字、点、连字符和下划线。</translation>
    </message>
    <message>
        <source>a column is named &apos;pose.&apos; without a name after the period. Add the name of the method or person that determined these poses.</source>
        <comment>own.pose-without-name</comment>
        <translation>有一列名为 pose. 但点后没有名称。请补充求得这些位姿的方法或人员的名称。</translation>
    </message>
    <message>
        <source>column %1 is missing. Landmarks require x, y, z (mm, LPS); point pairs also require u and v (px).</source>
        <comment>own.point-column-missing</comment>
        <translation>缺少列 %1。标志点需要 x、y、z（mm，LPS），点对还需要 u 和 v（px）。</translation>
    </message>
    <message>
        <source>the table contains no points.</source>
        <comment>own.no-points</comment>
        <translation>表中没有点。</translation>
    </message>
    <message>
        <source>column %1 is missing: this is not a blind trial log, or it was written by an earlier version that did not store the centroid. Create a new log with Registration &gt; Blind observer trial.</source>
        <comment>observers.column-missing</comment>
        <translation>缺少列 %1：这不是盲法试验日志，或由未保存质心的早期版本写出。请用 配准 &gt; 观察者盲法试验 生成新的日志。</translation>
    </message>
    <message>
        <source>The logs contain no two finished trials of the same image, so there is nothing to compare. Have an observer repeat a trial, or have another observer perform it.</source>
        <comment>observers.too-few</comment>
        <translation>日志中没有同一图像的两次已完成试验，因此无从比较。请让观察者重复试验，或由另一位观察者进行。</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a valid key of %2. Valid keys: %3.</source>
        <comment>study.unknown-key</comment>
        <translation>&apos;%1&apos; 不是 %2 的有效键。有效的键：%3。</translation>
    </message>
    <message>
        <source>%1 has no &apos;%2&apos;.</source>
        <comment>study.missing-key</comment>
        <translation>%1 缺少 &apos;%2&apos;。</translation>
    </message>
    <message>
        <source>&apos;%1&apos; of %2 has an invalid value: %3.</source>
        <comment>study.wrong-value</comment>
        <translation>%2 的 &apos;%1&apos; 的值无效：%3。</translation>
    </message>
    <message>
        <source>this is not a study file. A study file must begin with &quot;format&quot;: &quot;angiopose-study&quot;, &quot;version&quot;: 1.</source>
        <comment>study.no-study</comment>
        <translation>这不是研究文件。文件须以 &quot;format&quot;: &quot;angiopose-study&quot;, &quot;version&quot;: 1 开头。</translation>
    </message>
    <message>
        <source>two settings are named &apos;%1&apos;. Give each setting a unique name, which is also used as its folder name.</source>
        <comment>study.name-twice</comment>
        <translation>有两个设置都名为 &apos;%1&apos;。请为每个设置取唯一的名称：文件夹以其命名。</translation>
    </message>
    <message>
        <source>&apos;%1&apos; of %2 must be between %3 and %4.</source>
        <comment>study.out-of-range</comment>
        <translation>%2 的 &apos;%1&apos; 必须在 %3 与 %4 之间。</translation>
    </message>
    <message>
        <source>`evaluate own` requires a table of cases with reference data: angiopose-cli evaluate own CASES.csv --output FOLDER.</source>
        <comment>evaluate.no-manifest</comment>
        <translation>`evaluate own` 需要一张含参考数据的病例表：angiopose-cli evaluate own CASES.csv --output FOLDER。</translation>
    </message>
    <message>
        <source>`evaluate observers` requires a blind trial log: angiopose-cli evaluate observers TRIALS.csv --output FOLDER.</source>
        <comment>evaluate.no-log</comment>
        <translation>`evaluate observers` 需要盲法试验日志：angiopose-cli evaluate observers TRIALS.csv --output FOLDER。</translation>
    </message>
    <message>
        <source>The experiment &apos;%1&apos; generates its own trials. Omit &apos;%2&apos;, or write `evaluate own %2`.</source>
        <comment>evaluate.input-of-experiment</comment>
        <translation>实验 &apos;%1&apos; 自行生成试验。请去掉 &apos;%2&apos;，或写 `evaluate own %2`。</translation>
    </message>
    <message>
        <source>`simulate` requires --seed for one case or --study for many.</source>
        <comment>simulate.what</comment>
        <translation>`simulate` 需要 --seed（单个病例）或 --study（多个病例）。</translation>
    </message>
    <message>
        <source>Some voxel values (%1 voxels) are far outside the range of all others (%2 to %3); they are clamped to that range.</source>
        <comment>volume.stray-values</comment>
        <translation>%1 个体素远超其余体素的范围（%2 至 %3）；已截断到该范围。</translation>
    </message>
    <message>
        <source>the output was not written completely: the drive or pipe used for standard output is full or closed. Free up space, or redirect the output.</source>
        <comment>run.output-not-written</comment>
        <translation>输出未完整写出：标准输出所连的驱动器或管道已满或已关闭。请腾出空间，或重定向输出。</translation>
    </message>
    <message>
        <source>the audit log cannot be written (%1), so actions are not recorded. Free up space, or grant write permission.</source>
        <comment>audit.not-written</comment>
        <translation>无法写入审计日志（%1），因此操作未被记录。请腾出空间，或允许写入该日志。</translation>
    </message>
    <message>
        <source>The header contains no table position: the vessel position in this view is determined from its image, and only the rotation is derived from the gantry angles.</source>
        <comment>geometry.table-unknown</comment>
        <translation>文件头未给出检查床位置：血管在此视图中的位置由其图像确定，只有旋转取自角度。</translation>
    </message>
    <message>
        <source>The only distance in the headers is (0018,1111), and it differs between the views (%1, %2), so it is not the source-to-isocenter distance. The shift between the views is not used; enter the source-to-isocenter distance (SOD) of both views.</source>
        <comment>geometry.isocenter-unknown</comment>
        <translation>只有 (0018,1111) 给出距离，且在各视图间不同（%1、%2），因此不是等中心距离。不使用视图间的位移；请为两个视图输入射线源到等中心的距离 (SOD)。</translation>
    </message>
    <message>
        <source>The table moved during one of the runs: the shift between the views is treated as unknown (50 mm).</source>
        <comment>geometry.table-moved-in-view</comment>
        <translation>检查床在其中一次采集期间移动：视图间的位移按未知处理（50 mm）。</translation>
    </message>
    <message>
        <source>Almost all lines traced here remain stationary throughout the run, like shutter edges, leads and bones: the frame shows no contrast agent to track.</source>
        <comment>follow.stands-still</comment>
        <translation>此帧提取到的线条几乎都在整个序列中静止不动，如遮光器边缘、导线和骨骼：没有可跟踪的对比剂。</translation>
    </message>
    <message>
        <source>Frame %1 does not exist: the image has frames 1 to %2.</source>
        <comment>frame.missing</comment>
        <translation>第 %1 帧不存在：图像有第 1 到 %2 帧。</translation>
    </message>
    <message>
        <source>Mask frame %1 does not exist (counted from 1). The run has frames 1 to %2.</source>
        <comment>subtraction.mask-frame-missing</comment>
        <translation>蒙片帧 %1 不存在（从 1 开始计数）。序列有第 1 到 %2 帧。</translation>
    </message>
    <message>
        <source>A wide vessel that was not traced runs next to the traced vessels over %1, at %2: possibly the false lumen of a dissection. Place a seed in each lumen to trace both.</source>
        <comment>tracing.other-lumen-beside</comment>
        <translation>一条未提取的粗血管与已提取血管并行 %1，位于 %2：可能是夹层的假腔。请在每个腔内放置种子点以提取两者。</translation>
    </message>
    <message>
        <source>frame %1 does not exist (counted from 0, as in case files). The image has frames 0 to %2.</source>
        <comment>case.frame-missing</comment>
        <translation>第 %1 帧不存在（按病例文件从 0 开始计数）。图像有第 0 到 %2 帧。</translation>
    </message>
    <message>
        <source>The image is shown as specified by its orientation tag (%1): rotated or mirrored relative to the stored pixels.</source>
        <comment>image.turned</comment>
        <translation>图像按其方向标记（%1）显示：相对于存储的像素已旋转或镜像。</translation>
    </message>
    <message>
        <source>page %1 is %2 × %3 pixels, but the first page is %4 × %5 pixels. Export the frames of a single run, all of the same size.</source>
        <comment>image.pages-differ</comment>
        <translation>第 %1 页为 %2 × %3 像素，第一页为 %4 × %5。请导出同一序列中大小一致的各帧。</translation>
    </message>
    <message>
        <source>the file has %1 pages. Export the mask as a single image.</source>
        <comment>centreline.mask-pages</comment>
        <translation>它有 %1 页。请将掩膜导出为单幅图像。</translation>
    </message>
    <message>
        <source>The header declares %1 frames, but the file contains %2; the frames in the file were loaded. Copy or export the file again if frames are missing.</source>
        <comment>dicom.frames-other</comment>
        <translation>文件头声明 %1 帧，文件中有 %2 帧；已载入文件中的帧。如有缺失，请重新复制或导出。</translation>
    </message>
    <message>
        <source>The header contains contradictory frame intervals: Frame Time %1, Frame Time Vector %2. The value used is %3.</source>
        <comment>dicom.frame-times</comment>
        <translation>文件头中的帧间隔互相矛盾：Frame Time %1，Frame Time Vector %2。采用 %3。</translation>
    </message>
    <message>
        <source>a volume reconstructed from projections (modality %1)</source>
        <comment>dicom.reconstruction</comment>
        <translation>由投影重建的体数据（模态 %1）</translation>
    </message>
    <message>
        <source>The %1 shutter in the header (0018,1600) hides the entire image (%2) and is ignored. Check that no shutter edge is traced as a vessel.</source>
        <comment>dicom.shutter-unusable</comment>
        <translation>文件头中的 %1 遮光器 (0018,1600) 遮住了整幅图像（%2），已忽略。请检查遮光器边缘是否被当作血管提取。</translation>
    </message>
    <message>
        <source>Based on %2, the image is assumed to be rotated clockwise by %1. Check the orientation markers (H, L).</source>
        <comment>dicom.image-turned</comment>
        <translation>根据 %2，图像按顺时针旋转 %1 处理。请核对方位标记（H、L）。</translation>
    </message>
    <message>
        <source>Patient Orientation (0020,0020) is %1, which is impossible at these gantry angles. Check the angles, and check whether the image is mirrored or rotated.</source>
        <comment>dicom.orientation-unlike-angles</comment>
        <translation>Patient Orientation (0020,0020) 为 %1，在这些角度下不可能出现。请检查角度，以及图像是否被镜像或旋转。</translation>
    </message>
    <message>
        <source>According to the header, the object is at a distance of %1 and the isocenter at a distance of %2 from the source: the vessels are initially placed at the object distance, and the gantry rotates about the isocenter.</source>
        <comment>dicom.object-off-isocenter</comment>
        <translation>文件头中物体距射线源 %1，等中心距射线源 %2：血管从物体距离处开始配准，C 形臂绕等中心旋转。</translation>
    </message>
    <message>
        <source>The file specifies its unit (&quot;%1&quot;): one unit is read as %2. Specify the unit if this is incorrect.</source>
        <comment>vessels.unit-stated</comment>
        <translation>文件注明了单位（“%1”）：一个单位按 %2 读取。如有误，请指定单位。</translation>
    </message>
    <message>
        <source>The file specifies its unit (&quot;%1&quot;, that is, %2), but one unit is read as %3, as requested. Check the size.</source>
        <comment>vessels.unit-overruled</comment>
        <translation>文件注明了单位（“%1”，即 %2），但按要求一个单位按 %3 读取。请检查大小。</translation>
    </message>
    <message>
        <source>The file specifies two units (&quot;%1&quot; and &quot;%2&quot;). Check the size; if it is wrong, specify the unit.</source>
        <comment>vessels.units-contradict</comment>
        <translation>文件注明了两种单位（“%1”和“%2”）。请检查大小，如有误请指定单位。</translation>
    </message>
    <message>
        <source>the axes are %1, not LPS or RAS. Export the file in patient coordinates (LPS).</source>
        <comment>vessels.axes-other</comment>
        <translation>其坐标轴为 %1，既不是 LPS 也不是 RAS。请以患者坐标（LPS）导出。</translation>
    </message>
    <message>
        <source>In some lines, the first points were stored at the end and have been moved to the beginning (number of lines: %1). Check the vessels.</source>
        <comment>tree.turned-round</comment>
        <translation>部分线的起始点位于末尾，已移回开头（线数：%1）。请检查血管。</translation>
    </message>
    <message>
        <source>The lines contain %1 jumps of up to %2, far beyond their typical point spacing, and were split there. Check the order of the points.</source>
        <comment>tree.leaps</comment>
        <translation>线条跳跃 %1 次，最大 %2，远超典型点距；已在该处断开。请检查点的顺序。</translation>
    </message>
    <message>
        <source>Curve points without a position were skipped (number: %1).</source>
        <comment>tree.markups-not-placed</comment>
        <translation>曲线中有 %1 个点没有位置，已跳过。</translation>
    </message>
    <message>
        <source>the header declares %1 triangles, but the file contains %2. Copy or export the file again.</source>
        <comment>surface.stl-too-few</comment>
        <translation>文件头声明 %1 个三角形，但文件中只有 %2 个。请重新复制或导出。</translation>
    </message>
    <message>
        <source>The header declares %1 triangles, but the file size corresponds to %2; the data after the declared triangles were not read. Check that nothing is missing.</source>
        <comment>surface.stl-too-many</comment>
        <translation>文件头声明 %1 个三角形，但文件大小可容纳 %2 个；声明之后的数据未读取。请检查是否有缺失。</translation>
    </message>
    <message>
        <source>The text ends after %1 triangles without &quot;endsolid&quot; and may be truncated. Check that nothing is missing.</source>
        <comment>surface.stl-without-end</comment>
        <translation>文本在 %1 个三角形后结束且没有“endsolid”，可能被截断。请检查是否有缺失。</translation>
    </message>
    <message>
        <source>the coordinates are in &quot;%1&quot;, which is not a known unit of length. Export them in mm.</source>
        <comment>tree.markups-unit</comment>
        <translation>其坐标单位为“%1”，不是已知的长度单位。请以 mm 导出。</translation>
    </message>
    <message>
        <source>The header contains contradictory slice spacings: %1 (Spacing Between Slices) and %2 (slice positions). The slice positions are used.</source>
        <comment>series.step</comment>
        <translation>文件头中的层间距互相矛盾：%1（Spacing Between Slices），而按层面位置为 %2。采用位置。</translation>
    </message>
    <message>
        <source>part %1 of %2 (acquisition %3)</source>
        <comment>series.acquisition</comment>
        <translation>第 %1 部分，共 %2 部分（采集 %3）</translation>
    </message>
    <message>
        <source>%1 of %2 images of the series share an SOP Instance UID although they differ; all of them are read. Export the series again before archiving it.</source>
        <comment>series.same-uid</comment>
        <translation>该序列 %2 幅图像中有 %1 幅共用 SOP Instance UID，但内容不同；全部读取。归档前请重新导出该序列。</translation>
    </message>
    <message>
        <source>%1 patients or studies share the UID of this series; each is listed separately.</source>
        <comment>series.of-several</comment>
        <translation>%1 个患者或检查共用该序列的 UID；已分别列出。</translation>
    </message>
    <message>
        <source>The header specifies lengths in &quot;%1&quot;, which is not a known unit: millimeters are assumed. Check the voxel size.</source>
        <comment>volume.unit-unknown</comment>
        <translation>文件头的长度单位“%1”未知：按毫米处理。请检查体素大小。</translation>
    </message>
    <message>
        <source>The qform and sform transforms differ by up to %1; the qform transform (scanner coordinates) is used.</source>
        <comment>volume.nifti-qform-used</comment>
        <translation>其 qform 与 sform 变换相差最多 %1；采用扫描仪坐标的 qform。</translation>
    </message>
    <message>
        <source>The qform and sform transforms differ by up to %1; the sform transform is used.</source>
        <comment>volume.nifti-sform-used</comment>
        <translation>其 qform 与 sform 变换相差最多 %1；采用 sform。</translation>
    </message>
    <message>
        <source>The header contains contradictory voxel sizes: %1 (pixdim) and %2 (transform). The size from the transform is used. Check which one is correct.</source>
        <comment>volume.nifti-sizes</comment>
        <translation>文件头中的体素大小互相矛盾：%1（pixdim），而按变换为 %2。采用变换中的值。请确认哪个正确。</translation>
    </message>
    <message>
        <source>The header contains contradictory voxel types: %1 bits (bitpix), but %2 bits according to the datatype (%3). The datatype is used.</source>
        <comment>volume.nifti-bits</comment>
        <translation>文件头中的体素类型互相矛盾：%1 位（bitpix），而按数据类型（%3）为 %2 位；采用数据类型。</translation>
    </message>
    <message>
        <source>The header states that the voxel data begin at byte %1, inside the header itself; they are read from byte %2 instead.</source>
        <comment>volume.nifti-start-within-header</comment>
        <translation>文件头称体素从第 %1 字节开始，但该处位于文件头内；改从第 %2 字节读取。</translation>
    </message>
    <message>
        <source>a voxel size of %1 mm cannot be written. Correct the spacing, origin and directions of the volume.</source>
        <comment>volume.no-size-to-write</comment>
        <translation>无法写入 %1 mm 的体素大小。请更正体数据的间距、原点和方向。</translation>
    </message>
    <message>
        <source>frame %1 does not exist (counted from 1). The run has frames 1 to %2.</source>
        <comment>command.frame-beyond-run</comment>
        <translation>第 %1 帧不存在（从 1 开始计数）。序列有第 1 到 %2 帧。</translation>
    </message>
    <message>
        <source>NOT RELIABLE</source>
        <comment>fit.not-reliable</comment>
        <translation>不可靠</translation>
    </message>
    <message>
        <source>These distances cover only the %1 of the tree that is classified as opacified. Whole tree: median %2, 95th percentile %3.</source>
        <comment>fit.over-opacified</comment>
        <translation>这些距离仅针对判为显影的 %1 血管树。整棵树：中位数 %2，第 95 百分位数 %3。</translation>
    </message>
    <message>
        <source>Excluded branches: %1 (medians). With these included: median %2, 95th percentile %3.</source>
        <comment>fit.without-excluded</comment>
        <translation>排除的分支：%1（中位数）。包括它们：中位数 %2，第 95 百分位数 %3。</translation>
    </message>
    <message>
        <source>Auxiliary branches: %1 (medians).</source>
        <comment>fit.auxiliary</comment>
        <translation>辅助分支：%1（中位数）。</translation>
    </message>
    <message>
        <source>at this pose, all vessels lie at or behind the X-ray source and cannot be projected. Check the pose and its direction (patient to camera).</source>
        <comment>pose.all-behind-source</comment>
        <translation>此位姿下所有血管位于 X 射线源处或其后，无法投影。请检查位姿及其方向（由患者到相机）。</translation>
    </message>
    <message>
        <source>At this pose, no vessel lies inside the image. Check the pose.</source>
        <comment>pose.all-outside-image</comment>
        <translation>此位姿下图像内没有血管。请检查位姿。</translation>
    </message>
    <message>
        <source>frame %1 of %2</source>
        <comment>picture.frame</comment>
        <translation>第 %1 帧，共 %2 帧</translation>
    </message>
    <message>
        <source>Frames %1 to %2 are not a valid range: the run has frames 1 to %3. Choose another range.</source>
        <comment>movie.frames-beyond</comment>
        <translation>第 %1 到 %2 帧不是有效范围：序列有第 1 到 %3 帧。请另选范围。</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Finds the pose of a 3-D vessel tree in a 2-D angiogram. Not for clinical use.</source>
        <translation>求三维血管树在二维造影图像中的位姿。不得用于临床。</translation>
    </message>
    <message>
        <source>A case file, or a centerline and an angiogram.</source>
        <translation>一个病例文件，或一条中心线和一幅血管造影。</translation>
    </message>
    <message>
        <source>Renderer of the angiogram: vtk (OpenGL), painter (CPU), or auto (vtk if a graphics card supports OpenGL).</source>
        <translation>血管造影的渲染器：vtk（OpenGL）、painter（CPU），或 auto（有支持 OpenGL 的显卡时用 vtk）。</translation>
    </message>
    <message>
        <source>Unknown renderer “%1”. Use auto, vtk or painter.</source>
        <translation>未知的渲染器“%1”。请使用 auto、vtk 或 painter。</translation>
    </message>
    <message>
        <source>No display is available for the window. Use angiopose-cli, which provides the same functions without a display.</source>
        <translation>没有可供窗口使用的显示器。请使用 angiopose-cli，它无需显示器即可提供相同功能。</translation>
    </message>
    <message>
        <source>Write the report of a case (.pdf or .html) and exit; requires no display.</source>
        <translation>写出病例的报告（.pdf 或 .html）后退出；不需要显示器。</translation>
    </message>
    <message>
        <source>With --report: register the case first.</source>
        <translation>与 --report 一起：先配准病例。</translation>
    </message>
    <message>
        <source>With --report: template to use instead of the built-in one.</source>
        <translation>与 --report 一起：用以代替内置模板的模板。</translation>
    </message>
    <message>
        <source>With --report: author to use instead of the account name.</source>
        <translation>与 --report 一起：报告的作者，代替账户名。</translation>
    </message>
    <message>
        <source>With --report: include the patient&apos;s identity (omitted by default).</source>
        <translation>与 --report 一起：包含患者身份信息，默认不包含。</translation>
    </message>
    <message>
        <source>With --report: language to use instead of the UI language.</source>
        <translation>与 --report 一起：报告的语言，代替界面语言。</translation>
    </message>
    <message>
        <source>Reports are available in %1, not in “%2”.</source>
        <translation>报告的语言可以是 %1，不能是“%2”。</translation>
    </message>
    <message>
        <source>--register, --template, --author, --identity and --language require --report FILE.</source>
        <translation>--register、--template、--author、--identity 和 --language 需要 --report FILE。</translation>
    </message>
    <message>
        <source>Reports are written as .pdf or .html, not as “%1”.</source>
        <translation>报告以 .pdf 或 .html 写出，而非“%1”。</translation>
    </message>
    <message>
        <source>A report requires exactly one case: angiopose --report FILE CASE</source>
        <translation>一份报告需要恰好一个病例：angiopose --report FILE CASE</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::AngiogramAnnotations</name>
    <message>
        <source>%1 mm at vessel</source>
        <translation>血管处 %1 mm</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::AngiogramPanel</name>
    <message>
        <source>%1 frames earlier</source>
        <translation>提前 %1 帧</translation>
    </message>
    <message>
        <source>none found: set them below</source>
        <translation>未找到：请在下方设置</translation>
    </message>
    <message>
        <source>%1 (automatic)</source>
        <translation>%1（自动）</translation>
    </message>
    <message>
        <source>Angiogram</source>
        <translation>造影</translation>
    </message>
    <message>
        <source>Peak-opacification image</source>
        <translation>全序列最小密度投影</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Chooses the frames before contrast arrival</source>
        <translation>选择对比剂到达前的帧</translation>
    </message>
    <message>
        <source>Computes the mask shift for each frame</source>
        <translation>计算每一帧的蒙片移位</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>手动</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>默认值</translation>
    </message>
    <message>
        <source>Restores the default tracing settings</source>
        <translation>恢复默认的提取设置</translation>
    </message>
    <message>
        <source>Subtract mask</source>
        <translation>减去蒙片</translation>
    </message>
    <message>
        <source>Show native frames</source>
        <translation>显示原始帧</translation>
    </message>
    <message>
        <source>Single frames</source>
        <translation>逐帧显示</translation>
    </message>
    <message>
        <source>Choose mask frames automatically</source>
        <translation>自动选择蒙片帧</translation>
    </message>
    <message>
        <source>Compute mask shift</source>
        <translation>求蒙片位移</translation>
    </message>
    <message>
        <source>Mask shift to the right</source>
        <translation>蒙片右移</translation>
    </message>
    <message>
        <source>Mask shift down</source>
        <translation>蒙片下移</translation>
    </message>
    <message>
        <source>Shifts the mask to the right, px</source>
        <translation>将蒙片向右移动，px</translation>
    </message>
    <message>
        <source>Shifts the mask down, px</source>
        <translation>将蒙片向下移动，px</translation>
    </message>
    <message>
        <source>mask frames</source>
        <translation>蒙片帧</translation>
    </message>
    <message>
        <source>shift →  ↓</source>
        <translation>位移 →  ↓</translation>
    </message>
    <message>
        <source>Pixel shift</source>
        <translation>像素位移</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>线性</translation>
    </message>
    <message>
        <source>logarithmic</source>
        <translation>对数</translation>
    </message>
    <message>
        <source>Relation of the stored pixel values to the X-ray intensity (0028,1040)</source>
        <translation>存储值与 X 线强度的关系（0028,1040）</translation>
    </message>
    <message>
        <source>Pixel values</source>
        <translation>像素值</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>暗</translation>
    </message>
    <message>
        <source>bright</source>
        <translation>亮</translation>
    </message>
    <message>
        <source>Sets whether the contrast agent is darker or brighter than the background</source>
        <translation>设定对比剂比背景暗还是亮</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>血管</translation>
    </message>
    <message>
        <source>Change the interpretation of pixel values</source>
        <translation>更改像素值的解释</translation>
    </message>
    <message>
        <source>Vessels are dark</source>
        <translation>血管为暗</translation>
    </message>
    <message>
        <source>Vessels are bright</source>
        <translation>血管为亮</translation>
    </message>
    <message>
        <source>pixel values</source>
        <translation>像素值</translation>
    </message>
    <message>
        <source>vessels</source>
        <translation>血管</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>更改 %1</translation>
    </message>
    <message>
        <source>min. length</source>
        <translation>最小长度</translation>
    </message>
    <message>
        <source>Removes isolated segments shorter than this length, and spurs shorter than a third of it</source>
        <translation>去除短于此值的孤立段，以及短于其三分之一的毛刺</translation>
    </message>
    <message>
        <source>sensitivity</source>
        <translation>灵敏度</translation>
    </message>
    <message>
        <source>Above 1, fainter vessels are also traced</source>
        <translation>大于 1 时也提取较淡的血管</translation>
    </message>
    <message>
        <source>max. radius</source>
        <translation>最大半径</translation>
    </message>
    <message>
        <source>Radius of the widest vessel to trace</source>
        <translation>要提取的最粗血管的半径</translation>
    </message>
    <message>
        <source>Restore default tracing</source>
        <translation>恢复默认提取</translation>
    </message>
    <message>
        <source>Tracing</source>
        <translation>提取</translation>
    </message>
    <message>
        <source>subtracting…</source>
        <translation>减影中…</translation>
    </message>
    <message>
        <source>subtracted</source>
        <translation>已减影</translation>
    </message>
    <message>
        <source>MinIP</source>
        <translation>最小密度投影</translation>
    </message>
    <message>
        <source>native</source>
        <translation>原始</translation>
    </message>
    <message>
        <source>Shift the mask with the arrow keys or the mouse</source>
        <translation>用方向键或鼠标移动蒙片</translation>
    </message>
    <message>
        <source>Subtracts structures that are also visible in the mask frames, such as bone and soft tissue</source>
        <translation>减去蒙片帧中同样可见的结构，如骨骼和软组织</translation>
    </message>
    <message>
        <source>Shows the darkest value of each pixel over the run</source>
        <translation>显示各像素在序列中的最暗值</translation>
    </message>
    <message>
        <source>Edit vessels</source>
        <translation>编辑血管</translation>
    </message>
    <message>
        <source>Exclude, erase, draw and cut traced curves</source>
        <translation>排除、擦除、绘制和切断提取的曲线</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窗宽</translation>
    </message>
    <message>
        <source>Window (W): range of gray values between black and white</source>
        <translation>窗宽（W）：黑与白之间的灰度值范围</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>窗位</translation>
    </message>
    <message>
        <source>Level (L): gray value at the center of the window</source>
        <translation>窗位（L）：窗中央的灰度值</translation>
    </message>
    <message>
        <source>window, level</source>
        <translation>窗宽、窗位</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::AngiogramView</name>
    <message>
        <source>Angiogram with the projected vessel tree</source>
        <translation>叠加投影血管树的血管造影</translation>
    </message>
    <message>
        <source>Mirrored image, mirrored back in this view</source>
        <translation>镜像图像，视图已还原</translation>
    </message>
    <message>
        <source>View from the source: mirrored</source>
        <translation>从射线源方向看：视图镜像</translation>
    </message>
    <message>
        <source>Mirrored image: seen from the source</source>
        <translation>镜像图像：从射线源方向看</translation>
    </message>
    <message>
        <source>flicker %1 · swipe %2 · hide H · outline %3</source>
        <translation>闪烁 %1 · 卷帘 %2 · 隐藏 H · 轮廓 %3</translation>
    </message>
    <message>
        <source>No angiogram yet: drop one here, or open it (%1).</source>
        <translation>尚无血管造影：请拖放到此处，或打开（%1）。</translation>
    </message>
    <message>
        <source>frame %1 of %2</source>
        <translation>第 %1 帧，共 %2 帧</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::AuxiliaryDialog</name>
    <message>
        <source>Use %1 instead</source>
        <translation>改用 %1</translation>
    </message>
    <message>
        <source>This method alternates between the auxiliary branches and the whole vessel tree.</source>
        <translation>该方法在辅助分支与整棵血管树之间交替。</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Up to generation</source>
        <translation>直至级别</translation>
    </message>
    <message>
        <source>Generation 0 begins at the root of the tree.</source>
        <translation>第 0 级从血管树根部开始。</translation>
    </message>
    <message>
        <source>Radius at least</source>
        <translation>半径不小于</translation>
    </message>
    <message>
        <source>Uses the median radius of each branch.</source>
        <translation>按各分支半径的中位数。</translation>
    </message>
    <message>
        <source>Use these</source>
        <translation>采用这些</translation>
    </message>
    <message>
        <source>Selects the suggested branches as auxiliary branches.</source>
        <translation>将建议的分支设为辅助分支。</translation>
    </message>
    <message>
        <source>Auxiliary branches</source>
        <translation>辅助分支</translation>
    </message>
    <message>
        <source>Alternating methods solve for these branches first; choose branches that are opacified, stationary and clearly separated. In a view, a branch constrains the pose only perpendicular to its course; the table shows which branches constrain each axis at the current pose.</source>
        <translation>交替类方法先求解这些分支；请选择已显影、静止且清晰分开的分支。在单个视图中，分支只能在垂直于其走行的方向上约束位姿；表中列出当前位姿下约束各自由度的分支。</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>自由度</translation>
    </message>
    <message>
        <source>All branches</source>
        <translation>全部分支</translation>
    </message>
    <message>
        <source>Auxiliary</source>
        <translation>辅助分支</translation>
    </message>
    <message>
        <source>Constrained by</source>
        <translation>最佳约束分支</translation>
    </message>
    <message>
        <source>±: standard deviation expected for traced vessels with typical noise.</source>
        <translation>± 为典型噪声下所提取血管的预期标准差。</translation>
    </message>
    <message>
        <source>Last generation</source>
        <translation>最后一级</translation>
    </message>
    <message>
        <source>Minimum radius</source>
        <translation>最小半径</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Without auxiliary branches, the nodes of the vessel tree are used.</source>
        <translation>没有辅助分支时使用血管树的节点。</translation>
    </message>
    <message>
        <source>A suggestion requires vessels, a camera and a pose.</source>
        <translation>给出建议需要血管、相机和位姿。</translation>
    </message>
    <message>
        <source>Suggested: %1 (nearly as informative as the whole tree).</source>
        <translation>建议：%1（信息量几乎等于整个血管树）。</translation>
    </message>
    <message>
        <source>This tree has no generation data.</source>
        <translation>此血管树没有分级信息。</translation>
    </message>
    <message>
        <source>This tree has no radii.</source>
        <translation>此血管树没有半径信息。</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>套索</translation>
    </message>
    <message>
        <source>Draw around the branches in the image.</source>
        <translation>在图像上圈选分支。</translation>
    </message>
    <message>
        <source>In view</source>
        <translation>视野内</translation>
    </message>
    <message>
        <source>Selects the branches that lie completely in the view.</source>
        <translation>选择完全位于视野内的分支。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::BlindTrialDialog</name>
    <message>
        <source>Seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>Max. initial shift</source>
        <translation>最大初始平移</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Max. initial rotation</source>
        <translation>最大初始旋转</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Start trial</source>
        <translation>开始试验</translation>
    </message>
    <message>
        <source>Blind observer trial</source>
        <translation>观察者盲法试验</translation>
    </message>
    <message>
        <source>The vessels start in a random pose near the current one. Until you choose “Done”, all numbers, residual colors and earlier poses are hidden. The time and the final pose are logged; the case is not changed.</source>
        <translation>血管从当前位姿附近的随机位姿开始。在选择“完成”之前，隐藏所有数值、残差颜色和先前位姿。时间和最终位姿写入日志；病例不变。</translation>
    </message>
    <message>
        <source>Observer</source>
        <translation>观察者</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Trial log</source>
        <translation>试验日志</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Enter the observer and choose a log file.</source>
        <translation>请输入观察者和日志文件。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::BottomStrip</name>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Stop the running task</source>
        <translation>停止当前任务</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::BranchDelegate</name>
    <message>
        <source>aux</source>
        <translation>辅助</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>excl.</source>
        <translation>排除</translation>
    </message>
    <message>
        <source>g%1</source>
        <translation>%1 级</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>隐藏</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::BranchModel</name>
    <message>
        <source>%1, %2 mm long</source>
        <translation>%1，长 %2 mm</translation>
    </message>
    <message>
        <source>auxiliary branch</source>
        <translation>辅助分支</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>已排除</translation>
    </message>
    <message>
        <source>median residual %1 mm</source>
        <translation>残差中位数 %1 mm</translation>
    </message>
    <message>
        <source>radius %1 mm</source>
        <translation>半径 %1 mm</translation>
    </message>
    <message>
        <source>generation %1</source>
        <translation>第 %1 级</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>隐藏</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::BranchPanel</name>
    <message>
        <source>Branches</source>
        <translation>分支</translation>
    </message>
    <message>
        <source>Use only these as auxiliary</source>
        <translation>仅将这些设为辅助</translation>
    </message>
    <message>
        <source>Clear auxiliary branches</source>
        <translation>清除辅助分支</translation>
    </message>
    <message>
        <source>in tree order</source>
        <translation>按血管树顺序</translation>
    </message>
    <message>
        <source>by name</source>
        <translation>按名称</translation>
    </message>
    <message>
        <source>by length</source>
        <translation>按长度</translation>
    </message>
    <message>
        <source>by radius</source>
        <translation>按半径</translation>
    </message>
    <message>
        <source>by generation</source>
        <translation>按级别</translation>
    </message>
    <message>
        <source>by residual</source>
        <translation>按残差</translation>
    </message>
    <message>
        <source>Find a branch</source>
        <translation>查找分支</translation>
    </message>
    <message>
        <source>Branch order</source>
        <translation>分支排序</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Selects both branches and moves the crosshair to the gap.</source>
        <translation>选中两个分支并将十字线移到间隙。</translation>
    </message>
    <message>
        <source>Generation</source>
        <translation>级别</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>No vessels yet. Open a CT scan, a vessel mask or a centerline.</source>
        <translation>尚无血管。请打开 CT、血管掩膜或中心线。</translation>
    </message>
    <message>
        <source>Bridges the gap; can be undone.</source>
        <translation>桥接间隙；可撤销。</translation>
    </message>
    <message>
        <source>%1 auxiliary · %2 exclude</source>
        <translation>%1 辅助 · %2 排除</translation>
    </message>
    <message>
        <source>Toggle auxiliary</source>
        <translation>切换辅助分支</translation>
    </message>
    <message>
        <source>Exclude or include</source>
        <translation>排除或纳入</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::CommandTable</name>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Share case as ZIP…</source>
        <translation>以 ZIP 共享病例…</translation>
    </message>
    <message>
        <source>Export DICOM objects…</source>
        <translation>导出 DICOM 对象…</translation>
    </message>
    <message>
        <source>Play slower</source>
        <translation>放慢播放</translation>
    </message>
    <message>
        <source>Play faster</source>
        <translation>加快播放</translation>
    </message>
    <message>
        <source>Play back and forth</source>
        <translation>往返播放</translation>
    </message>
    <message>
        <source>Play from this frame</source>
        <translation>从此帧开始播放</translation>
    </message>
    <message>
        <source>Play to this frame</source>
        <translation>播放到此帧为止</translation>
    </message>
    <message>
        <source>Play the entire run</source>
        <translation>播放整个序列</translation>
    </message>
    <message>
        <source>Show views side by side</source>
        <translation>并排显示视图</translation>
    </message>
    <message>
        <source>Linked crosshair across views</source>
        <translation>视图间联动十字线</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>Close case</source>
        <translation>关闭病例</translation>
    </message>
    <message>
        <source>New window</source>
        <translation>新建窗口</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>打开…</translation>
    </message>
    <message>
        <source>Open DICOM folder/CD…</source>
        <translation>打开 DICOM 文件夹/光盘…</translation>
    </message>
    <message>
        <source>Open sample case</source>
        <translation>打开示例病例</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>另存为…</translation>
    </message>
    <message>
        <source>Export overlay…</source>
        <translation>导出叠加图…</translation>
    </message>
    <message>
        <source>Export result…</source>
        <translation>导出结果…</translation>
    </message>
    <message>
        <source>Export pose…</source>
        <translation>导出位姿…</translation>
    </message>
    <message>
        <source>Export traced vessels…</source>
        <translation>导出提取的血管…</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>退出</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>Nudge mode</source>
        <translation>微调模式</translation>
    </message>
    <message>
        <source>Reset to initial pose</source>
        <translation>重置为初始位姿</translation>
    </message>
    <message>
        <source>Copy pose as matrix</source>
        <translation>以矩阵复制位姿</translation>
    </message>
    <message>
        <source>Toggle auxiliary for selected branches</source>
        <translation>切换所选分支的辅助状态</translation>
    </message>
    <message>
        <source>Auxiliary: branches in view</source>
        <translation>辅助：视野内的分支</translation>
    </message>
    <message>
        <source>Auxiliary: larger vessels</source>
        <translation>辅助：较粗的血管</translation>
    </message>
    <message>
        <source>Exclude or include selected branches</source>
        <translation>排除或纳入所选分支</translation>
    </message>
    <message>
        <source>Select all branches</source>
        <translation>选择所有分支</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>配准</translation>
    </message>
    <message>
        <source>Stop and keep the best pose</source>
        <translation>停止并保留最佳位姿</translation>
    </message>
    <message>
        <source>Fit image to window</source>
        <translation>图像适合窗口</translation>
    </message>
    <message>
        <source>Automatic window/level</source>
        <translation>自动窗宽窗位</translation>
    </message>
    <message>
        <source>Invert grayscale</source>
        <translation>灰度反转</translation>
    </message>
    <message>
        <source>Window preset: full range</source>
        <translation>窗预设：全部灰度</translation>
    </message>
    <message>
        <source>More contrast</source>
        <translation>增强对比度</translation>
    </message>
    <message>
        <source>Less contrast</source>
        <translation>降低对比度</translation>
    </message>
    <message>
        <source>Depth cueing</source>
        <translation>深度提示</translation>
    </message>
    <message>
        <source>Cycle swipe / magic lens</source>
        <translation>切换卷帘/透镜</translation>
    </message>
    <message>
        <source>Go to next worst branch</source>
        <translation>转到下一个最差分支</translation>
    </message>
    <message>
        <source>Show traced vessels</source>
        <translation>显示提取的血管</translation>
    </message>
    <message>
        <source>Flicker initial / current pose</source>
        <translation>初始/当前位姿闪烁对比</translation>
    </message>
    <message>
        <source>Color by deformation</source>
        <translation>按变形着色</translation>
    </message>
    <message>
        <source>Show deformed vessels</source>
        <translation>显示变形的血管</translation>
    </message>
    <message>
        <source>Replay last registration</source>
        <translation>回放上次配准</translation>
    </message>
    <message>
        <source>Animate pose uncertainty</source>
        <translation>动画显示位姿不确定度</translation>
    </message>
    <message>
        <source>Show alternative solutions</source>
        <translation>显示其他解</translation>
    </message>
    <message>
        <source>Accept this solution</source>
        <translation>采用此解</translation>
    </message>
    <message>
        <source>Decrease overlay opacity</source>
        <translation>降低叠加不透明度</translation>
    </message>
    <message>
        <source>Increase overlay opacity</source>
        <translation>提高叠加不透明度</translation>
    </message>
    <message>
        <source>Play frames</source>
        <translation>播放帧</translation>
    </message>
    <message>
        <source>Hide patient identity</source>
        <translation>隐藏患者信息</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>全屏</translation>
    </message>
    <message>
        <source>Reduce motion</source>
        <translation>减少动画</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>System theme</source>
        <translation>跟随系统主题</translation>
    </message>
    <message>
        <source>About AngioPose</source>
        <translation>关于 AngioPose</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Registration</source>
        <translation>配准(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>System language</source>
        <translation>跟随系统语言</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Save screenshot…</source>
        <translation>保存截图…</translation>
    </message>
    <message>
        <source>Copy screenshot</source>
        <translation>复制截图</translation>
    </message>
    <message>
        <source>Radiology: left-drag adjusts window/level</source>
        <translation>放射科：左键拖动调窗</translation>
    </message>
    <message>
        <source>3D Slicer: left button only selects</source>
        <translation>3D Slicer：左键仅选择</translation>
    </message>
    <message>
        <source>Scroll: left-drag scrolls through frames</source>
        <translation>滚动：左键拖动换帧</translation>
    </message>
    <message>
        <source>Context help</source>
        <translation>上下文帮助</translation>
    </message>
    <message>
        <source>Quick tour</source>
        <translation>快速导览</translation>
    </message>
    <message>
        <source>Examples of good and bad fits</source>
        <translation>配准好坏示例</translation>
    </message>
    <message>
        <source>Keyboard and mouse</source>
        <translation>键盘与鼠标</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>鼠标</translation>
    </message>
    <message>
        <source>Edit traced vessels</source>
        <translation>编辑提取的血管</translation>
    </message>
    <message>
        <source>Trace this frame again</source>
        <translation>重新提取此帧</translation>
    </message>
    <message>
        <source>Toggle DSA / native</source>
        <translation>切换减影/原始</translation>
    </message>
    <message>
        <source>Pixel shift</source>
        <translation>像素位移</translation>
    </message>
    <message>
        <source>Set as mask frame</source>
        <translation>设为蒙片帧</translation>
    </message>
    <message>
        <source>Peak-opacification image</source>
        <translation>全序列最小密度投影</translation>
    </message>
    <message>
        <source>Pick landmark pairs</source>
        <translation>选取标志点对</translation>
    </message>
    <message>
        <source>Register from landmarks</source>
        <translation>按标志点配准</translation>
    </message>
    <message>
        <source>Auxiliary: select with lasso</source>
        <translation>辅助：套索圈选</translation>
    </message>
    <message>
        <source>Choose auxiliary branches…</source>
        <translation>选择辅助分支…</translation>
    </message>
    <message>
        <source>C-arm angles for branch…</source>
        <translation>分支的 C 臂角度…</translation>
    </message>
    <message>
        <source>Trace the scan again</source>
        <translation>重新提取扫描</translation>
    </message>
    <message>
        <source>Find a branch</source>
        <translation>查找分支</translation>
    </message>
    <message>
        <source>Rename branch</source>
        <translation>重命名分支</translation>
    </message>
    <message>
        <source>Cut branch at crosshair</source>
        <translation>在十字线处切断分支</translation>
    </message>
    <message>
        <source>Join two branches</source>
        <translation>连接两个分支</translation>
    </message>
    <message>
        <source>Smooth branches</source>
        <translation>平滑分支</translation>
    </message>
    <message>
        <source>Set root at branch end near crosshair</source>
        <translation>将十字线附近的分支端设为根</translation>
    </message>
    <message>
        <source>Hide or show branches</source>
        <translation>隐藏或显示分支</translation>
    </message>
    <message>
        <source>Show all branches</source>
        <translation>显示所有分支</translation>
    </message>
    <message>
        <source>Delete branches</source>
        <translation>删除分支</translation>
    </message>
    <message>
        <source>Delete branches and descendants</source>
        <translation>删除分支及其下级分支</translation>
    </message>
    <message>
        <source>Prune short or thin branches…</source>
        <translation>修剪短或细的分支…</translation>
    </message>
    <message>
        <source>Bridge next gap</source>
        <translation>桥接下一间隙</translation>
    </message>
    <message>
        <source>Save pose snapshot</source>
        <translation>保存位姿快照</translation>
    </message>
    <message>
        <source>Switch between poses A and B</source>
        <translation>在位姿 A 与 B 间切换</translation>
    </message>
    <message>
        <source>Compare poses and methods…</source>
        <translation>比较位姿和方法…</translation>
    </message>
    <message>
        <source>Blind observer trial…</source>
        <translation>观察者盲法试验…</translation>
    </message>
    <message>
        <source>Finish trial</source>
        <translation>结束试验</translation>
    </message>
    <message>
        <source>Mirror view (source side)</source>
        <translation>镜像视图（射线源侧）</translation>
    </message>
    <message>
        <source>Opacification over time</source>
        <translation>显影随时间变化</translation>
    </message>
    <message>
        <source>Cycle lower-left view</source>
        <translation>切换左下视图</translation>
    </message>
    <message>
        <source>Show scan slices</source>
        <translation>显示扫描层面</translation>
    </message>
    <message>
        <source>Angiogram only</source>
        <translation>仅血管造影</translation>
    </message>
    <message>
        <source>Ve&amp;ssels</source>
        <translation>血管(&amp;G)</translation>
    </message>
    <message>
        <source>Set initial pose from angles</source>
        <translation>由角度设定初始位姿</translation>
    </message>
    <message>
        <source>Set as initial pose</source>
        <translation>设为初始位姿</translation>
    </message>
    <message>
        <source>&amp;Angiogram</source>
        <translation>造影(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Pose</source>
        <translation>位姿(&amp;P)</translation>
    </message>
    <message>
        <source>3-D and slices only</source>
        <translation>仅三维和层面</translation>
    </message>
    <message>
        <source>Angiogram in separate window</source>
        <translation>血管造影用独立窗口</translation>
    </message>
    <message>
        <source>3-D and slices in separate window</source>
        <translation>三维和层面用独立窗口</translation>
    </message>
    <message>
        <source>All slices in separate window</source>
        <translation>全部层面用独立窗口</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>布局</translation>
    </message>
    <message>
        <source>Export tracked poses…</source>
        <translation>导出跟踪位姿…</translation>
    </message>
    <message>
        <source>Add view…</source>
        <translation>添加视图…</translation>
    </message>
    <message>
        <source>Show next view</source>
        <translation>显示下一视图</translation>
    </message>
    <message>
        <source>Track vessels through the run</source>
        <translation>在序列中跟踪血管</translation>
    </message>
    <message>
        <source>Cycle vessel style (centerline / outline / tube / DRR)</source>
        <translation>切换血管样式（中心线/轮廓/管状/DRR）</translation>
    </message>
    <message>
        <source>Window preset: vessels</source>
        <translation>窗预设：血管</translation>
    </message>
    <message>
        <source>Window preset: bone and devices</source>
        <translation>窗预设：骨骼与器械</translation>
    </message>
    <message>
        <source>Blue to amber</source>
        <translation>蓝至琥珀</translation>
    </message>
    <message>
        <source>Blue, white, red</source>
        <translation>蓝、白、红</translation>
    </message>
    <message>
        <source>Brightness only</source>
        <translation>仅亮度</translation>
    </message>
    <message>
        <source>Window/level</source>
        <translation>窗宽窗位</translation>
    </message>
    <message>
        <source>Vessel and residual colors</source>
        <translation>血管与残差的颜色</translation>
    </message>
    <message>
        <source>Choose vessel labels</source>
        <translation>选择血管标签</translation>
    </message>
    <message>
        <source>Set rotation center</source>
        <translation>设置旋转中心</translation>
    </message>
    <message>
        <source>Reset rotation center</source>
        <translation>重置旋转中心</translation>
    </message>
    <message>
        <source>3-D view: fit all / vessels</source>
        <translation>三维视图：适合全部/血管</translation>
    </message>
    <message>
        <source>Export vessel tree…</source>
        <translation>导出血管树…</translation>
    </message>
    <message>
        <source>Export deformed vessels…</source>
        <translation>导出变形的血管…</translation>
    </message>
    <message>
        <source>Export report…</source>
        <translation>导出报告…</translation>
    </message>
    <message>
        <source>Export measurements…</source>
        <translation>导出测量…</translation>
    </message>
    <message>
        <source>Measure length</source>
        <translation>测量长度</translation>
    </message>
    <message>
        <source>Measure angle</source>
        <translation>测量角度</translation>
    </message>
    <message>
        <source>Measure area</source>
        <translation>测量面积</translation>
    </message>
    <message>
        <source>Export branch measurements…</source>
        <translation>导出分支测量…</translation>
    </message>
    <message>
        <source>Add target point</source>
        <translation>添加目标点</translation>
    </message>
    <message>
        <source>Add ostium ring</source>
        <translation>添加开口环</translation>
    </message>
    <message>
        <source>Mark target point in image</source>
        <translation>在图像中标记目标点</translation>
    </message>
    <message>
        <source>Draw arrow</source>
        <translation>绘制箭头</translation>
    </message>
    <message>
        <source>Add text annotation</source>
        <translation>添加文字标注</translation>
    </message>
    <message>
        <source>Export target points…</source>
        <translation>导出目标点…</translation>
    </message>
    <message>
        <source>Export lumen mask…</source>
        <translation>导出管腔掩膜…</translation>
    </message>
    <message>
        <source>Trace between two points</source>
        <translation>在两点之间提取</translation>
    </message>
    <message>
        <source>Paint in lumen mask</source>
        <translation>在管腔掩膜中绘制</translation>
    </message>
    <message>
        <source>Erase from lumen mask</source>
        <translation>从管腔掩膜中擦除</translation>
    </message>
    <message>
        <source>Cut lumen mask with lasso</source>
        <translation>用套索裁剪管腔掩膜</translation>
    </message>
    <message>
        <source>Trace the edited mask</source>
        <translation>提取编辑后的掩膜</translation>
    </message>
    <message>
        <source>Show scan in 3-D view</source>
        <translation>三维视图中显示扫描</translation>
    </message>
    <message>
        <source>3-D scan: vessels / vessels and bone</source>
        <translation>三维扫描：血管/血管和骨骼</translation>
    </message>
    <message>
        <source>3-D scan: only around vessels</source>
        <translation>三维扫描：仅血管周围</translation>
    </message>
    <message>
        <source>Scan DRR on detector</source>
        <translation>探测器上显示扫描的 DRR</translation>
    </message>
    <message>
        <source>Collapse left panel</source>
        <translation>折叠左侧面板</translation>
    </message>
    <message>
        <source>Collapse right panel</source>
        <translation>折叠右侧面板</translation>
    </message>
    <message>
        <source>Change layout with step</source>
        <translation>布局随步骤变化</translation>
    </message>
    <message>
        <source>Reset layout for this step</source>
        <translation>重置本步骤的布局</translation>
    </message>
    <message>
        <source>Export movie…</source>
        <translation>导出影片…</translation>
    </message>
    <message>
        <source>Query PACS…</source>
        <translation>查询 PACS…</translation>
    </message>
    <message>
        <source>Send to PACS…</source>
        <translation>发送到 PACS…</translation>
    </message>
    <message>
        <source>De-identify files…</source>
        <translation>文件去标识…</translation>
    </message>
    <message>
        <source>Private mode</source>
        <translation>隐私模式</translation>
    </message>
    <message>
        <source>Write audit log…</source>
        <translation>写入审计日志…</translation>
    </message>
    <message>
        <source>Save support bundle…</source>
        <translation>保存支持包…</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ConvergencePlot</name>
    <message>
        <source>Convergence</source>
        <translation>收敛</translation>
    </message>
    <message>
        <source>shown after a registration</source>
        <translation>配准后显示</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>第 %1 步</translation>
    </message>
    <message>
        <source>median distance</source>
        <translation>中位距离</translation>
    </message>
    <message>
        <source>vessel shift per step</source>
        <translation>血管每步的位移</translation>
    </message>
    <message>
        <source>Top: median distance of the vessel points to the traced vessels.
Bottom: displacement of the vessels in each step (root mean square over all points); the lowest line is zero.</source>
        <translation>上：血管点到所提取血管的中位距离。
下：每一步血管的位移（所有点的均方根）；最底线为零。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::CornerViews</name>
    <message>
        <source>3-D</source>
        <translation>三维</translation>
    </message>
    <message>
        <source>Enlarge all slices</source>
        <translation>放大显示所有层面</translation>
    </message>
    <message>
        <source>Show only this view, or restore</source>
        <translation>仅显示此视图，或恢复</translation>
    </message>
    <message>
        <source>Move to a separate window, or back</source>
        <translation>移到独立窗口，或移回</translation>
    </message>
    <message>
        <source>Double-click: show only this view, or restore</source>
        <translation>双击：仅显示此视图，或恢复</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::CurveEditBar</name>
    <message>
        <source>1 curve</source>
        <translation>1 条曲线</translation>
    </message>
    <message>
        <source>Not a vessel</source>
        <translation>非血管</translation>
    </message>
    <message>
        <source>Click a curve to exclude it</source>
        <translation>单击曲线以排除</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>擦除</translation>
    </message>
    <message>
        <source>Brush over the parts of curves that you want to erase</source>
        <translation>涂抹要擦除的曲线部分</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>绘制</translation>
    </message>
    <message>
        <source>Click along a vessel: the line follows it</source>
        <translation>沿血管单击：线条自动跟随</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>切断</translation>
    </message>
    <message>
        <source>Click where to split a curve</source>
        <translation>单击要断开曲线的位置</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>Exclude everything inside a box; Ctrl: keep only the inside</source>
        <translation>排除框内部分；Ctrl：仅保留框内</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>套索</translation>
    </message>
    <message>
        <source>Exclude everything inside a lasso; Ctrl: keep only the inside</source>
        <translation>排除套索内部分；Ctrl：仅保留套索内</translation>
    </message>
    <message>
        <source>Trace again</source>
        <translation>重新提取</translation>
    </message>
    <message>
        <source>Discard the edits of this frame and trace it automatically; can be undone</source>
        <translation>放弃此帧的编辑并自动提取；可撤销</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>%1 curves</source>
        <translation>%1 条曲线</translation>
    </message>
    <message>
        <source>%1 curves, %2 suspect (S)</source>
        <translation>%1 条曲线，%2 条可疑（S）</translation>
    </message>
    <message>
        <source>Catheter</source>
        <translation>导管</translation>
    </message>
    <message>
        <source>Click a catheter or guidewire to mark it as a device; devices do not count as vessels, but can be tracked</source>
        <translation>单击导管或导丝将其标记为器械：它不是血管，但可以跟踪</translation>
    </message>
    <message>
        <source>Track device</source>
        <translation>跟踪器械</translation>
    </message>
    <message>
        <source>Find the path of the catheter or guidewire through the tree (method “Guidewire or catheter”)</source>
        <translation>求导管或导丝在血管树中的路径（方法：导丝或导管）</translation>
    </message>
    <message>
        <source>%1, devices: %2</source>
        <translation>%1，器械：%2</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::EditCurvesTool</name>
    <message>
        <source>Mark as non-vessel</source>
        <translation>标为非血管</translation>
    </message>
    <message>
        <source>Edit vessels: tracing this frame…</source>
        <translation>编辑血管：正在提取此帧…</translation>
    </message>
    <message>
        <source>Erase: brush over curves, [ ] brush size, Esc ends</source>
        <translation>擦除：涂抹曲线，[ ] 笔刷大小，Esc 结束</translation>
    </message>
    <message>
        <source>Draw: click along the vessel, Enter ends, Backspace removes a point, Shift draws straight lines</source>
        <translation>绘制：沿血管单击，回车结束，退格删除一点，Shift 直线</translation>
    </message>
    <message>
        <source>Cut: click where to split a curve, Esc ends</source>
        <translation>切断：单击要断开曲线的位置，Esc 结束</translation>
    </message>
    <message>
        <source>Not a vessel: click a curve to exclude it, Esc ends</source>
        <translation>非血管：单击曲线以排除，Esc 结束</translation>
    </message>
    <message>
        <source>Box: drag around non-vessels; Ctrl keeps only the inside, Esc ends</source>
        <translation>框选：框住非血管部分；Ctrl 仅保留框内，Esc 结束</translation>
    </message>
    <message>
        <source>Lasso: draw around non-vessels; Ctrl keeps only the inside, Esc ends</source>
        <translation>套索：圈住非血管部分；Ctrl 仅保留圈内，Esc 结束</translation>
    </message>
    <message>
        <source>Erase curves</source>
        <translation>擦除曲线</translation>
    </message>
    <message>
        <source>Restrict to a region</source>
        <translation>限定区域</translation>
    </message>
    <message>
        <source>Exclude a region</source>
        <translation>排除区域</translation>
    </message>
    <message>
        <source>Cut a curve</source>
        <translation>切断曲线</translation>
    </message>
    <message>
        <source>Draw a curve</source>
        <translation>绘制曲线</translation>
    </message>
    <message>
        <source>Possible catheter: A keep as vessel, W mark as catheter or guidewire, Delete exclude, S next</source>
        <translation>可能是导管：A 血管，W 导管或导丝，Delete 排除，S 下一条</translation>
    </message>
    <message>
        <source>Catheter or guidewire: click a curve to mark or unmark it as a device, Esc ends</source>
        <translation>导管或导丝：单击曲线将其标记为器械或取消标记，Esc 结束</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ExportDialog</name>
    <message>
        <source>Contents</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Print resolution</source>
        <translation>打印分辨率</translation>
    </message>
    <message>
        <source>dpi</source>
        <translation>dpi</translation>
    </message>
    <message>
        <source>Vessels over the image</source>
        <translation>图像上叠加血管</translation>
    </message>
    <message>
        <source>Image only</source>
        <translation>仅图像</translation>
    </message>
    <message>
        <source>16-bit gray values of the image</source>
        <translation>图像的 16 位灰度值</translation>
    </message>
    <message>
        <source>PNG (raster)</source>
        <translation>PNG（位图）</translation>
    </message>
    <message>
        <source>SVG (vector)</source>
        <translation>SVG（矢量图）</translation>
    </message>
    <message>
        <source>PDF (vector)</source>
        <translation>PDF（矢量图）</translation>
    </message>
    <message>
        <source>same size as the frame</source>
        <translation>与帧大小相同</translation>
    </message>
    <message>
        <source>%1 × %2 px, %3 × %4 cm</source>
        <translation>%1 × %2 px，%3 × %4 cm</translation>
    </message>
    <message>
        <source>The image is labeled “Not for clinical use”; inputs, method and pose are stored in its metadata (16-bit images carry the label in the metadata only).</source>
        <translation>图像上标注“不得用于临床”；输入、方法与位姿保存在元数据中（16 位图像仅在元数据中标注）。</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Residual colors with scale</source>
        <translation>残差颜色及色标</translation>
    </message>
    <message>
        <source>Burn in patient identity</source>
        <translation>图像中显示患者信息</translation>
    </message>
    <message>
        <source>Export overlay</source>
        <translation>导出叠加图</translation>
    </message>
    <message>
        <source>As in the window</source>
        <translation>与窗口一致</translation>
    </message>
    <message>
        <source>1024 px wide</source>
        <translation>宽 1024 px</translation>
    </message>
    <message>
        <source>2048 px wide</source>
        <translation>宽 2048 px</translation>
    </message>
    <message>
        <source>Other width</source>
        <translation>其他宽度</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>English labels</source>
        <translation>使用英文标注</translation>
    </message>
    <message>
        <source>Swipe or lens as in the window</source>
        <translation>与窗口中相同的卷帘或透镜</translation>
    </message>
    <message>
        <source>Side by side with initial pose</source>
        <translation>与初始位姿并排</translation>
    </message>
    <message>
        <source>two images, %1 each</source>
        <translation>两幅图像，各 %1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::FrameBars</name>
    <message>
        <source>R wave</source>
        <translation>R 波</translation>
    </message>
    <message>
        <source>Drag the ends to play part of the run; double-click to play the whole run</source>
        <translation>拖动两端以播放序列的一部分；双击播放全部</translation>
    </message>
    <message>
        <source>Opacification of the frames</source>
        <translation>各帧显影程度</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>第 %1 帧</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>peak-opacification frame</source>
        <translation>峰值显影帧</translation>
    </message>
    <message>
        <source>mask</source>
        <translation>蒙片</translation>
    </message>
    <message>
        <source>Shift+drag marks mask frames; double-click shows the opacification curve</source>
        <translation>Shift+拖动标记蒙片帧；双击显示显影曲线</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::GeometryPanel</name>
    <message>
        <source>enter value</source>
        <translation>输入数值</translation>
    </message>
    <message>
        <source>SID</source>
        <translation>SID</translation>
    </message>
    <message>
        <source>Source-to-detector distance</source>
        <translation>射线源到探测器距离</translation>
    </message>
    <message>
        <source>SOD</source>
        <translation>SOD</translation>
    </message>
    <message>
        <source>Source-to-isocenter distance</source>
        <translation>射线源到等中心距离</translation>
    </message>
    <message>
        <source>pixel spacing</source>
        <translation>像素间距</translation>
    </message>
    <message>
        <source>LAO / RAO</source>
        <translation>LAO / RAO</translation>
    </message>
    <message>
        <source>Primary angle: LAO positive, RAO negative</source>
        <translation>主角度：LAO 为正，RAO 为负</translation>
    </message>
    <message>
        <source>CRA / CAU</source>
        <translation>CRA / CAU</translation>
    </message>
    <message>
        <source>Secondary angle: CRA positive, CAU negative</source>
        <translation>次角度：CRA（头位）为正，CAU（足位）为负</translation>
    </message>
    <message>
        <source>header</source>
        <translation>文件头</translation>
    </message>
    <message>
        <source>derived</source>
        <translation>推算</translation>
    </message>
    <message>
        <source>entered</source>
        <translation>手动输入</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>假定</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>几何</translation>
    </message>
    <message>
        <source>Use typical values</source>
        <translation>使用典型值</translation>
    </message>
    <message>
        <source>Use distances and spacing instead</source>
        <translation>改用距离和像素间距</translation>
    </message>
    <message>
        <source>Fills in missing values only: SID 1000 mm, SOD 750 mm, pixel spacing 0.3 mm, angles 0°.</source>
        <translation>仅用于缺失项：SID 1000 mm、SOD 750 mm、像素间距 0.3 mm、角度 0°。</translation>
    </message>
    <message>
        <source>Camera from the case file: f %1 px, principal point %2, %3 px, %4.</source>
        <translation>病例文件中的相机：f %1 px，主点 %2，%3 px，%4。</translation>
    </message>
    <message>
        <source>seen from the detector</source>
        <translation>从探测器方向看</translation>
    </message>
    <message>
        <source>mirrored</source>
        <translation>镜像</translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation>不完整</translation>
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
        <translation>缺少数值</translation>
    </message>
    <message>
        <source>Roll, principal point, isocenter</source>
        <translation>滚转、主点、等中心</translation>
    </message>
    <message>
        <source>DICOM header values</source>
        <translation>DICOM 文件头数值</translation>
    </message>
    <message>
        <source>from the detector</source>
        <translation>从探测器看</translation>
    </message>
    <message>
        <source>Viewing side of the image</source>
        <translation>图像的观察侧</translation>
    </message>
    <message>
        <source>Angiograms are normally shown as seen from the detector. In a mirrored export, left and right are swapped; the projection is then mirrored together with the image, but the vessels themselves never are.</source>
        <translation>血管造影通常按从探测器看的方向显示。镜像导出的图像左右互换；此时投影随图像镜像，血管本身绝不镜像。</translation>
    </message>
    <message>
        <source>viewing side</source>
        <translation>观察侧</translation>
    </message>
    <message>
        <source>image</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>%1 tags</source>
        <translation>%1 个标签</translation>
    </message>
    <message>
        <source>The header contains no pixel spacing; this value is derived. Press Enter in the field to confirm the value, or enter another one.</source>
        <translation>文件头无像素间距；此值为推算。请在框内按回车确认，或输入其他值。</translation>
    </message>
    <message>
        <source>The image is assumed to be mirrored (%1). Check left and right.</source>
        <translation>图像按镜像处理（%1）。请核对左右。</translation>
    </message>
    <message>
        <source>The gantry rotates during this run: by %1° in LAO/RAO and %2° in CRA/CAU from the first frame to this one.</source>
        <translation>采集中机架旋转：从第一帧到此帧 LAO/RAO %1°、CRA/CAU %2°。</translation>
    </message>
    <message>
        <source>Pixel spacing at the detector. Press Enter to confirm a derived value.</source>
        <translation>探测器上的像素间距。回车确认推算值。</translation>
    </message>
    <message>
        <source>detector width</source>
        <translation>探测器宽度</translation>
    </message>
    <message>
        <source>Width of the image at the detector; determines the pixel spacing</source>
        <translation>图像在探测器上的宽度；由此得出像素间距</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>滚转</translation>
    </message>
    <message>
        <source>Clockwise rotation of the image</source>
        <translation>图像的顺时针旋转角</translation>
    </message>
    <message>
        <source>center x</source>
        <translation>中心 x</translation>
    </message>
    <message>
        <source>Column in which the central ray meets the detector; 0 is the center of the first column</source>
        <translation>中心射线在探测器上所在的列；0 为第一列中心</translation>
    </message>
    <message>
        <source>center y</source>
        <translation>中心 y</translation>
    </message>
    <message>
        <source>Row in which the central ray meets the detector; 0 is the center of the first row</source>
        <translation>中心射线在探测器上所在的行；0 为第一行中心</translation>
    </message>
    <message>
        <source>isocenter L</source>
        <translation>等中心 L</translation>
    </message>
    <message>
        <source>Gantry rotation center in vessel coordinates: left</source>
        <translation>机架旋转中心（血管坐标）：左</translation>
    </message>
    <message>
        <source>isocenter P</source>
        <translation>等中心 P</translation>
    </message>
    <message>
        <source>Gantry rotation center in vessel coordinates: posterior</source>
        <translation>机架旋转中心（血管坐标）：后</translation>
    </message>
    <message>
        <source>isocenter H</source>
        <translation>等中心 H</translation>
    </message>
    <message>
        <source>Gantry rotation center in vessel coordinates: head</source>
        <translation>机架旋转中心（血管坐标）：头</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::GoodFit</name>
    <message>
        <source>Good: vessels have moved</source>
        <translation>良好：血管有移动</translation>
    </message>
    <message>
        <source>Bad: shifted</source>
        <translation>不良：平移</translation>
    </message>
    <message>
        <source>Bad: rotated</source>
        <translation>不良：旋转</translation>
    </message>
    <message>
        <source>Bad: wrong gantry angle</source>
        <translation>不良：投照角度错误</translation>
    </message>
    <message>
        <source>The lines follow the vessel centers and are blue throughout, including in the side branches.</source>
        <translation>线条沿血管中央走行，全程蓝色，侧支亦然。</translation>
    </message>
    <message>
        <source>Amber only where there is no contrast agent in this frame; every opacified vessel is blue.</source>
        <translation>仅此帧无对比剂处为琥珀色；显影的血管均为蓝色。</translation>
    </message>
    <message>
        <source>Small deviations to both sides due to heartbeat and breathing; no rigid pose fits better.</source>
        <translation>两侧均有小偏差，由心跳与呼吸引起。没有更吻合的刚性位姿。</translation>
    </message>
    <message>
        <source>All lines are shifted to the same side. Register again, or nudge with the arrow keys.</source>
        <translation>所有线条偏向同一侧。请重新配准，或用方向键微调。</translation>
    </message>
    <message>
        <source>The lines fit in the center but deviate increasingly toward the edges: the pose is rotated in the image plane.</source>
        <translation>线条在中间吻合而向外偏差渐大：位姿在图像平面内旋转。</translation>
    </message>
    <message>
        <source>The trunk fits, but the side branches run in other directions: LAO/RAO or CRA/CAU is wrong.</source>
        <translation>主干吻合而侧支指向别处：LAO/RAO 或 CRA/CAU 有误。</translation>
    </message>
    <message>
        <source>Examples of good and bad fits</source>
        <translation>配准好坏示例</translation>
    </message>
    <message>
        <source>Simulated vessels. Blue: on a vessel. Amber: off by 2 mm or more.</source>
        <translation>模拟血管。蓝色：位于血管上。琥珀色：偏差 2 mm 或以上。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>drawing…</source>
        <translation>绘制中…</translation>
    </message>
    <message>
        <source>Good: everything fits</source>
        <translation>良好：全部吻合</translation>
    </message>
    <message>
        <source>Good: unopacified branches</source>
        <translation>良好：部分分支未显影</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::HeaderBar</name>
    <message>
        <source>Not for clinical use</source>
        <translation>不得用于临床</translation>
    </message>
    <message>
        <source>AngioPose is research software, not a medical device.</source>
        <translation>AngioPose 是研究软件，不是医疗器械。</translation>
    </message>
    <message>
        <source>More menus</source>
        <translation>更多菜单</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::HelpPage</name>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::HistogramPlot</name>
    <message>
        <source>Histogram of residuals</source>
        <translation>残差直方图</translation>
    </message>
    <message>
        <source>no residuals yet</source>
        <translation>尚无残差</translation>
    </message>
    <message>
        <source>above %1</source>
        <translation>大于 %1</translation>
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
        <translation>平移 1 mm（Shift 10 mm，Ctrl 0.1 mm）</translation>
    </message>
    <message>
        <source>PgUp PgDn</source>
        <translation>PgUp PgDn</translation>
    </message>
    <message>
        <source>move away from or toward the source</source>
        <translation>远离或靠近射线源</translation>
    </message>
    <message>
        <source>, .</source>
        <translation>, .</translation>
    </message>
    <message>
        <source>roll by 1°</source>
        <translation>滚转 1°</translation>
    </message>
    <message>
        <source>Alt+arrows</source>
        <translation>Alt+方向键</translation>
    </message>
    <message>
        <source>rotate LAO/RAO and CRA/CAU by 1°</source>
        <translation>旋转 LAO/RAO 和 CRA/CAU 1°</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>拖动</translation>
    </message>
    <message>
        <source>left drag</source>
        <translation>左键拖动</translation>
    </message>
    <message>
        <source>window and level</source>
        <translation>窗宽窗位</translation>
    </message>
    <message>
        <source>middle drag</source>
        <translation>中键拖动</translation>
    </message>
    <message>
        <source>pan</source>
        <translation>平移图像</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>wheel, ↑ ↓, Home, End</source>
        <translation>滚轮、↑ ↓、Home、End</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>H (hold)</source>
        <translation>H（按住）</translation>
    </message>
    <message>
        <source>hide the overlay</source>
        <translation>隐藏叠加图</translation>
    </message>
    <message>
        <source>click</source>
        <translation>单击</translation>
    </message>
    <message>
        <source>select a branch (Ctrl adds)</source>
        <translation>选择分支（Ctrl 追加）</translation>
    </message>
    <message>
        <source>In nudge mode</source>
        <translation>微调模式下</translation>
    </message>
    <message>
        <source>In the angiogram</source>
        <translation>在血管造影上</translation>
    </message>
    <message>
        <source>move; drag the ring to roll; Esc reverts, then ends the mode</source>
        <translation>平移；拖动圆环滚转；Esc 撤销，再按结束模式</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Ctrl+滚轮</translation>
    </message>
    <message>
        <source>right-click</source>
        <translation>右键单击</translation>
    </message>
    <message>
        <source>context menu</source>
        <translation>上下文菜单</translation>
    </message>
    <message>
        <source>left drag, arrows</source>
        <translation>左键拖动、方向键</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>right drag, wheel, + −</source>
        <translation>右键拖动、滚轮、+ −</translation>
    </message>
    <message>
        <source>double-click</source>
        <translation>双击</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Shift+left drag</source>
        <translation>Shift+左键拖动</translation>
    </message>
    <message>
        <source>Ctrl+left drag</source>
        <translation>Ctrl+左键拖动</translation>
    </message>
    <message>
        <source>right drag</source>
        <translation>右键拖动</translation>
    </message>
    <message>
        <source>In the 3-D view</source>
        <translation>在三维视图上</translation>
    </message>
    <message>
        <source>set one pair: click in 3-D or in a slice, then in the image</source>
        <translation>先在三维或层面中，再在图像中单击：设置一对</translation>
    </message>
    <message>
        <source>drag a vessel node to its position, or move a landmark cross</source>
        <translation>将血管节点拖到其位置，或移动十字</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>回车</translation>
    </message>
    <message>
        <source>register the vessels from the landmark pairs</source>
        <translation>按点对配准血管</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Delete</translation>
    </message>
    <message>
        <source>remove the last pair</source>
        <translation>移除最后一对</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>exclude curves that are not vessels</source>
        <translation>排除非血管曲线</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>erase with a brush; [ ] changes its size</source>
        <translation>用笔刷擦除；[ ] 调整大小</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>draw: Enter ends, Backspace removes a point, Shift draws straight lines</source>
        <translation>绘制：回车结束，退格删除一点，Shift 直线</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>cut a curve</source>
        <translation>切断曲线</translation>
    </message>
    <message>
        <source>B L</source>
        <translation>B L</translation>
    </message>
    <message>
        <source>box or lasso around non-vessels; Ctrl: keep only the inside</source>
        <translation>框选或套索非血管部分；Ctrl：仅保留内部</translation>
    </message>
    <message>
        <source>✓ ✗</source>
        <translation>✓ ✗</translation>
    </message>
    <message>
        <source>dashed curves may be catheters: keep or exclude them</source>
        <translation>虚线可能为导管：保留或排除</translation>
    </message>
    <message>
        <source>click, left drag, Ctrl+arrows</source>
        <translation>单击、左键拖动、Ctrl+方向键</translation>
    </message>
    <message>
        <source>crosshair, linked across all views</source>
        <translation>十字线，与所有视图联动</translation>
    </message>
    <message>
        <source>pick the point at the crosshair (same as a click)</source>
        <translation>选取十字线处的点，同单击</translation>
    </message>
    <message>
        <source>wheel, ↑ ↓, PgUp PgDn</source>
        <translation>滚轮、↑ ↓、PgUp PgDn</translation>
    </message>
    <message>
        <source>slices (Shift 10)</source>
        <translation>层面（Shift 10）</translation>
    </message>
    <message>
        <source>window and level; right-click opens the menu</source>
        <translation>窗宽窗位；右键单击打开菜单</translation>
    </message>
    <message>
        <source>middle drag, Ctrl+wheel</source>
        <translation>中键拖动、Ctrl+滚轮</translation>
    </message>
    <message>
        <source>pan and zoom</source>
        <translation>平移和缩放</translation>
    </message>
    <message>
        <source>enlarge all slices, or restore</source>
        <translation>放大所有层面，或恢复</translation>
    </message>
    <message>
        <source>While picking landmarks</source>
        <translation>选取标志点时</translation>
    </message>
    <message>
        <source>While editing vessels</source>
        <translation>编辑血管时</translation>
    </message>
    <message>
        <source>In a slice</source>
        <translation>在层面上</translation>
    </message>
    <message>
        <source>show only this view, or restore</source>
        <translation>仅显示此视图，或恢复</translation>
    </message>
    <message>
        <source>S, then A or Del</source>
        <translation>S，再按 A 或 Del</translation>
    </message>
    <message>
        <source>next dashed curve: keep or exclude</source>
        <translation>下一条虚线曲线：保留或排除</translation>
    </message>
    <message>
        <source>While setting the rotation center</source>
        <translation>设置旋转中心时</translation>
    </message>
    <message>
        <source>a point on the vessels, in the image, in 3-D or in a slice</source>
        <translation>血管上的点：图像、三维视图或层面中</translation>
    </message>
    <message>
        <source>← →</source>
        <translation>← →</translation>
    </message>
    <message>
        <source>next bifurcation or branch end</source>
        <translation>下一个分叉或末端</translation>
    </message>
    <message>
        <source>accept the point shown</source>
        <translation>采用所示的点</translation>
    </message>
    <message>
        <source>reset to the centroid</source>
        <translation>恢复为质心</translation>
    </message>
    <message>
        <source>While measuring</source>
        <translation>测量时</translation>
    </message>
    <message>
        <source>click, drag</source>
        <translation>单击、拖动</translation>
    </message>
    <message>
        <source>set a point, or move an existing one</source>
        <translation>放置点，或移动已有的点</translation>
    </message>
    <message>
        <source>Enter, double-click</source>
        <translation>回车、双击</translation>
    </message>
    <message>
        <source>close an area</source>
        <translation>闭合区域</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>退格</translation>
    </message>
    <message>
        <source>remove the last point</source>
        <translation>删除最后一点</translation>
    </message>
    <message>
        <source>remove the selected measurement or the last one</source>
        <translation>移除所选测量或最后一个测量</translation>
    </message>
    <message>
        <source>While marking</source>
        <translation>标记时</translation>
    </message>
    <message>
        <source>add a target point or ring to the vessels, here, in 3-D or in a slice</source>
        <translation>在血管上添加目标点或环（此处、三维或层面）</translation>
    </message>
    <message>
        <source>draw an arrow or move an existing mark</source>
        <translation>绘制箭头或移动已有标记</translation>
    </message>
    <message>
        <source>finish the text; Esc discards it</source>
        <translation>完成文字；Esc 放弃</translation>
    </message>
    <message>
        <source>remove the selected mark or the last one</source>
        <translation>移除所选标记或最后一个标记</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::KeySheet</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>Search shortcuts and commands</source>
        <translation>搜索快捷键和命令</translation>
    </message>
    <message>
        <source>Search shortcuts</source>
        <translation>搜索快捷键</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>No shortcut for “%1”.</source>
        <translation>没有“%1”的快捷键。</translation>
    </message>
    <message>
        <source>Shortcuts and their commands</source>
        <translation>快捷键及其命令</translation>
    </message>
    <message>
        <source>Reset all shortcuts</source>
        <translation>重置所有快捷键</translation>
    </message>
    <message>
        <source>Double-click a command or press Enter to assign a shortcut.</source>
        <translation>双击命令或按回车键以指定快捷键。</translation>
    </message>
    <message>
        <source>This shortcut is fixed.</source>
        <translation>此快捷键不可更改。</translation>
    </message>
    <message>
        <source>Press the new shortcut for “%1”. Esc keeps the old shortcut; Delete removes it.</source>
        <translation>请按“%1”的新快捷键。Esc 保留原快捷键，Delete 清除。</translation>
    </message>
    <message>
        <source>The old shortcut is kept.</source>
        <translation>保留原快捷键。</translation>
    </message>
    <message>
        <source>“%1” is reserved. Press another key.</source>
        <translation>“%1”为保留键。请按其他键。</translation>
    </message>
    <message>
        <source>“%1” is assigned to “%2”. Press it again to reassign it, or press another key.</source>
        <translation>“%1”已指定给“%2”。再按一次可改为指定给此命令，或按其他键。</translation>
    </message>
    <message>
        <source>Shortcut removed.</source>
        <translation>已清除快捷键。</translation>
    </message>
    <message>
        <source>The shortcut is now “%1”.</source>
        <translation>快捷键现为“%1”。</translation>
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
        <translation>标签 %1</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全选</translation>
    </message>
    <message>
        <source>Selects all labels in the list</source>
        <translation>选择列表中的所有标签</translation>
    </message>
    <message>
        <source>None</source>
        <translation>全不选</translation>
    </message>
    <message>
        <source>Deselects all labels in the list</source>
        <translation>取消选择列表中的所有标签</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>血管</translation>
    </message>
    <message>
        <source>Selects the labels whose names indicate vessels</source>
        <translation>选择名称表示血管的标签</translation>
    </message>
    <message>
        <source>Find a label</source>
        <translation>查找标签</translation>
    </message>
    <message>
        <source>Vessel labels</source>
        <translation>血管标签</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Reading the labels…</source>
        <translation>正在读取标签…</translation>
    </message>
    <message>
        <source>%1 of %2 selected, %3</source>
        <translation>已选择 %1 / %2，%3</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::LandmarkPanel</name>
    <message>
        <source>Landmarks</source>
        <translation>标志点</translation>
    </message>
    <message>
        <source>Compute pose</source>
        <translation>计算位姿</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Landmarks and their residuals</source>
        <translation>标志点及其残差</translation>
    </message>
    <message>
        <source>Computes the initial pose from the pairs, as does pressing Enter while picking. Undo restores the previous pose.</source>
        <translation>由点对计算初始位姿，点选时按回车亦可。可撤销以恢复原位姿。</translation>
    </message>
    <message>
        <source>Removes the selected pairs (Delete)</source>
        <translation>移除所选点对（Delete）</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>not in view</source>
        <translation>不在视野内</translation>
    </message>
    <message>
        <source>%1 pairs</source>
        <translation>%1 对</translation>
    </message>
    <message>
        <source>Pick pairs</source>
        <translation>选取点对</translation>
    </message>
    <message>
        <source>Click a point on the vessels in 3-D (or a slice), then the same point in the image.</source>
        <translation>先在三维（或层面）中单击血管上一点，再在图像中单击同一点。</translation>
    </message>
    <message>
        <source>%1: click pairs, then compute</source>
        <translation>%1：先点选点对，再计算</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::LandmarkTool</name>
    <message>
        <source>Landmarks: now click the same point in the image</source>
        <translation>标志点：请在图像中单击同一位置</translation>
    </message>
    <message>
        <source>Landmarks: now click the same point on the vessels in 3-D</source>
        <translation>标志点：请在三维血管上单击同一位置</translation>
    </message>
    <message>
        <source>Landmarks: click in 3-D and here, or drag a node · Enter computes the pose</source>
        <translation>标志点：在三维和此处单击，或拖动节点 · 回车计算位姿</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::LassoTool</name>
    <message>
        <source>Lasso: draw around the auxiliary branches · Shift adds · Ctrl removes · Esc ends</source>
        <translation>套索：圈选辅助分支 · Shift 追加 · Ctrl 移除 · Esc 结束</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MainWindow</name>
    <message>
        <source>AngioPose: angiogram</source>
        <translation>AngioPose：血管造影</translation>
    </message>
    <message>
        <source>AngioPose: 3-D and slices</source>
        <translation>AngioPose：三维和层面</translation>
    </message>
    <message>
        <source>AngioPose: slices</source>
        <translation>AngioPose：层面</translation>
    </message>
    <message>
        <source>Branches, 3-D and slices</source>
        <translation>分支、三维和层面</translation>
    </message>
    <message>
        <source>Pose, registration, result</source>
        <translation>位姿、配准、结果</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MaskShiftTool</name>
    <message>
        <source>Pixel shift: arrow keys or drag, Shift 1 px, Ctrl 0.05 px, Esc ends · right %1, down %2 px</source>
        <translation>像素位移：方向键或拖动，Shift 1 px，Ctrl 0.05 px，Esc 结束 · 右 %1，下 %2 px</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MessageDialog</name>
    <message>
        <source>Details</source>
        <translation>详细信息</translation>
    </message>
    <message>
        <source>Copy details</source>
        <translation>复制详细信息</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MissingInputs</name>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Inputs not found</source>
        <translation>未找到输入文件</translation>
    </message>
    <message>
        <source>“%1” refers to files that have been moved or deleted. The files were not found next to the case or in the folders of recent cases. The case file itself is intact.</source>
        <translation>“%1”引用的文件已移动或删除。在病例旁及最近病例的文件夹中均未找到这些文件。病例文件本身完好。</translation>
    </message>
    <message>
        <source>formerly in %1</source>
        <translation>原在 %1</translation>
    </message>
    <message>
        <source>Locate…</source>
        <translation>查找…</translation>
    </message>
    <message>
        <source>Locate %1</source>
        <translation>查找 %1</translation>
    </message>
    <message>
        <source>Search a folder…</source>
        <translation>搜索文件夹…</translation>
    </message>
    <message>
        <source>Searches the folder and its subfolders by file name and contents.</source>
        <translation>按文件名和内容搜索该文件夹及其子文件夹。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>now: %1</source>
        <translation>现为 %1</translation>
    </message>
    <message>
        <source>Search a folder</source>
        <translation>搜索文件夹</translation>
    </message>
    <message>
        <source>Open anyway</source>
        <translation>仍然打开</translation>
    </message>
    <message>
        <source>Only an additional scan or another view is missing. Everything else can be opened.</source>
        <translation>仅缺少血管之外的扫描或另一视图，其余内容均可打开。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MotionPlot</name>
    <message>
        <source>Vessel motion by frame</source>
        <translation>血管逐帧运动</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>第 %1 帧</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>frame %1: %2 mm in plane, %3 mm in depth, %4°</source>
        <translation>第 %1 帧：平面内 %2 mm，深度 %3 mm，%4°</translation>
    </message>
    <message>
        <source>%1 (not explained by the vessels)</source>
        <translation>%1（血管无法解释）</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::NudgeTool</name>
    <message>
        <source>Nudge: drag to move · ring to roll · arcs to tilt · slider for depth · Ctrl = fine · Esc cancels</source>
        <translation>微调：拖动平移 · 圆环滚转 · 弧线倾斜 · 滑块调深度 · Ctrl = 精细 · Esc 取消</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::OpacificationPlot</name>
    <message>
        <source>Opacification by frame</source>
        <translation>各帧显影程度</translation>
    </message>
    <message>
        <source>%1 · %2 s</source>
        <translation>%1 · %2 s</translation>
    </message>
    <message>
        <source>The curve requires a run with several frames</source>
        <translation>只有多帧序列才有曲线</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PivotMark</name>
    <message>
        <source>rotation center</source>
        <translation>旋转中心</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PivotTool</name>
    <message>
        <source>Rotation center: click the vessels, here or in 3-D · ← → and Enter: bifurcations · Del: centroid</source>
        <translation>旋转中心：在此处或三维视图中单击血管 · ← → 和回车：分叉 · Delete：质心</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PortDialog</name>
    <message>
        <source>Encrypted (TLS)</source>
        <translation>加密（TLS）</translation>
    </message>
    <message>
        <source>Local certificate (PEM)</source>
        <translation>本机证书（PEM）</translation>
    </message>
    <message>
        <source>Private key of the local certificate (PEM)</source>
        <translation>本机证书的私钥（PEM）</translation>
    </message>
    <message>
        <source>Trusted certificates (PEM)</source>
        <translation>受信任的证书（PEM）</translation>
    </message>
    <message>
        <source>Security of the receiving port</source>
        <translation>接收端口的安全设置</translation>
    </message>
    <message>
        <source>With TLS, both the calling application and this program must present a valid certificate.</source>
        <translation>使用 TLS 时，呼叫方和本程序均须出示有效证书。</translation>
    </message>
    <message>
        <source>anyone</source>
        <translation>任何人</translation>
    </message>
    <message>
        <source>Allowed calling AE titles</source>
        <translation>允许的呼叫方 AE 标题</translation>
    </message>
    <message>
        <source>Comma-separated; leave empty to allow any</source>
        <translation>以逗号分隔；留空：任意</translation>
    </message>
    <message>
        <source>Allowed addresses</source>
        <translation>允许的地址</translation>
    </message>
    <message>
        <source>Comma-separated IP addresses, such as 10.0.0.7; leave empty to allow any</source>
        <translation>以逗号分隔的 IP 地址，如 10.0.0.7；留空：任意</translation>
    </message>
    <message>
        <source>Local certificate</source>
        <translation>本机证书</translation>
    </message>
    <message>
        <source>PEM file presented to calling applications</source>
        <translation>向呼叫方出示的 PEM 文件</translation>
    </message>
    <message>
        <source>Private key</source>
        <translation>私钥</translation>
    </message>
    <message>
        <source>PEM file; only its path is stored</source>
        <translation>PEM 文件；仅保存其路径</translation>
    </message>
    <message>
        <source>Trusted certificates</source>
        <translation>受信任的证书</translation>
    </message>
    <message>
        <source>PEM file used to verify the certificates of calling applications; if empty, the certificates trusted by the system are used</source>
        <translation>用于验证呼叫方证书的 PEM 文件；留空：系统信任的证书</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PoseAxis</name>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>up</source>
        <translation>上</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>滚转</translation>
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
        <translation>屏幕向右，血管处毫米数。微调：← →</translation>
    </message>
    <message>
        <source>Up on screen, in mm at the vessels. Nudge: ↑ ↓</source>
        <translation>屏幕向上，血管处毫米数。微调：↑ ↓</translation>
    </message>
    <message>
        <source>Away from the X-ray source, in mm. Nudge: PgUp PgDn</source>
        <translation>远离 X 射线源，单位 mm。微调：PgUp PgDn</translation>
    </message>
    <message>
        <source>Clockwise on screen. Nudge: , .</source>
        <translation>屏幕顺时针。微调：, .</translation>
    </message>
    <message>
        <source>Equivalent to rotating the C-arm toward LAO (+) or RAO (−). Nudge: Alt+← Alt+→</source>
        <translation>相当于 C 形臂转向 LAO (+) 或 RAO (−)。微调：Alt+← Alt+→</translation>
    </message>
    <message>
        <source>Equivalent to rotating the C-arm cranially (+) or caudally (−). Nudge: Alt+↑ Alt+↓</source>
        <translation>相当于 C 形臂转向头位 (+) 或足位 (−)。微调：Alt+↑ Alt+↓</translation>
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
        <translation>位姿</translation>
    </message>
    <message>
        <source>Reset to initial pose</source>
        <translation>重置为初始位姿</translation>
    </message>
    <message>
        <source>Pose %1</source>
        <translation>位姿 %1</translation>
    </message>
    <message>
        <source>Lock %1</source>
        <translation>锁定%1</translation>
    </message>
    <message>
        <source>Locks this value: nudging, dragging, typing and registration do not change it.</source>
        <translation>锁定此值：微调、拖动、输入和配准均不改变它。</translation>
    </message>
    <message>
        <source>Undo restores the pose.</source>
        <translation>撤销可恢复位姿。</translation>
    </message>
    <message>
        <source>nudging · arrow keys · %1 to exit</source>
        <translation>微调中 · 方向键 · %1 结束</translation>
    </message>
    <message>
        <source>%1: nudge (Ctrl fine, Shift coarse)</source>
        <translation>%1：微调（Ctrl 精细，Shift 粗调）</translation>
    </message>
    <message>
        <source>Rotations and translations refer to the selected rotation center. %1 resets it to the centroid.</source>
        <translation>旋转和平移均以所选旋转中心为准。%1 重置为质心。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PoseTable</name>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Runs the selected methods one after another from the current pose.</source>
        <translation>从当前位姿起依次运行所选方法。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stops the running method and skips the rest; finished results are kept.</source>
        <translation>停止当前方法并跳过其余方法；已完成的结果保留。</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Moves the vessels to this pose; can be undone.</source>
        <translation>将血管移到此位姿；可撤销。</translation>
    </message>
    <message>
        <source>Use as reference</source>
        <translation>作为参考</translation>
    </message>
    <message>
        <source>Shows differences relative to this pose.</source>
        <translation>显示相对此位姿的差值。</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Deletes the snapshots; can be undone.</source>
        <translation>删除快照；可撤销。</translation>
    </message>
    <message>
        <source>Compare poses</source>
        <translation>比较位姿</translation>
    </message>
    <message>
        <source>Poses side by side</source>
        <translation>并列位姿</translation>
    </message>
    <message>
        <source>Pose</source>
        <translation>位姿</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Median (mm)</source>
        <translation>中位数（mm）</translation>
    </message>
    <message>
        <source>P95 (mm)</source>
        <translation>P95（mm）</translation>
    </message>
    <message>
        <source>Coverage (%)</source>
        <translation>覆盖率（%）</translation>
    </message>
    <message>
        <source>Δ in-plane (mm)</source>
        <translation>Δ 平面内（mm）</translation>
    </message>
    <message>
        <source>Δ depth (mm)</source>
        <translation>Δ 深度（mm）</translation>
    </message>
    <message>
        <source>Δ rot. (°)</source>
        <translation>Δ 旋转（°）</translation>
    </message>
    <message>
        <source>Time (ms)</source>
        <translation>用时（ms）</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>作者</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>导出 CSV…</translation>
    </message>
    <message>
        <source>Writes the table to a CSV file, with the poses as matrices.</source>
        <translation>将表格写入 CSV 文件，位姿以矩阵表示。</translation>
    </message>
    <message>
        <source>Run several methods</source>
        <translation>运行多种方法</translation>
    </message>
    <message>
        <source>Results are added to the table; the case is unchanged</source>
        <translation>结果加入表格；病例不变</translation>
    </message>
    <message>
        <source>Current pose</source>
        <translation>当前位姿</translation>
    </message>
    <message>
        <source>This registration is not reliable.</source>
        <translation>此配准不可靠。</translation>
    </message>
    <message>
        <source>Differences are relative to “%1”, about the center of the tree. Amber: not reliable.</source>
        <translation>差值相对于“%1”，以血管树中心为准。琥珀色：不可靠。</translation>
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
        <translation>修剪</translation>
    </message>
    <message>
        <source>Remove terminal branches that are</source>
        <translation>移除末端分支，条件为</translation>
    </message>
    <message>
        <source>shorter than</source>
        <translation>长度小于</translation>
    </message>
    <message>
        <source>thinner than (mean radius)</source>
        <translation>细于（平均半径）</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>No branch would remain. Lower the limits.</source>
        <translation>将不剩任何分支。请降低限值。</translation>
    </message>
    <message>
        <source>Nothing to remove.</source>
        <translation>没有要移除的分支。</translation>
    </message>
    <message>
        <source>1 branch will be removed.</source>
        <translation>将移除 1 个分支。</translation>
    </message>
    <message>
        <source>%1 branches will be removed.</source>
        <translation>将移除 %1 个分支。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::RecoveryDialog</name>
    <message>
        <source>Recover</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Recover unsaved work?</source>
        <translation>恢复未保存的工作吗？</translation>
    </message>
    <message>
        <source>AngioPose ended unexpectedly. These cases had unsaved changes. “Recover” opens the copy and leaves the saved case unchanged.</source>
        <translation>AngioPose 意外退出。这些病例有未保存的更改。恢复会打开副本，已保存的病例不变。</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>暂不</translation>
    </message>
    <message>
        <source>Copies of unsaved work</source>
        <translation>未保存工作的副本</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>病例</translation>
    </message>
    <message>
        <source>Last copy</source>
        <translation>最后副本</translation>
    </message>
    <message>
        <source>Saved in</source>
        <translation>保存于</translation>
    </message>
    <message>
        <source>never saved</source>
        <translation>从未保存</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::RegistrationPanel</name>
    <message>
        <source>Registration</source>
        <translation>配准</translation>
    </message>
    <message>
        <source>Method and options</source>
        <translation>方法和选项</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>配准</translation>
    </message>
    <message>
        <source>Stops the registration and keeps the best pose so far.</source>
        <translation>停止配准并保留目前的最佳位姿。</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>About this method</source>
        <translation>关于此方法</translation>
    </message>
    <message>
        <source>Explains which cost this method minimizes, when the method fails, and where it was published.</source>
        <translation>显示此方法最小化的目标函数、失效情形及出处。</translation>
    </message>
    <message>
        <source>1 auxiliary branch</source>
        <translation>1 个辅助分支</translation>
    </message>
    <message>
        <source>%1 auxiliary branches</source>
        <translation>%1 个辅助分支</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Registering…</source>
        <translation>配准中…</translation>
    </message>
    <message>
        <source>Registration keeps the locked degree of freedom fixed.</source>
        <translation>配准时保持锁定的自由度不变。</translation>
    </message>
    <message>
        <source>Registration keeps the %1 locked degrees of freedom fixed.</source>
        <translation>配准时保持 %1 个锁定的自由度不变。</translation>
    </message>
    <message>
        <source>Register all %1 views jointly</source>
        <translation>%1 个视图联合配准</translation>
    </message>
    <message>
        <source>Finds the pose that aligns the vessels with the angiogram.</source>
        <translation>求使血管与造影图像对齐的位姿。</translation>
    </message>
    <message>
        <source>Uses one pose for all views. Moving the vessels manually moves them in every view. Registration fits all views jointly with the method AngioPose: the depth in one view is then determined by the in-plane translation in another. If off, only the displayed view is used.</source>
        <translation>所有视图共用一个位姿。手动移动时各视图中的血管一起移动。配准时用 AngioPose 方法同时拟合所有视图：一个视图中的深度由另一个视图中的平面内平移确定。不勾选时只使用显示的视图。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ResultPanel</name>
    <message>
        <source>%1 · from an earlier registration</source>
        <translation>%1 · 来自较早的配准</translation>
    </message>
    <message>
        <source>The inputs have changed since this registration. Press R to update.</source>
        <translation>此次配准后输入已改变。按 R 重新配准。</translation>
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
        <translation>%1 · 手动移动</translation>
    </message>
    <message>
        <source>%1 · initial pose</source>
        <translation>%1 · 初始位姿</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>Convergence</source>
        <translation>收敛</translation>
    </message>
    <message>
        <source>median, mm</source>
        <translation>中位数，mm</translation>
    </message>
    <message>
        <source>P95, mm</source>
        <translation>P95，mm</translation>
    </message>
    <message>
        <source>coverage</source>
        <translation>覆盖率</translation>
    </message>
    <message>
        <source>Share of the traced vessel length that lies within 3 px of the tree.</source>
        <translation>距血管树 3 px 以内的已提取血管长度所占比例。</translation>
    </message>
    <message>
        <source>± is one standard deviation.</source>
        <translation>± 为一个标准差。</translation>
    </message>
    <message>
        <source>nothing to assess yet</source>
        <translation>尚无可评估内容</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Initial pose, not registered yet. Press R to register, N to nudge.</source>
        <translation>初始位姿，尚未配准。按 R 配准，N 微调。</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>in-plane (mm), by frame</source>
        <translation>平面内 mm，逐帧</translation>
    </message>
    <message>
        <source>%1 · tracked</source>
        <translation>%1 · 已跟踪</translation>
    </message>
    <message>
        <source>%1 → %2 px · steps: %3</source>
        <translation>%1 → %2 px · 步数：%3</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>第 %1 步</translation>
    </message>
    <message>
        <source>median %1 mm over the %2 % classified as opacified, %3 mm over the whole tree</source>
        <translation>中位数 %1 mm（判定为显影的 %2 %），整个血管树 %3 mm</translation>
    </message>
    <message>
        <source>median %1 mm</source>
        <translation>中位数 %1 mm</translation>
    </message>
    <message>
        <source>Moved manually, not registered</source>
        <translation>手动移动，未配准</translation>
    </message>
    <message>
        <source>Inputs have changed since this registration</source>
        <translation>此次配准后输入已改变</translation>
    </message>
    <message>
        <source>Initial pose, not registered</source>
        <translation>初始位姿，未配准</translation>
    </message>
    <message>
        <source>NOT RELIABLE · %1</source>
        <translation>不可靠 · %1</translation>
    </message>
    <message>
        <source>All checks passed · %1</source>
        <translation>所有检查均通过 · %1</translation>
    </message>
    <message>
        <source>Median distance of the vessel points classified as opacified.</source>
        <translation>判定为显影的血管点距离的中位数。</translation>
    </message>
    <message>
        <source>95th percentile of the distances of the vessel points classified as opacified.</source>
        <translation>判定为显影的血管点距离的第 95 百分位数。</translation>
    </message>
    <message>
        <source>mm, points classified as opacified</source>
        <translation>mm，判定为显影的点</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ResultSentences</name>
    <message>
        <source>%1 of %2 branches agree within %3 mm.</source>
        <translation>%2 个分支中有 %1 个吻合在 %3 mm 以内。</translation>
    </message>
    <message>
        <source>Depth ±%1 mm: not determined by a single view.</source>
        <translation>深度 ±%1 mm：单一视图无法确定。</translation>
    </message>
    <message>
        <source>The overlay is within 2 mm of the vessels with a probability of %1 %.</source>
        <translation>叠加图位于血管 2 mm 以内的概率为 %1 %。</translation>
    </message>
    <message>
        <source>Depth is the least certain: ±%1 mm.</source>
        <translation>深度最不确定：±%1 mm。</translation>
    </message>
    <message>
        <source>%1 is %2 mm off: possibly unopacified in this frame, or displaced.</source>
        <translation>%1 偏离 %2 mm：此帧中可能未显影，或已移位。</translation>
    </message>
    <message>
        <source>%1 branches are up to %2 mm off: unopacified in this frame, or the pose is wrong.</source>
        <translation>%1 个分支最多偏离 %2 mm：此帧中未显影，或位姿有误。</translation>
    </message>
    <message>
        <source>%1 and %2 are up to %3 mm off: possibly unopacified in this frame, or displaced.</source>
        <translation>%1 和 %2 最多偏离 %3 mm：此帧中可能未显影，或已移位。</translation>
    </message>
    <message>
        <source>Branch %1</source>
        <translation>分支 %1</translation>
    </message>
    <message>
        <source>In plane ±%1 mm, rotation ±%2°.</source>
        <translation>平面内 ±%1 mm，旋转 ±%2°。</translation>
    </message>
    <message>
        <source>In plane ±%1 mm.</source>
        <translation>平面内 ±%1 mm。</translation>
    </message>
    <message>
        <source>Rotation ±%1°.</source>
        <translation>旋转 ±%1°。</translation>
    </message>
    <message>
        <source>3-D uncertainty incl. geometry: depth ±%1 mm, lateral ±%2 mm.</source>
        <translation>含几何误差的三维不确定度：深度 ±%1 mm，横向 ±%2 mm。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::Section</name>
    <message>
        <source>Collapse or expand %1</source>
        <translation>折叠或展开%1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SeriesChooser</name>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Choose a series</source>
        <translation>选择序列</translation>
    </message>
    <message>
        <source>Which series?</source>
        <translation>哪个序列？</translation>
    </message>
    <message numerus="yes">
        <source>%1 contains %n series.</source>
        <translation>
            <numerusform>%1 含 %n 个序列。</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Series in the folder</source>
        <translation>文件夹中的序列</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>描述</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>模态</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>图像数</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Spacing (mm)</source>
        <translation>间距（mm）</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SliceModel</name>
    <message>
        <source>Axial</source>
        <translation>轴位</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>冠状位</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>矢状位</translation>
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
        <translation>无扫描</translation>
    </message>
    <message>
        <source>%1 %2 / %3</source>
        <translation>%1 %2 / %3</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>范围外</translation>
    </message>
    <message>
        <source>%1 HU</source>
        <translation>%1 HU</translation>
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
        <translation>手动</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SnapshotPanel</name>
    <message>
        <source>median %1 mm, 95th percentile %2 mm, coverage %3 %</source>
        <translation>中位数 %1 mm，第 95 百分位数 %2 mm，覆盖率 %3 %</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>第 %1 帧</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>位姿</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>比较…</translation>
    </message>
    <message>
        <source>Snapshots</source>
        <translation>快照</translation>
    </message>
    <message>
        <source>Registrations (%1)</source>
        <translation>配准（%1）</translation>
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
        <translation>恢复	Return</translation>
    </message>
    <message>
        <source>Use as A</source>
        <translation>作为 A</translation>
    </message>
    <message>
        <source>Use as B</source>
        <translation>作为 B</translation>
    </message>
    <message>
        <source>Rename	F2</source>
        <translation>重命名	F2</translation>
    </message>
    <message>
        <source>Delete	Del</source>
        <translation>删除	Del</translation>
    </message>
    <message>
        <source>%1 saves the pose; %2 toggles A/B. Each registration is listed here.</source>
        <translation>%1 保存位姿；%2 切换 A/B。每次配准都列在此处。</translation>
    </message>
    <message>
        <source>Save pose</source>
        <translation>保存位姿</translation>
    </message>
    <message>
        <source>Saves this pose and its values as a named snapshot.</source>
        <translation>将此位姿及其数值保存为命名快照。</translation>
    </message>
    <message>
        <source>Compares poses and methods in a table.</source>
        <translation>在表格中比较位姿和方法。</translation>
    </message>
    <message>
        <source>median (mm) · %1: A ⇄ B</source>
        <translation>中位数（mm） · %1：A ⇄ B</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SolutionStrip</name>
    <message>
        <source>Solutions</source>
        <translation>解</translation>
    </message>
    <message>
        <source>Solutions of this registration</source>
        <translation>本次配准的解</translation>
    </message>
    <message>
        <source>%1: next · %2: accept</source>
        <translation>%1：下一个 · %2：采用</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::StepBar</name>
    <message>
        <source>Vessels</source>
        <translation>血管</translation>
    </message>
    <message>
        <source>Angiogram</source>
        <translation>造影</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>几何</translation>
    </message>
    <message>
        <source>Initial pose</source>
        <translation>初始位姿</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>配准</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>核查</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::StepButton</name>
    <message>
        <source>done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>check</source>
        <translation>需检查</translation>
    </message>
    <message>
        <source>to do</source>
        <translation>待完成</translation>
    </message>
    <message>
        <source>%1: %2, %3</source>
        <translation>%1：%2，%3</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::Tour</name>
    <message>
        <source>Back</source>
        <translation>上一步</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>跳过</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
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
        <translation>种子点</translation>
    </message>
    <message>
        <source>Click vessels in a slice. Only vessels connected to a seed are traced.</source>
        <translation>在层面上单击血管。只提取与种子点相连的血管。</translation>
    </message>
    <message>
        <source>Avoid</source>
        <translation>避开</translation>
    </message>
    <message>
        <source>Click the heart, veins or bone in a slice. Regions with a wider connection to these points than to the seeds are excluded.</source>
        <translation>在层面上单击心脏、静脉或骨骼。与这些点的连通宽于与种子点的连通的区域将被排除。</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Seeds and points to avoid</source>
        <translation>种子点和避开点</translation>
    </message>
    <message>
        <source>+ seed %1</source>
        <translation>+ 种子点 %1</translation>
    </message>
    <message>
        <source>× avoid %1</source>
        <translation>× 避开 %1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ThresholdField</name>
    <message>
        <source>Automatic threshold</source>
        <translation>自动阈值</translation>
    </message>
    <message>
        <source>HU</source>
        <translation>HU</translation>
    </message>
    <message>
        <source>Preview threshold</source>
        <translation>预览阈值</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>阈值</translation>
    </message>
    <message>
        <source>Voxels above this scan intensity are treated as vessel lumen.</source>
        <translation>扫描中高于此强度的体素视为血管腔。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::TracingPanel</name>
    <message>
        <source>Thin vessels only (requires seeds)</source>
        <translation>仅细血管（需要种子点）</translation>
    </message>
    <message>
        <source>For coronary arteries next to opacified chambers or hepatic arteries next to the portal vein: tracing stops at structures wider than 1 cm. Requires seeds.</source>
        <translation>用于显影心腔旁的冠状动脉或门静脉旁的肝动脉：遇到宽于 1 cm 的结构即停止提取。需要种子点。</translation>
    </message>
    <message>
        <source>Trace between two points</source>
        <translation>两点间提取血管</translation>
    </message>
    <message>
        <source>Trace vessels</source>
        <translation>提取血管</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>提取</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Min. length</source>
        <translation>最小长度</translation>
    </message>
    <message>
        <source>Removes branches that extend less than this beyond the wall of their parent vessel.</source>
        <translation>移除超出母血管壁的长度小于此值的分支。</translation>
    </message>
    <message>
        <source>Min. mean radius</source>
        <translation>最小平均半径</translation>
    </message>
    <message>
        <source>Removes branches with a smaller mean radius.</source>
        <translation>移除平均半径更小的分支。</translation>
    </message>
    <message>
        <source>Keep loops</source>
        <translation>保留环</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>连通部分</translation>
    </message>
    <message>
        <source>Used only if there are no seeds. Default: in a mask, all components; in a scan, the component of the aorta or main artery. All: in a scan, the components of all great vessels.</source>
        <translation>无种子点时使用。默认：掩膜取所有连通域；扫描取主动脉或主干动脉所在连通域。全部：扫描取每条大血管所在连通域。</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Keeps vessel loops closed; otherwise, each loop is cut at its narrowest point.</source>
        <translation>保持成环的血管闭合；否则在每个环的最窄处断开。</translation>
    </message>
    <message>
        <source>Cancels tracing; the vessels stay unchanged.</source>
        <translation>取消提取；血管保持不变。</translation>
    </message>
    <message>
        <source>Tracing…</source>
        <translation>提取中…</translation>
    </message>
    <message>
        <source>Click in a slice to place a point; Esc ends.</source>
        <translation>在层面上单击以放置点；Esc 结束。</translation>
    </message>
    <message>
        <source>The traced vessels replace the current tree; can be undone.</source>
        <translation>提取的血管将替换当前血管树；可撤销。</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Add seed</source>
        <translation>添加种子点</translation>
    </message>
    <message>
        <source>Shows the untraced vessel in the slices.</source>
        <translation>在层面中显示未提取的血管。</translation>
    </message>
    <message>
        <source>Places a seed in this vessel and one in the traced vessel next to it.</source>
        <translation>在此血管及其旁的已提取血管内各放置一个种子点。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::TreeView</name>
    <message>
        <source>No vessels yet: drop them here, open them (%1), or trace a scan in its slices (%2).</source>
        <translation>尚无血管：拖放到此处，打开（%1），或在扫描层面中提取（%2）。</translation>
    </message>
    <message>
        <source>3-D view of vessel tree, X-ray source and detector</source>
        <translation>血管树、X 射线源和探测器的三维视图</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::TrialBar</name>
    <message>
        <source>Abandon</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Ends the trial and logs it as abandoned.</source>
        <translation>结束试验并记录为已放弃。</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Blind trial by %1: align the vessels with the image. Values are shown again when you are done.</source>
        <translation>%1 的盲法试验：将血管与图像对齐。完成后重新显示数值。</translation>
    </message>
    <message>
        <source>Logs the time and the pose, and shows the values again.</source>
        <translation>记录时间和位姿，并重新显示数值。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ViewFrame</name>
    <message>
        <source>Shown in a separate window</source>
        <translation>在独立窗口中显示</translation>
    </message>
    <message>
        <source>Bring back</source>
        <translation>移回</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ViewPane</name>
    <message>
        <source>Frames of this view</source>
        <translation>此视图的帧</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ViewStrip</name>
    <message>
        <source>Side by side</source>
        <translation>并排</translation>
    </message>
    <message>
        <source>Shows all views side by side or only the current one</source>
        <translation>并排显示所有视图，或只显示当前视图</translation>
    </message>
    <message>
        <source>Crosshair</source>
        <translation>十字线</translation>
    </message>
    <message>
        <source>Shows the point under the mouse pointer as an epipolar line in the other views and as a point on the vessels</source>
        <translation>将指针所指之处在其他视图中显示为极线，在血管上显示为点</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Add a view</source>
        <translation>添加视图</translation>
    </message>
    <message>
        <source>Adds another angiogram of the same vessels (Ctrl+Shift+V)</source>
        <translation>添加同一血管的另一造影图像（Ctrl+Shift+V）</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::VtkView</name>
    <message>
        <source>The 3-D view requires OpenGL 3.2, which this display does not support. Everything else works. Try LIBGL_ALWAYS_SOFTWARE=1, or install libgl1-mesa-dri.</source>
        <translation>三维视图需要 OpenGL 3.2，此显示环境不支持。其他功能正常。可尝试 LIBGL_ALWAYS_SOFTWARE=1，或安装 libgl1-mesa-dri。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::WelcomePage</name>
    <message>
        <source>Register a vessel tree to an angiogram</source>
        <translation>将血管树配准到造影图像</translation>
    </message>
    <message>
        <source>Open the sample case</source>
        <translation>打开示例病例</translation>
    </message>
    <message>
        <source>Drop a case here, or vessels together with an angiogram.</source>
        <translation>将病例，或血管与造影图像一起拖到此处。</translation>
    </message>
    <message>
        <source>Vessels: CT as DICOM folder, NIfTI, NRRD or MetaImage, masks, centerlines (VTP, VTK, CSV, SWC).  Angiograms: DICOM XA, PNG, TIFF.</source>
        <translation>血管：CT（DICOM 文件夹、NIfTI、NRRD 或 MetaImage）、掩膜、中心线（VTP、VTK、CSV、SWC）。造影图像：DICOM XA、PNG、TIFF。</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>打开…</translation>
    </message>
    <message>
        <source>Open DICOM folder/CD…</source>
        <translation>打开 DICOM 文件夹/光盘…</translation>
    </message>
    <message>
        <source>Lists the patients, studies and series in a folder, on a CD or in a DICOMDIR.</source>
        <translation>列出文件夹、光盘或 DICOMDIR 中的患者、检查和序列。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::WindowActions</name>
    <message>
        <source>Open recent</source>
        <translation>最近打开</translation>
    </message>
    <message>
        <source>Anywhere in the window</source>
        <translation>整个窗口</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::WindowBar</name>
    <message>
        <source>Window</source>
        <translation>窗宽</translation>
    </message>
    <message>
        <source>Pop out</source>
        <translation>独立窗口</translation>
    </message>
    <message>
        <source>Show angiogram</source>
        <translation>显示造影图像</translation>
    </message>
    <message>
        <source>Opens the slices in a separate window and brings them back (F9)</source>
        <translation>在独立窗口中打开层面，或将其移回（F9）</translation>
    </message>
    <message>
        <source>W %1 L %2 HU</source>
        <translation>W %1 L %2 HU</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Sets the window automatically from the values of this scan; right-drag in a slice to adjust it manually.</source>
        <translation>根据此扫描的数值自动设定窗；在层面上右键拖动可手动调整。</translation>
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
        <translation>骨窗</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>软组织窗</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>肺窗</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MessageHistory</name>
    <message>
        <source>Messages</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>No messages yet.</source>
        <translation>尚无消息。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::MeasureWords</name>
    <message>
        <source>Frame %1.</source>
        <translation>第 %1 帧。</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>%1 in the scan</source>
        <translation>扫描中 %1</translation>
    </message>
    <message>
        <source>%1, %2 %3 mm.</source>
        <translation>%1，%2 %3 mm。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::MeasureController</name>
    <message>
        <source>Measure length</source>
        <translation>测量长度</translation>
    </message>
    <message>
        <source>Measure angle</source>
        <translation>测量角度</translation>
    </message>
    <message>
        <source>Measure area</source>
        <translation>测量面积</translation>
    </message>
    <message>
        <source>Move measurement point</source>
        <translation>移动测量点</translation>
    </message>
    <message>
        <source>Rename measurement</source>
        <translation>重命名测量</translation>
    </message>
    <message>
        <source>Remove measurement</source>
        <translation>移除测量</translation>
    </message>
    <message>
        <source>Measure in another plane</source>
        <translation>在另一平面测量</translation>
    </message>
    <message>
        <source>Enter image scale</source>
        <translation>输入图像比例</translation>
    </message>
    <message>
        <source>Open an angiogram or a scan first.</source>
        <translation>请先打开造影图像或扫描。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MeasurePanel</name>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Table…</source>
        <translation>表格…</translation>
    </message>
    <message>
        <source>Measurement basis</source>
        <translation>测量基准</translation>
    </message>
    <message>
        <source>Measures lengths at the depth of the vessels, at the detector, or in pixels.</source>
        <translation>在血管深度处、探测器上或以像素测量长度。</translation>
    </message>
    <message>
        <source>Removes the selected measurements (Delete)</source>
        <translation>移除所选测量（Delete）</translation>
    </message>
    <message>
        <source>Writes all measurements and their basis to a CSV file.</source>
        <translation>将所有测量及其依据写入 CSV 文件。</translation>
    </message>
    <message>
        <source>at the vessels</source>
        <translation>血管处</translation>
    </message>
    <message>
        <source>at the detector</source>
        <translation>探测器处</translation>
    </message>
    <message>
        <source>in pixels</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>by entered scale</source>
        <translation>按输入比例</translation>
    </message>
    <message>
        <source> mm per pixel</source>
        <translation> mm/像素</translation>
    </message>
    <message>
        <source>no scale entered</source>
        <translation>未输入比例</translation>
    </message>
    <message>
        <source>Image scale</source>
        <translation>图像比例</translation>
    </message>
    <message>
        <source>Pixel size in the patient, if known from another source.</source>
        <translation>患者体内的像素大小（若从其他来源已知）。</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Measurements in image and slices</source>
        <translation>图像和层面中的测量</translation>
    </message>
    <message>
        <source>measured: %1</source>
        <translation>已测量 %1 项</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MeasureTool</name>
    <message>
        <source>Length: drag or click both ends · points can be moved</source>
        <translation>长度：拖动或单击两端 · 点可移动</translation>
    </message>
    <message>
        <source>Angle: click one end, the vertex, the other end · points can be moved</source>
        <translation>角度：依次单击一端、顶点、另一端 · 点可移动</translation>
    </message>
    <message>
        <source>Area: click along the outline; double-click or Enter closes it · points can be moved</source>
        <translation>面积：沿边界单击；双击或回车闭合 · 点可移动</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ProfileController</name>
    <message>
        <source>Select a branch in the list or in a view.</source>
        <translation>请在列表或视图中选择一个分支。</translation>
    </message>
    <message>
        <source>Open the vessels first.</source>
        <translation>请先打开血管。</translation>
    </message>
    <message>
        <source>Export branch measurements</source>
        <translation>导出分支测量</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Export profile</source>
        <translation>导出剖面数据</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ProfilePanel</name>
    <message>
        <source>%1 % at %2 mm (%3 of %4 mm, %5 mm long)</source>
        <translation>%1 %，位于 %2 mm（%4 mm 中的 %3，长 %5 mm）</translation>
    </message>
    <message>
        <source>Along the branch</source>
        <translation>沿分支</translation>
    </message>
    <message>
        <source>All branches…</source>
        <translation>所有分支…</translation>
    </message>
    <message>
        <source>Profile…</source>
        <translation>剖面…</translation>
    </message>
    <message>
        <source>Writes the length, diameters, stenosis and curvature of every branch to a CSV file.</source>
        <translation>将每个分支的长度、直径、狭窄和曲率写入 CSV 文件。</translation>
    </message>
    <message>
        <source>Writes the diameter and curvature along this branch to a CSV file.</source>
        <translation>将沿此分支的直径和曲率写入 CSV 文件。</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Mean diameter</source>
        <translation>平均直径</translation>
    </message>
    <message>
        <source>Min. diameter</source>
        <translation>最小直径</translation>
    </message>
    <message>
        <source>Narrowest point</source>
        <translation>最窄处</translation>
    </message>
    <message>
        <source>Tortuosity</source>
        <translation>迂曲度</translation>
    </message>
    <message>
        <source>Sharpest bend</source>
        <translation>最大弯曲</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>straight</source>
        <translation>直</translation>
    </message>
    <message>
        <source>radius %1 mm</source>
        <translation>半径 %1 mm</translation>
    </message>
    <message>
        <source>Diameters are twice the radii of the tree; the narrowest point is determined relative to the rest of the branch.</source>
        <translation>直径为血管树半径的两倍；最窄处相对于该分支其余部分。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ProfilePlot</name>
    <message>
        <source>Diameter and curvature along the branch</source>
        <translation>沿分支的直径和曲率</translation>
    </message>
    <message>
        <source>⌀ %1 mm</source>
        <translation>⌀ %1 mm</translation>
    </message>
    <message>
        <source>curvature %1/mm</source>
        <translation>曲率 %1/mm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>at %1 mm</source>
        <translation>位于 %1 mm</translation>
    </message>
    <message>
        <source>reference %1 mm</source>
        <translation>参考 %1 mm</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PlayBar</name>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Stops at the current frame. Esc returns to the frame shown before playback.</source>
        <translation>停在当前显示的帧。Esc 返回播放前的帧。</translation>
    </message>
    <message>
        <source>Plays the run</source>
        <translation>播放序列</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>循环播放</translation>
    </message>
    <message>
        <source>Back and forth</source>
        <translation>往返</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>%1 · %2 fps</source>
        <translation>%1 · %2 帧/秒</translation>
    </message>
    <message>
        <source>The header contains no frame rate: 1× corresponds to an assumed rate of %1 frames per second</source>
        <translation>文件头未给出帧率：1× 对应假定的每秒 %1 帧</translation>
    </message>
    <message>
        <source>1×: acquisition frame rate, %1 frames per second</source>
        <translation>1×：采集帧率，每秒 %1 帧</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MarkPanel</name>
    <message>
        <source>Target point</source>
        <translation>目标点</translation>
    </message>
    <message>
        <source>Ostium ring</source>
        <translation>开口环</translation>
    </message>
    <message>
        <source>Mark in image</source>
        <translation>在图像中标记</translation>
    </message>
    <message>
        <source>Arrow</source>
        <translation>箭头</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>Target points and marks</source>
        <translation>目标点与标记</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Table…</source>
        <translation>表格…</translation>
    </message>
    <message>
        <source>Removes the selected marks (Delete)</source>
        <translation>移除所选标记（Delete）</translation>
    </message>
    <message>
        <source>Writes all target points and ostium rings with their errors to a CSV file.</source>
        <translation>将所有目标点和开口环及其误差写入 CSV 文件。</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>标记</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MarkTool</name>
    <message>
        <source>Target point: click the vessels, here, in 3-D or in a slice · points can be moved</source>
        <translation>目标点：单击血管（此处、三维或层面） · 点可移动</translation>
    </message>
    <message>
        <source>Ostium ring: click the vessels, here, in 3-D or in a slice · rings can be moved</source>
        <translation>开口环：单击血管（此处、三维或层面） · 环可移动</translation>
    </message>
    <message>
        <source>Mark in image: click where the selected target point appears, or drag it there</source>
        <translation>在图像中标记：单击所选目标点在图像中的位置，或将其拖到该处</translation>
    </message>
    <message>
        <source>Arrow: drag from tail to tip, then type a label · ends can be moved</source>
        <translation>箭头：从尾端拖到尖端，然后输入 · 端点可移动</translation>
    </message>
    <message>
        <source>Text: click where the text should start, then type · text can be moved</source>
        <translation>文字：单击起点，然后输入 · 文字可移动</translation>
    </message>
    <message>
        <source>Text on the image</source>
        <translation>图像上的文字</translation>
    </message>
    <message>
        <source>Text, then Enter</source>
        <translation>输入文字后按回车</translation>
    </message>
</context>
<context>
    <name>angiopose::app::MarkController</name>
    <message>
        <source>Open the vessels first.</source>
        <translation>请先打开血管。</translation>
    </message>
    <message>
        <source>Open an angiogram first.</source>
        <translation>请先打开造影图像。</translation>
    </message>
    <message>
        <source>Add target point</source>
        <translation>添加目标点</translation>
    </message>
    <message>
        <source>Add ostium ring</source>
        <translation>添加开口环</translation>
    </message>
    <message>
        <source>Add a target point on the vessels first.</source>
        <translation>请先在血管上添加目标点。</translation>
    </message>
    <message>
        <source>Mark target point in image</source>
        <translation>在图像中标记目标点</translation>
    </message>
    <message>
        <source>Draw arrow</source>
        <translation>绘制箭头</translation>
    </message>
    <message>
        <source>Add text</source>
        <translation>添加文字</translation>
    </message>
    <message>
        <source>Move mark</source>
        <translation>移动标记</translation>
    </message>
    <message>
        <source>Rename mark</source>
        <translation>重命名标记</translation>
    </message>
    <message>
        <source>Remove mark</source>
        <translation>移除标记</translation>
    </message>
    <message>
        <source>Named points on the vessels, with the distance between their projection and their position in the image; arrows and text annotations for exported images.</source>
        <translation>血管上的命名点，及其投影与图像中位置的距离；用于导出图像的箭头和文字标注。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::MarkWords</name>
    <message>
        <source>View %1:</source>
        <translation>视图 %1：</translation>
    </message>
    <message>
        <source>arrow</source>
        <translation>箭头</translation>
    </message>
    <message>
        <source>text</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>Shown on frame %1 of this view and in every image exported from it.</source>
        <translation>位于此视图的第 %1 帧，出现在其每张导出图像中。</translation>
    </message>
    <message>
        <source>Ostium %1</source>
        <translation>开口 %1</translation>
    </message>
    <message>
        <source>Target point %1</source>
        <translation>目标点 %1</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PathController</name>
    <message>
        <source>Trace one vessel</source>
        <translation>提取一条血管</translation>
    </message>
    <message>
        <source>Traced: one vessel, %1 mm.</source>
        <translation>已提取：一条血管，%1 mm。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PathTool</name>
    <message>
        <source>One vessel: click its end point · Esc starts over</source>
        <translation>一条血管：单击其终点 · Esc 重新开始</translation>
    </message>
    <message>
        <source>One vessel: click its start point, then its end point</source>
        <translation>一条血管：单击其起点，再单击终点</translation>
    </message>
</context>
<context>
    <name>angiopose::app::MaskController</name>
    <message>
        <source>Stopped: the vessels are unchanged</source>
        <translation>已停止：血管未改变</translation>
    </message>
    <message>
        <source>Tracing the mask… %1 %</source>
        <translation>正在提取掩膜… %1 %</translation>
    </message>
    <message>
        <source>Open a scan or a label image first.</source>
        <translation>请先打开扫描或标签图像。</translation>
    </message>
    <message>
        <source>A registration is running. Stop it before editing.</source>
        <translation>配准正在进行。请先停止再编辑。</translation>
    </message>
    <message>
        <source>Paint mask</source>
        <translation>绘制掩膜</translation>
    </message>
    <message>
        <source>Erase mask</source>
        <translation>擦除掩膜</translation>
    </message>
    <message>
        <source>There is no mask at this position.</source>
        <translation>该处没有掩膜。</translation>
    </message>
    <message>
        <source>Cut the mask</source>
        <translation>裁剪掩膜</translation>
    </message>
    <message>
        <source>Tracing the mask…</source>
        <translation>正在提取掩膜…</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>Trace the edited mask</source>
        <translation>提取编辑后的掩膜</translation>
    </message>
    <message>
        <source>Traced: 1 branch.</source>
        <translation>已提取：1 个分支。</translation>
    </message>
    <message>
        <source>Traced: %1 branches.</source>
        <translation>已提取：%1 个分支。</translation>
    </message>
    <message>
        <source>Saved without the latest mask changes: trace the mask, then save again.</source>
        <translation>已保存，但不含掩膜的最新更改：请提取掩膜后再次保存。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MaskBrushTool</name>
    <message>
        <source>Paint: drag, Ctrl erases</source>
        <translation>绘制：拖动，Ctrl 擦除</translation>
    </message>
    <message>
        <source>Erase: drag, Ctrl paints</source>
        <translation>擦除：拖动，Ctrl 绘制</translation>
    </message>
    <message>
        <source>Shift+wheel, + and − change the brush size</source>
        <translation>Shift+滚轮、+ 和 − 改变画笔大小</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MaskCutTool</name>
    <message>
        <source>Scissors: draw around the region to remove · Shift keeps only the inside</source>
        <translation>剪刀：圈出要去除的区域 · Shift 保留圈内部分</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MaskPanel</name>
    <message>
        <source>Paint</source>
        <translation>绘制</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>擦除</translation>
    </message>
    <message>
        <source>Scissors</source>
        <translation>剪刀</translation>
    </message>
    <message>
        <source>3-D brush</source>
        <translation>三维画笔</translation>
    </message>
    <message>
        <source>Paint only above the threshold</source>
        <translation>仅在高于阈值处绘制</translation>
    </message>
    <message>
        <source>Trace the mask</source>
        <translation>提取掩膜</translation>
    </message>
    <message>
        <source>Save mask…</source>
        <translation>保存掩膜…</translation>
    </message>
    <message>
        <source>Lumen mask</source>
        <translation>管腔掩膜</translation>
    </message>
    <message>
        <source>Recreates the vessels from the current mask.</source>
        <translation>由当前掩膜重新生成血管。</translation>
    </message>
    <message>
        <source>Writes the mask as a label image.</source>
        <translation>将掩膜写为标签图像。</translation>
    </message>
    <message>
        <source>this slice</source>
        <translation>本层</translation>
    </message>
    <message>
        <source>neighboring slices</source>
        <translation>相邻层面</translation>
    </message>
    <message>
        <source>all slices</source>
        <translation>所有层面</translation>
    </message>
    <message>
        <source>Mask over the slices</source>
        <translation>层面上的掩膜</translation>
    </message>
    <message>
        <source>Sets the opacity of the mask over the slices.</source>
        <translation>设置掩膜在层面上的不透明度。</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>画笔半径</translation>
    </message>
    <message>
        <source>Brush radius</source>
        <translation>画笔半径</translation>
    </message>
    <message>
        <source>Scissors depth</source>
        <translation>剪刀裁剪深度</translation>
    </message>
    <message>
        <source>Depth on both sides of the slice</source>
        <translation>层面两侧的深度</translation>
    </message>
    <message>
        <source>Tracing the mask…</source>
        <translation>正在提取掩膜…</translation>
    </message>
    <message>
        <source>1 mask change is not yet reflected in the vessels: trace the mask.</source>
        <translation>掩膜有 1 处更改尚未反映到血管：请提取掩膜。</translation>
    </message>
    <message>
        <source>%1 mask changes are not yet reflected in the vessels: trace the mask.</source>
        <translation>掩膜有 %1 处更改尚未反映到血管：请提取掩膜。</translation>
    </message>
    <message>
        <source>The vessels come from a manually edited mask.</source>
        <translation>血管来自手动编辑的掩膜。</translation>
    </message>
    <message>
        <source>Paint and cut, then trace the mask. Each stroke can be undone.</source>
        <translation>绘制和裁剪，然后提取掩膜。每一笔均可撤销。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SliceMeasureTool</name>
    <message>
        <source>Length: drag or click both ends · points can be moved</source>
        <translation>长度：拖动或单击两端 · 点可移动</translation>
    </message>
    <message>
        <source>Angle: click one end, the vertex, the other end · points can be moved</source>
        <translation>角度：依次单击一端、顶点、另一端 · 点可移动</translation>
    </message>
    <message>
        <source>Area: click along the outline; double-click or Enter closes it · points can be moved</source>
        <translation>面积：沿边界单击；双击或回车闭合 · 点可移动</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ScanController</name>
    <message>
        <source>labels</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>vessels</source>
        <translation>血管</translation>
    </message>
    <message>
        <source>vessels and bone</source>
        <translation>血管和骨骼</translation>
    </message>
    <message>
        <source>vessels and tissue</source>
        <translation>血管和组织</translation>
    </message>
    <message>
        <source>Scan: %1</source>
        <translation>扫描：%1</translation>
    </message>
    <message>
        <source>Scan: off</source>
        <translation>扫描：关</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ColumnRail</name>
    <message>
        <source>Expand panel: %1</source>
        <translation>展开面板：%1</translation>
    </message>
    <message>
        <source>Expand: %1</source>
        <translation>展开：%1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::FoldButton</name>
    <message>
        <source>Collapse panel: %1</source>
        <translation>折叠面板：%1</translation>
    </message>
    <message>
        <source>Collapse: %1</source>
        <translation>折叠：%1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ScanBar</name>
    <message>
        <source>Display of the scan behind the vessels</source>
        <translation>血管后方扫描的显示方式</translation>
    </message>
    <message>
        <source>Opacity of the scan</source>
        <translation>扫描不透明度</translation>
    </message>
</context>
<context>
    <name>angiopose::app::RecentController</name>
    <message>
        <source>Clear list</source>
        <translation>清空列表</translation>
    </message>
</context>
<context>
    <name>angiopose::app::StudyController</name>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>The folder could not be opened</source>
        <translation>无法打开文件夹</translation>
    </message>
    <message>
        <source>Searching %1…</source>
        <translation>正在搜索 %1…</translation>
    </message>
    <message>
        <source>Stopped after %1 of %2 files.</source>
        <translation>已在第 %1 个文件处停止（共 %2 个）。</translation>
    </message>
    <message>
        <source>%1 files read.</source>
        <translation>已读取 %1 个文件。</translation>
    </message>
    <message>
        <source>The folder contains too many files to list. Choose the folder of a single study.</source>
        <translation>文件夹内文件过多，无法全部列出：请选择单个检查的文件夹。</translation>
    </message>
    <message>
        <source>The DICOMDIR is unusable (%1); the files were read directly.</source>
        <translation>DICOMDIR 无法使用（%1）：已直接读取文件。</translation>
    </message>
    <message>
        <source>Files listed in the DICOMDIR but missing: %1.</source>
        <translation>DICOMDIR 中列出但缺失的文件：%1。</translation>
    </message>
    <message>
        <source>The DICOMDIR lists %1 series; 1 more file is not listed.</source>
        <translation>DICOMDIR 列出 %1 个序列；另有 1 个文件未列出。</translation>
    </message>
    <message>
        <source>The DICOMDIR lists %1 series; %2 more files are not listed.</source>
        <translation>DICOMDIR 列出 %1 个序列；另有 %2 个文件未列出。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::StudyRows</name>
    <message>
        <source>Patient %1 (identity hidden)</source>
        <translation>患者 %1（身份已隐藏）</translation>
    </message>
    <message>
        <source>No name</source>
        <translation>无姓名</translation>
    </message>
    <message>
        <source>ID %1</source>
        <translation>ID %1</translation>
    </message>
    <message>
        <source>born %1</source>
        <translation>出生 %1</translation>
    </message>
    <message>
        <source>accession %1</source>
        <translation>检查号 %1</translation>
    </message>
    <message>
        <source>Study without date or description</source>
        <translation>无日期和描述的检查</translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>序列 %1</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 帧/秒</translation>
    </message>
    <message>
        <source>Files listed in the DICOMDIR but missing: %1.</source>
        <translation>DICOMDIR 中列出但缺失的文件：%1。</translation>
    </message>
    <message>
        <source>Not all files have been read yet, so it is not yet known which part of the series this is.</source>
        <translation>尚未读取所有文件，因此还不知道这是序列的哪一部分。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::RecentList</name>
    <message>
        <source>No recent case matches this name or folder.</source>
        <translation>没有名称或文件夹相符的最近病例。</translation>
    </message>
    <message>
        <source>Thumbnails</source>
        <translation>缩略图</translation>
    </message>
    <message>
        <source>Clear list</source>
        <translation>清空列表</translation>
    </message>
    <message>
        <source>Search recent cases</source>
        <translation>搜索最近病例</translation>
    </message>
    <message>
        <source>Stores a thumbnail of each recent case in the program&apos;s cache folder.</source>
        <translation>在程序缓存文件夹中为每个最近病例保存缩略图。</translation>
    </message>
    <message>
        <source>Removes these cases and their thumbnails from the list. Pinned cases and all files are kept.</source>
        <translation>从列表中移除这些病例及其缩略图。固定的病例和所有文件均保留。</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1（缺失）</translation>
    </message>
    <message>
        <source>%1 (inputs missing)</source>
        <translation>%1（缺少输入）</translation>
    </message>
    <message>
        <source>Pinned: stays at the top of the list</source>
        <translation>已固定：保持在列表顶部</translation>
    </message>
    <message>
        <source>Pin to the top of the list</source>
        <translation>固定在列表顶部</translation>
    </message>
    <message>
        <source>Pin %1</source>
        <translation>固定 %1</translation>
    </message>
    <message>
        <source>Remove from the list; the file is kept</source>
        <translation>从列表中移除；文件保留</translation>
    </message>
    <message>
        <source>Remove %1 from the list</source>
        <translation>从列表中移除 %1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::StudyBrowser</name>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Also read them</source>
        <translation>一并读取</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Studies in %1</source>
        <translation>%1 中的检查</translation>
    </message>
    <message>
        <source>Search by name, ID or description</source>
        <translation>按姓名、ID 或描述搜索</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Damaged files</source>
        <translation>损坏的文件</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>%1 of %2 files</source>
        <translation>%1 / %2 个文件</translation>
    </message>
    <message>
        <source>%1 files found</source>
        <translation>已找到 %1 个文件</translation>
    </message>
    <message>
        <source>Damaged files: %1</source>
        <translation>损坏的文件：%1</translation>
    </message>
    <message>
        <source>Vessels: %1</source>
        <translation>血管：%1</translation>
    </message>
    <message>
        <source>Views: %1</source>
        <translation>视图：%1</translation>
    </message>
    <message>
        <source>Select the scan that shows the vessels and one or more angiographic runs, or double-click an entry to open it.</source>
        <translation>请选择显示血管的扫描和一个或多个造影序列，或双击其中一项将其打开。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::StudyList</name>
    <message>
        <source>Patients, studies and series</source>
        <translation>患者、检查和序列</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>序列</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>模态</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Spacing, rate</source>
        <translation>层距、帧率</translation>
    </message>
    <message>
        <source>Body part</source>
        <translation>部位</translation>
    </message>
</context>
<context>
    <name>angiopose::app::MovieController</name>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>已保存：%1</translation>
    </message>
    <message>
        <source>Could not export</source>
        <translation>无法导出</translation>
    </message>
    <message>
        <source>Writing the movie: %1 %</source>
        <translation>正在写影片：%1 %</translation>
    </message>
    <message>
        <source>Open vessels and an angiogram first.</source>
        <translation>请先打开血管和造影图像。</translation>
    </message>
    <message>
        <source>Another task is running. Wait for it to finish.</source>
        <translation>另一任务正在运行，请等待其完成。</translation>
    </message>
    <message>
        <source>Export movie</source>
        <translation>导出影片</translation>
    </message>
    <message>
        <source>GIF movies (*.gif)</source>
        <translation>GIF 影片 (*.gif)</translation>
    </message>
    <message>
        <source>MP4 movies (*.mp4)</source>
        <translation>MP4 影片 (*.mp4)</translation>
    </message>
    <message>
        <source>Writing the movie…</source>
        <translation>正在写影片…</translation>
    </message>
    <message>
        <source>Frames %1 to %2, back and forth</source>
        <translation>第 %1 至 %2 帧，往返</translation>
    </message>
    <message>
        <source>Frames %1 to %2</source>
        <translation>第 %1 至 %2 帧</translation>
    </message>
    <message>
        <source>pose of this frame for all frames</source>
        <translation>全部使用当前帧的位姿</translation>
    </message>
    <message>
        <source>tracked pose of each frame</source>
        <translation>每帧使用其跟踪位姿</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ReportController</name>
    <message>
        <source>Nothing to report yet. Open vessels and an angiogram first.</source>
        <translation>尚无可报告的内容。请先打开血管和造影图像。</translation>
    </message>
    <message>
        <source>Report template</source>
        <translation>报告模板</translation>
    </message>
    <message>
        <source>Templates (*.html *.htm)</source>
        <translation>模板 (*.html *.htm)</translation>
    </message>
    <message>
        <source>Save report template</source>
        <translation>保存报告模板</translation>
    </message>
    <message>
        <source>Templates (*.html)</source>
        <translation>模板 (*.html)</translation>
    </message>
    <message>
        <source>Export report</source>
        <translation>导出报告</translation>
    </message>
    <message>
        <source>Reports (*.pdf *.html)</source>
        <translation>报告 (*.pdf *.html)</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MovieDialog</name>
    <message>
        <source>frames per second</source>
        <translation>帧/秒</translation>
    </message>
    <message>
        <source>Residual colors with scale</source>
        <translation>残差颜色及色标</translation>
    </message>
    <message>
        <source>Burn in patient identity</source>
        <translation>帧中显示患者身份</translation>
    </message>
    <message>
        <source>English labels</source>
        <translation>使用英文标注</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Export movie</source>
        <translation>导出影片</translation>
    </message>
    <message>
        <source>MP4, for players and slides</source>
        <translation>MP4，用于播放器和幻灯片</translation>
    </message>
    <message>
        <source>GIF, for web pages; loops automatically</source>
        <translation>GIF，用于网页；自动循环播放</translation>
    </message>
    <message>
        <source>Each frame is labeled “Not for clinical use” and shows the origin of its pose and whether the pose is reliable.</source>
        <translation>每帧都标注“不得用于临床”、所示位姿的来源及其是否可靠。</translation>
    </message>
    <message>
        <source>Overlay through the run</source>
        <translation>整个序列的叠加图</translation>
    </message>
    <message>
        <source>Convergence of the registration</source>
        <translation>配准的收敛过程</translation>
    </message>
    <message>
        <source>Vessels only, one full rotation</source>
        <translation>仅血管，旋转一周</translation>
    </message>
    <message>
        <source>Movie</source>
        <translation>影片</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>%1 frames, %2 s, %3 × %4 px</source>
        <translation>%1 帧，%2 s，%3 × %4 px</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ReportDialog</name>
    <message>
        <source>Use built-in</source>
        <translation>用内置模板</translation>
    </message>
    <message>
        <source>Patient identity in the report</source>
        <translation>报告中显示患者身份</translation>
    </message>
    <message>
        <source>Export report</source>
        <translation>导出报告</translation>
    </message>
    <message>
        <source>Leave this off if the report will be shared: it is then anonymous.</source>
        <translation>若要分享报告，请保持关闭：报告即为匿名。</translation>
    </message>
    <message>
        <source>Templates are HTML pages with your letterhead and logo. Save a copy of the built-in template and edit the copy; it contains instructions.</source>
        <translation>模板是带有您的信头和标志的 HTML 页面。请保存内置模板的副本并进行编辑；说明在其中。</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>模板</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>患者</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Save a copy…</source>
        <translation>保存副本…</translation>
    </message>
    <message>
        <source>Saves the built-in template for editing</source>
        <translation>保存内置模板以供编辑</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>built-in</source>
        <translation>内置</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::DicomDialog</name>
    <message>
        <source>Overlay image (Secondary Capture)</source>
        <translation>叠加图像（二次捕获）</translation>
    </message>
    <message>
        <source>Images of the run (Secondary Capture)</source>
        <translation>序列图像（二次捕获）</translation>
    </message>
    <message>
        <source>Report (PDF)</source>
        <translation>报告（PDF）</translation>
    </message>
    <message>
        <source>Vessels as lines on the stored image (Presentation State)</source>
        <translation>存储图像上的血管线条（显示状态）</translation>
    </message>
    <message>
        <source>Pose (Spatial Registration)</source>
        <translation>位姿（空间配准）</translation>
    </message>
    <message>
        <source>Vessels in the scan (Segmentation)</source>
        <translation>扫描中的血管（分割）</translation>
    </message>
    <message>
        <source>Measurements (Structured Report)</source>
        <translation>测量（结构化报告）</translation>
    </message>
    <message>
        <source>Patient identity in images and report</source>
        <translation>图像和报告中的患者身份</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Export DICOM objects</source>
        <translation>导出 DICOM 对象</translation>
    </message>
    <message>
        <source>A Spatial Registration contains only a rigid matrix. The perspective camera is written to camera.json in the same folder.</source>
        <translation>空间配准（Spatial Registration）只能包含刚性矩阵。透视相机写入同一文件夹的 camera.json。</translation>
    </message>
    <message>
        <source>DICOM headers contain the patient&apos;s identity even if the images do not show it. Each object is a new instance in the study of its image.</source>
        <translation>即使图像不显示，DICOM 头信息中仍含患者身份。每个对象都是其图像所属检查中的新实例。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Choose PACS…</source>
        <translation>选择 PACS…</translation>
    </message>
    <message>
        <source>Send to PACS</source>
        <translation>发送到 PACS</translation>
    </message>
    <message>
        <source>A Spatial Registration contains only a rigid matrix. The perspective camera is stored in private elements. The file camera.json is not sent.</source>
        <translation>空间配准（Spatial Registration）只能包含刚性矩阵。透视相机存放在其私有元素中。文件 camera.json 不会发送。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::DicomController</name>
    <message>
        <source>There is nothing to export yet. Open a vessel tree and an angiogram first.</source>
        <translation>尚无可导出内容。请先打开血管树和造影图像。</translation>
    </message>
    <message>
        <source>Folder for the DICOM objects</source>
        <translation>DICOM 对象的文件夹</translation>
    </message>
    <message>
        <source>Nothing to send yet. Open a vessel tree and an angiogram first.</source>
        <translation>尚无可发送的内容。请先打开血管树和造影图像。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PackController</name>
    <message>
        <source>Nothing to share yet. Open a vessel tree and an angiogram first.</source>
        <translation>尚无可分享的内容。请先打开血管树和造影图像。</translation>
    </message>
    <message>
        <source>Share case as ZIP</source>
        <translation>将病例分享为 ZIP</translation>
    </message>
    <message>
        <source>ZIP archives (*.zip)</source>
        <translation>ZIP 压缩包 (*.zip)</translation>
    </message>
    <message>
        <source>A case is already being packed. Wait for it to finish, or stop it.</source>
        <translation>已在打包一个病例。请等待其完成，或将其停止。</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>Packing…</source>
        <translation>正在打包…</translation>
    </message>
    <message>
        <source>Packing: %1 %</source>
        <translation>正在打包：%1 %</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PackDialog</name>
    <message>
        <source>De-identify</source>
        <translation>去标识</translation>
    </message>
    <message>
        <source>Shift dates instead of removing them</source>
        <translation>平移日期而非删除</translation>
    </message>
    <message>
        <source>Mask burned-in text</source>
        <translation>遮盖图像中烧录的文字</translation>
    </message>
    <message>
        <source>Share case as ZIP</source>
        <translation>将病例分享为 ZIP</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动生成</translation>
    </message>
    <message>
        <source>Pseudonym</source>
        <translation>假名</translation>
    </message>
    <message>
        <source>Creates one archive with the case, its inputs and its results. De-identification removes names, IDs, dates, private elements and notes, and replaces UIDs. Branch names are kept. Review every image before sharing.</source>
        <translation>创建一个压缩包，包含病例、其输入和结果。去标识会删除姓名、编号、日期、私有元素和备注，并替换 UID。分支名称保留。分享前请检查每幅图像。</translation>
    </message>
    <message>
        <source>Pack…</source>
        <translation>打包…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveCache</name>
    <message>
        <source>empty</source>
        <translation>空</translation>
    </message>
    <message>
        <source>Cache emptied. Objects deleted: %1.</source>
        <translation>缓存已清空。已删除对象：%1。</translation>
    </message>
    <message>
        <source>Reduce the cache below its current size?</source>
        <translation>将缓存缩小到当前大小以下？</translation>
    </message>
    <message>
        <source>The cache contains %1. The least recently used objects will be deleted until %2 remain.</source>
        <translation>缓存现有 %1。将删除最久未用的对象，直到剩余 %2。</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Empty the cache?</source>
        <translation>清空缓存？</translation>
    </message>
    <message>
        <source>All retrieved objects will be deleted. When you open a case whose images were in the cache, AngioPose will ask for the location of the images. “Share case as ZIP” keeps case and images together.</source>
        <translation>所有已获取的对象都将删除。图像存放在缓存中的病例在打开时会询问图像位置。“将病例分享为 ZIP”可将病例与图像保存在一起。</translation>
    </message>
    <message>
        <source>Empty</source>
        <translation>清空</translation>
    </message>
    <message>
        <source>Emptying the cache…</source>
        <translation>正在清空缓存…</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveController</name>
    <message>
        <source>objects received on port %1</source>
        <translation>端口 %1 收到的对象</translation>
    </message>
    <message>
        <source>Objects received: %1</source>
        <translation>已收到对象：%1</translation>
    </message>
    <message>
        <source>Nothing received yet</source>
        <translation>尚未收到任何内容</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveEcho</name>
    <message>
        <source>Stopped.</source>
        <translation>已停止。</translation>
    </message>
    <message>
        <source>Contacting %1…</source>
        <translation>正在连接 %1…</translation>
    </message>
    <message>
        <source>%1 responded and accepted the connection.</source>
        <translation>%1 已应答并接受连接。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveFinder</name>
    <message>
        <source>Stopped.</source>
        <translation>已停止。</translation>
    </message>
    <message>
        <source>Search, select studies or series, then retrieve them.</source>
        <translation>先搜索，选择检查或序列，然后获取。</translation>
    </message>
    <message>
        <source>“%1” is not a date. Enter year, month and day: 2024-01-31.</source>
        <translation>“%1”不是日期。请输入年、月、日：2024-01-31。</translation>
    </message>
    <message>
        <source>Searching %1…</source>
        <translation>正在搜索 %1…</translation>
    </message>
    <message>
        <source>%1 has no matching study. Broaden the search: use a shorter name, a wider date range or any modality.</source>
        <translation>%1 中没有符合条件的检查。请放宽条件：更短的姓名、更长的日期范围、任意模态。</translation>
    </message>
    <message>
        <source>Search to list the studies in %1.</source>
        <translation>请搜索以列出 %1 中的检查。</translation>
    </message>
    <message>
        <source>1 study found.</source>
        <translation>找到 1 项检查。</translation>
    </message>
    <message>
        <source>%1 studies found.</source>
        <translation>找到 %1 项检查。</translation>
    </message>
    <message>
        <source>Select studies, or expand one to select its series; Ctrl selects several.</source>
        <translation>请选择检查，或展开检查以选择其序列；按 Ctrl 可多选。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveNodes</name>
    <message>
        <source>A PACS with this name already exists. Choose another name.</source>
        <translation>已有同名的 PACS。请换一个名称。</translation>
    </message>
    <message>
        <source>Remove %1 from the list?</source>
        <translation>从列表中移除 %1？</translation>
    </message>
    <message>
        <source>The PACS itself and the objects retrieved from it are not affected.</source>
        <translation>PACS 本身及已从中获取的对象均保留。</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveRetrieval</name>
    <message>
        <source>Contacting %1…</source>
        <translation>正在连接 %1…</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>正在停止…</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>已停止。</translation>
    </message>
    <message>
        <source>%1 of %2 objects, %3</source>
        <translation>%1 / %2 个对象，%3</translation>
    </message>
    <message>
        <source>Study %1 of %2: %3</source>
        <translation>检查 %1 / %2：%3</translation>
    </message>
    <message>
        <source>%1 of %2 objects were retrieved.</source>
        <translation>%2 个对象中已获取 %1 个。</translation>
    </message>
    <message>
        <source>Retrieve again to get the rest.</source>
        <translation>再次获取即可取回其余对象。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveSender</name>
    <message>
        <source>Stopping…</source>
        <translation>正在停止…</translation>
    </message>
    <message>
        <source>Creating the objects…</source>
        <translation>正在生成对象…</translation>
    </message>
    <message>
        <source>Sent: %1 of %2 objects, %3</source>
        <translation>已发送：%1 / %2 个对象，%3</translation>
    </message>
    <message>
        <source>%1 received all objects: %2 (%3).</source>
        <translation>%1 已收到全部对象：%2（%3）。</translation>
    </message>
    <message>
        <source>%1 of %2 objects were delivered.</source>
        <translation>%2 个对象中已到达 %1 个。</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>已停止。</translation>
    </message>
    <message>
        <source>Send again to transfer the rest.</source>
        <translation>再次发送即可传输其余对象。</translation>
    </message>
    <message>
        <source>Stopped. Nothing was sent.</source>
        <translation>已停止。未发送任何内容。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveWords</name>
    <message>
        <source>No name</source>
        <translation>无姓名</translation>
    </message>
    <message>
        <source>Patient %1 (identity hidden)</source>
        <translation>患者 %1（身份已隐藏）</translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>序列 %1</translation>
    </message>
    <message>
        <source>Number of further errors: %1.</source>
        <translation>其他错误数：%1。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ArchiveDialog</name>
    <message>
        <source>Open retrieved</source>
        <translation>打开已获取的对象</translation>
    </message>
    <message>
        <source>Retrieve</source>
        <translation>获取</translation>
    </message>
    <message>
        <source>Query PACS</source>
        <translation>查询 PACS</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Select from the received objects</source>
        <translation>从已收到的对象中选择</translation>
    </message>
    <message>
        <source>Retrieves the selected studies and series, from which you then choose the vessels and views</source>
        <translation>获取所选检查和序列；然后选择血管和视图</translation>
    </message>
    <message>
        <source>No PACS configured. Add one (ask your PACS administrator for host, port and AE title).</source>
        <translation>尚未配置 PACS。请添加一个（请向 PACS 管理员询问主机、端口和 AE 标题）。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::CacheLine</name>
    <message>
        <source>Empty…</source>
        <translation>清空…</translation>
    </message>
    <message>
        <source>Maximum cache size</source>
        <translation>缓存大小上限</translation>
    </message>
    <message>
        <source>The least recently used objects are deleted first</source>
        <translation>最久未用的对象先被删除</translation>
    </message>
    <message>
        <source>Deletes all retrieved objects</source>
        <translation>删除所有已获取的对象</translation>
    </message>
    <message>
        <source>of max.</source>
        <translation>上限</translation>
    </message>
    <message>
        <source>Cache: %1</source>
        <translation>缓存：%1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MatchList</name>
    <message>
        <source>Studies and series in the PACS</source>
        <translation>PACS 中的检查和序列</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>患者</translation>
    </message>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>日期</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>模态</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>描述</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>图像数</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>正在查找…</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::NodeBar</name>
    <message>
        <source>Test connection</source>
        <translation>测试连接</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>添加…</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>编辑…</translation>
    </message>
    <message>
        <source>Remove…</source>
        <translation>移除…</translation>
    </message>
    <message>
        <source>PACS</source>
        <translation>PACS</translation>
    </message>
    <message>
        <source>No PACS yet</source>
        <translation>尚无 PACS</translation>
    </message>
    <message>
        <source>Checks whether the PACS responds and accepts this program</source>
        <translation>检查 PACS 是否应答并接受本程序</translation>
    </message>
    <message>
        <source>Adds a PACS to the list; the command line uses the same list</source>
        <translation>将 PACS 添加到列表；命令行使用同一列表</translation>
    </message>
    <message>
        <source>Edits host, port, AE titles and security</source>
        <translation>编辑主机、端口、AE 标题和安全设置</translation>
    </message>
    <message>
        <source>Removes the PACS from the list</source>
        <translation>将 PACS 从列表中移除</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::NodeDialog</name>
    <message>
        <source>Authorization file</source>
        <translation>授权文件</translation>
    </message>
    <message>
        <source>Encrypted (TLS)</source>
        <translation>加密（TLS）</translation>
    </message>
    <message>
        <source>CA certificates (PEM)</source>
        <translation>CA 证书（PEM）</translation>
    </message>
    <message>
        <source>Local certificate (PEM)</source>
        <translation>本机证书（PEM）</translation>
    </message>
    <message>
        <source>Private key of the local certificate (PEM)</source>
        <translation>本机证书的私钥（PEM）</translation>
    </message>
    <message>
        <source>Verify host name in certificate</source>
        <translation>验证证书中的主机名</translation>
    </message>
    <message>
        <source>Security, DICOMweb and more</source>
        <translation>安全、DICOMweb 及更多</translation>
    </message>
    <message>
        <source>Test connection</source>
        <translation>测试连接</translation>
    </message>
    <message>
        <source>Add PACS</source>
        <translation>添加 PACS</translation>
    </message>
    <message>
        <source>Edit PACS</source>
        <translation>编辑 PACS</translation>
    </message>
    <message>
        <source>Ask your PACS administrator for these values, and have the calling AE title registered in the PACS.</source>
        <translation>请向 PACS 管理员询问这些信息，并让其登记本程序的呼叫方 AE 标题。</translation>
    </message>
    <message>
        <source>Radiology PACS</source>
        <translation>放射科 PACS</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Name shown in this program</source>
        <translation>在本程序中显示的名称</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>主机</translation>
    </message>
    <message>
        <source>Host name or IP address; leave empty if only DICOMweb is used</source>
        <translation>主机名或 IP 地址；仅用 DICOMweb 时留空</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>端口</translation>
    </message>
    <message>
        <source>Usually 104 or 11112</source>
        <translation>通常为 104 或 11112</translation>
    </message>
    <message>
        <source>Called AE title</source>
        <translation>被叫方 AE 标题</translation>
    </message>
    <message>
        <source>AE title of the PACS</source>
        <translation>PACS 的 AE 标题</translation>
    </message>
    <message>
        <source>Calling AE title</source>
        <translation>呼叫方 AE 标题</translation>
    </message>
    <message>
        <source>AE title under which the PACS knows this program</source>
        <translation>PACS 识别本程序所用的 AE 标题</translation>
    </message>
    <message>
        <source>CA certificates</source>
        <translation>CA 证书</translation>
    </message>
    <message>
        <source>PEM file; if empty, the CAs trusted by the system are used</source>
        <translation>PEM 文件；留空：系统信任的 CA</translation>
    </message>
    <message>
        <source>Local certificate</source>
        <translation>本机证书</translation>
    </message>
    <message>
        <source>PEM file (optional)</source>
        <translation>PEM 文件（可选）</translation>
    </message>
    <message>
        <source>Private key</source>
        <translation>私钥</translation>
    </message>
    <message>
        <source>PEM file; only its path is stored</source>
        <translation>PEM 文件；仅保存其路径</translation>
    </message>
    <message>
        <source>DICOMweb address</source>
        <translation>DICOMweb 地址</translation>
    </message>
    <message>
        <source>Used if no host is specified</source>
        <translation>未填写主机时使用</translation>
    </message>
    <message>
        <source>Authorization</source>
        <translation>授权</translation>
    </message>
    <message>
        <source>File whose first line is sent as the Authorization header; only its path is stored</source>
        <translation>其首行作为 Authorization 头发送的文件；仅保存其路径</translation>
    </message>
    <message>
        <source>Port for C-MOVE</source>
        <translation>C-MOVE 端口</translation>
    </message>
    <message>
        <source>Local port to which the PACS sends images if it does not support C-GET. 0: not used</source>
        <translation>PACS 不支持 C-GET 时向其发送的本机端口。0：不使用</translation>
    </message>
    <message>
        <source>Response timeout</source>
        <translation>响应超时</translation>
    </message>
    <message>
        <source>After this time, the PACS is considered unreachable</source>
        <translation>超过此时间即视为 PACS 无法连接</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PathField</name>
    <message>
        <source>Choose a file</source>
        <translation>选择文件</translation>
    </message>
    <message>
        <source>Choose a file: %1</source>
        <translation>选择文件：%1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ReceiveLine</name>
    <message>
        <source>Receive on port</source>
        <translation>在端口接收</translation>
    </message>
    <message>
        <source>Show objects</source>
        <translation>查看对象</translation>
    </message>
    <message>
        <source>Accepts objects sent to this computer by modalities and PACS until receiving is turned off or the window is closed</source>
        <translation>接收设备和 PACS 发送到本机的对象，直到关闭接收或关闭窗口</translation>
    </message>
    <message>
        <source>Receiving port</source>
        <translation>接收端口</translation>
    </message>
    <message>
        <source>Receiving AE title</source>
        <translation>接收用 AE 标题</translation>
    </message>
    <message>
        <source>Calling applications must use this called AE title</source>
        <translation>呼叫方必须使用此被叫方 AE 标题</translation>
    </message>
    <message>
        <source>Select from the received objects</source>
        <translation>从已收到的对象中选择</translation>
    </message>
    <message>
        <source>as AE title</source>
        <translation>AE 标题</translation>
    </message>
    <message>
        <source>Security…</source>
        <translation>安全…</translation>
    </message>
    <message>
        <source>Sets which applications may connect to this port, and encryption (TLS)</source>
        <translation>设置谁可连接此端口，以及加密（TLS）</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SearchFields</name>
    <message>
        <source>Meier, or *mei*</source>
        <translation>Meier 或 *mei*</translation>
    </message>
    <message>
        <source>Beginning of the name; * and ? are wildcards</source>
        <translation>姓名开头；* 和 ? 为通配符</translation>
    </message>
    <message>
        <source>Patient ID; * and ? are wildcards</source>
        <translation>患者 ID；* 和 ? 为通配符</translation>
    </message>
    <message>
        <source>2024-01-31</source>
        <translation>2024-01-31</translation>
    </message>
    <message>
        <source>Studies on or after this date; leave empty for no limit</source>
        <translation>该日期及以后的检查；留空：不限</translation>
    </message>
    <message>
        <source>Studies on or before this date; leave empty for today</source>
        <translation>该日期及以前的检查；留空：直到今天</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>XA: angiograms, CT: scans</source>
        <translation>XA：造影图像，CT：扫描</translation>
    </message>
    <message>
        <source>Lists the studies that match all criteria</source>
        <translation>列出符合全部条件的检查</translation>
    </message>
    <message>
        <source>Patient&apos;s name</source>
        <translation>患者姓名</translation>
    </message>
    <message>
        <source>Patient ID</source>
        <translation>患者 ID</translation>
    </message>
    <message>
        <source>Study date from</source>
        <translation>检查日期从</translation>
    </message>
    <message>
        <source>to</source>
        <translation>到</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>模态</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SendDialog</name>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>发送</translation>
    </message>
    <message>
        <source>Send to PACS</source>
        <translation>发送到 PACS</translation>
    </message>
    <message>
        <source>The objects are created once. Sending again after an error transfers the same objects, so none is stored twice.</source>
        <translation>对象只生成一次。出错后再次发送的是相同的对象，因此不会重复存储。</translation>
    </message>
    <message>
        <source>No PACS configured. Add one (ask your PACS administrator for host, port and AE title).</source>
        <translation>尚未配置 PACS。请添加一个（请向 PACS 管理员询问主机、端口和 AE 标题）。</translation>
    </message>
    <message>
        <source>The objects are sent to %1 when you click “Send”.</source>
        <translation>单击“发送”后，对象将发送到 %1。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::TransferLine</name>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Stops the transfer; objects already transferred in full are kept</source>
        <translation>停止传输；已完整传输的对象予以保留</translation>
    </message>
</context>
<context>
    <name>angiopose::app::DeidentifyController</name>
    <message>
        <source>De-identifying: %1 %</source>
        <translation>正在去标识：%1 %</translation>
    </message>
    <message>
        <source>A de-identification is already running. Wait for it to finish, or stop it.</source>
        <translation>去标识正在进行。请等待其完成，或将其停止。</translation>
    </message>
    <message>
        <source>Files to de-identify</source>
        <translation>要去标识的文件</translation>
    </message>
    <message>
        <source>Folder to de-identify</source>
        <translation>要去标识的文件夹</translation>
    </message>
    <message>
        <source>Output folder</source>
        <translation>输出文件夹</translation>
    </message>
    <message>
        <source>De-identifying…</source>
        <translation>正在去标识…</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>De-identified files: %1, in %2.</source>
        <translation>已去标识的文件：%1 个，位于 %2。</translation>
    </message>
    <message>
        <source>%1 files were de-identified; %2 were not, for the reasons listed below. The output folder is %3.</source>
        <translation>%1 个文件已去标识，%2 个未去标识，原因如下。输出文件夹为 %3。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PrivacyController</name>
    <message>
        <source>Stores no list or thumbnails of recent cases and no folders, and shows no names in the title bar.</source>
        <translation>不保留最近病例的列表和缩略图，标题栏中不显示姓名，不记住文件夹。</translation>
    </message>
    <message>
        <source>Turn on private mode?</source>
        <translation>开启隐私模式？</translation>
    </message>
    <message>
        <source>The list of recent cases (including pinned ones), their thumbnails, and all stored folders and names will be permanently deleted. No such data will be stored until private mode is turned off. Unsaved work is still autosaved; the copies are deleted when the case is closed.</source>
        <translation>最近病例列表（包括固定的病例）、其缩略图以及所有存储的文件夹和姓名将被永久删除。在关闭隐私模式之前，不会存储任何此类内容。未保存的工作仍会自动保存；副本在关闭病例时删除。</translation>
    </message>
    <message>
        <source>Turn on</source>
        <translation>开启</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>angiopose::app::AuditController</name>
    <message>
        <source>Writes one line for each file opened, saved or exported: time, user, and SHA-256 of the file.</source>
        <translation>为每次打开、保存或导出记录一行：时间、用户以及文件的 SHA-256。</translation>
    </message>
    <message>
        <source>Written to %1</source>
        <translation>写入 %1</translation>
    </message>
    <message>
        <source>Write audit log</source>
        <translation>写审计日志</translation>
    </message>
    <message>
        <source>Audit logs (*.jsonl)</source>
        <translation>审计日志 (*.jsonl)</translation>
    </message>
</context>
<context>
    <name>angiopose::app::SupportController</name>
    <message>
        <source>Save support bundle</source>
        <translation>保存支持包</translation>
    </message>
    <message>
        <source>ZIP archives (*.zip)</source>
        <translation>ZIP 压缩包 (*.zip)</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::FaultBar</name>
    <message>
        <source>Save support bundle…</source>
        <translation>保存支持包…</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>忽略</translation>
    </message>
    <message>
        <source>AngioPose crashed during its last session. A report of where in the program it crashed, without case data, was saved to %1.</source>
        <translation>AngioPose 在上次会话中崩溃。记录程序崩溃位置的报告（不含病例数据）已保存到 %1。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SupportDialog</name>
    <message>
        <source>Save support bundle</source>
        <translation>保存支持包</translation>
    </message>
    <message>
        <source>The archive contains only the text shown here, no images or vessel data. Names, numbers, dates and paths known from the cases of this session and from this computer have been removed. Review the text before sharing it.</source>
        <translation>压缩包只包含此处显示的文本，不含图像或血管数据。由本次会话的病例和本计算机得知的姓名、编号、日期和路径均已去除。分享前请检查这些文本。</translation>
    </message>
    <message>
        <source>Files in the bundle</source>
        <translation>支持包中的文件</translation>
    </message>
    <message>
        <source>Text to be written</source>
        <translation>将写入的文本</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>保存…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::DeidentifyDialog</name>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Shift dates instead of removing them</source>
        <translation>平移日期而非删除</translation>
    </message>
    <message>
        <source>Mask burned-in text</source>
        <translation>遮盖图像中烧录的文字</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>De-identify files</source>
        <translation>文件去标识</translation>
    </message>
    <message>
        <source>DICOM images and objects and PNG, JPEG and TIFF files are copied without names, IDs, dates, private elements and free text; UIDs are replaced. Other files are skipped and listed. Review every image before sharing.</source>
        <translation>DICOM 图像和对象以及 PNG、JPEG 和 TIFF 文件将被复制，不含姓名、编号、日期、私有元素和自由文本；UID 会被替换。其他文件将被跳过并列出。分享前请检查每幅图像。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Files and folders</source>
        <translation>文件和文件夹</translation>
    </message>
    <message>
        <source>Add files…</source>
        <translation>添加文件…</translation>
    </message>
    <message>
        <source>Add folder…</source>
        <translation>添加文件夹…</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动生成</translation>
    </message>
    <message>
        <source>a new or empty folder</source>
        <translation>新的或空的文件夹</translation>
    </message>
    <message>
        <source>Output folder</source>
        <translation>输出文件夹</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Pseudonym</source>
        <translation>假名</translation>
    </message>
    <message>
        <source>Write to</source>
        <translation>写入到</translation>
    </message>
</context>
</TS>
