<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>angiopose::app::AuxiliaryController</name>
    <message>
        <source>Nothing is chosen: AngioPose takes all branches alike. Chosen ones decide what they can tell, the others hold the rest.</source>
        <translation>未选择分支：AngioPose 同等使用全部分支。选中的分支决定其所能确定的，其余分支保持其他部分。</translation>
    </message>
    <message>
        <source>%1 AngioPose lets them decide what they can tell, the other branches hold the rest; the result says what the fit of all was. While the fit is in doubt, poses found from these alone are tried, too.</source>
        <translation>%1 AngioPose 由它们决定其所能确定的，其余由其他分支保持；结果会说明全部分支的拟合如何。拟合存疑时也会尝试仅由它们求得的位姿。</translation>
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
        <source>sideways</source>
        <translation>左右</translation>
    </message>
    <message>
        <source>up–down</source>
        <translation>上下</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>No branch lies mostly inside the lasso.</source>
        <translation>没有分支大部分位于套索内。</translation>
    </message>
    <message>
        <source>This tree knows no generations.</source>
        <translation>此血管树没有分级信息。</translation>
    </message>
    <message>
        <source>No branch is that wide.</source>
        <translation>没有这么粗的分支。</translation>
    </message>
    <message>
        <source>Nothing is chosen: the alternation takes the %1 nodes of the tree.</source>
        <translation>未选择：交替使用血管树的 %1 个节点。</translation>
    </message>
    <message>
        <source>Chosen: %1 (%2 mm, %3 % of the tree).</source>
        <translation>已选：%1（%2 mm，占血管树 %3 %）。</translation>
    </message>
    <message>
        <source>%1 The method chosen now does not alternate and takes all branches.</source>
        <translation>%1 当前方法不交替，使用全部分支。</translation>
    </message>
    <message>
        <source>%1 The option “Auxiliary points” of the method overrules this.</source>
        <translation>%1 方法的“辅助点”选项优先。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::BlindTrialController</name>
    <message>
        <source>A trial needs vessels, an angiogram and a start pose, and no registration running.</source>
        <translation>试验需要血管、造影图像和初始位姿，且没有正在进行的配准。</translation>
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
        <source>Keep a blind trial</source>
        <translation>保留盲法试验</translation>
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
        <source>At least one branch has to stay.</source>
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
        <source>No branch lies wholly in view. Zoom out or move the image.</source>
        <translation>没有分支完全位于视野内。请缩小或移动图像。</translation>
    </message>
    <message>
        <source>This tree knows no radii.</source>
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
        <source>A registration is running. Stop it to edit.</source>
        <translation>配准正在进行。请先停止再编辑。</translation>
    </message>
    <message>
        <source>Vessels cannot be traced</source>
        <translation>无法提取血管</translation>
    </message>
    <message>
        <source>Support bundle written: %1</source>
        <translation>已写入支持包：%1</translation>
    </message>
    <message>
        <source>Could not save the support bundle</source>
        <translation>无法保存支持包</translation>
    </message>
</context>
<context>
    <name>angiopose::app::CaseReport</name>
    <message>
        <source>Found</source>
        <translation>得出</translation>
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
        <source>Traced vessels covered</source>
        <translation>提取血管的覆盖率</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>none: this is the start pose</source>
        <translation>无：这是初始位姿</translation>
    </message>
    <message>
        <source>Found in</source>
        <translation>求得于</translation>
    </message>
    <message>
        <source>frame %1; picture and figures are of frame %2</source>
        <translation>第 %1 帧；图像与数值来自第 %2 帧</translation>
    </message>
    <message>
        <source>pose set by hand</source>
        <translation>手动设定的位姿</translation>
    </message>
    <message>
        <source>edited by hand</source>
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
        <source>The %1 worst of %2 branches</source>
        <translation>%2 个分支中最差的 %1 个</translation>
    </message>
    <message>
        <source>Branches, the worst first</source>
        <translation>分支，最差的在前</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>几何</translation>
    </message>
    <message>
        <source>Pose: camera from patient, mm</source>
        <translation>位姿：患者到相机，mm</translation>
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
        <source>Made</source>
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
        <source>, narrowest %1 mm (−%2 %)</source>
        <translation>，最窄 %1 mm（−%2 %）</translation>
    </message>
    <message>
        <source>Check points and rings</source>
        <translation>检查点与环</translation>
    </message>
    <message>
        <source>traced from a lumen mask edited by hand</source>
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
        <source>Before: start pose</source>
        <translation>之前：初始位姿</translation>
    </message>
    <message>
        <source>After: registered</source>
        <translation>之后：已配准</translation>
    </message>
    <message>
        <source>After: pose set by hand</source>
        <translation>之后：手动设置的位姿</translation>
    </message>
    <message>
        <source>Colours: distance of the vessels from those traced in the image</source>
        <translation>颜色：血管与图像中所提取血管的距离</translation>
    </message>
    <message>
        <source>farther</source>
        <translation>更远</translation>
    </message>
    <message>
        <source>Trustworthy</source>
        <translation>可信</translation>
    </message>
    <message>
        <source>Not trustworthy</source>
        <translation>不可信</translation>
    </message>
    <message>
        <source>This pose may be wrong. Do not use it as it is.</source>
        <translation>此位姿可能有误，请勿直接使用。</translation>
    </message>
    <message>
        <source>No check speaks against this pose. That is no proof: look at the picture.</source>
        <translation>没有检查结果与此位姿相悖。这并非证明：请查看图像。</translation>
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
        <source>Stop it and close? Changes of this case are lost unless they are saved.</source>
        <translation>停止并关闭？未保存的更改将丢失。</translation>
    </message>
    <message>
        <source>Save before closing?</source>
        <translation>关闭前保存吗？</translation>
    </message>
    <message>
        <source>“%1” has changes that are not saved.</source>
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
        <source>Stay</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>“%1” has no angiogram yet. Its vessels can be saved alone, as centrelines.</source>
        <translation>“%1”尚无造影图像。可单独将其血管存为中心线。</translation>
    </message>
    <message>
        <source>Save the vessels and close</source>
        <translation>保存血管并关闭</translation>
    </message>
    <message>
        <source>Close without saving?</source>
        <translation>不保存就关闭？</translation>
    </message>
    <message>
        <source>“%1” has no vessels yet, so there is no case to save. What was done here is lost.</source>
        <translation>“%1”尚无血管，因此没有可保存的病例。此处所做的工作将丢失。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::CurveController</name>
    <message>
        <source>At least one curve must stay: there would be nothing to register to.</source>
        <translation>至少保留一条曲线：否则无从配准。</translation>
    </message>
    <message>
        <source>Keep a suspect curve</source>
        <translation>保留可疑曲线</translation>
    </message>
    <message>
        <source>The edited curves of frame %1 gave way to these. Undo brings them back.</source>
        <translation>第 %1 帧编辑过的曲线已被替换。撤销可恢复。</translation>
    </message>
    <message>
        <source>Trace this frame again?</source>
        <translation>重新提取此帧？</translation>
    </message>
    <message>
        <source>Its edited or given curves are set aside. Undo brings them back.</source>
        <translation>编辑过或给定的曲线将被搁置。撤销可恢复。</translation>
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
        <source>Where nothing but a wire is seen, the method “Wire or catheter” takes every curve.</source>
        <translation>若只能看到导丝，方法“导丝或导管”会使用所有曲线。</translation>
    </message>
    <message>
        <source>Keep a catheter or wire apart</source>
        <translation>将导管或导丝分开</translation>
    </message>
    <message>
        <source>Take a curve for a vessel again</source>
        <translation>将曲线恢复为血管</translation>
    </message>
    <message>
        <source>Follow the catheter or wire</source>
        <translation>追踪导管或导丝</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ExportController</name>
    <message>
        <source>Points for 3D Slicer (*.fcsv *.mrk.json)</source>
        <translation>3D Slicer 标志点 (*.fcsv *.mrk.json)</translation>
    </message>
    <message>
        <source>Poses with their camera (*.txt *.yml *.xml)</source>
        <translation>带相机的位姿 (*.txt *.yml *.xml)</translation>
    </message>
    <message>
        <source>Drawings (*.svg)</source>
        <translation>矢量图 (*.svg)</translation>
    </message>
    <message>
        <source>PDF pages (*.pdf)</source>
        <translation>PDF 页面 (*.pdf)</translation>
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
        <source>PNG pictures (*.png)</source>
        <translation>PNG 图片 (*.png)</translation>
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
        <source>How each point moved (*.csv)</source>
        <translation>各点位移 (*.csv)</translation>
    </message>
    <message>
        <source>Bent centrelines (*.vtp)</source>
        <translation>弯曲中心线 (*.vtp)</translation>
    </message>
    <message>
        <source>Export bent vessels</source>
        <translation>导出弯曲血管</translation>
    </message>
    <message>
        <source>No bent vessels are known of this pose. Register first (R).</source>
        <translation>此位姿没有已知的弯曲血管。请先配准 (R)。</translation>
    </message>
    <message>
        <source>Export traced vessels</source>
        <translation>导出提取的血管</translation>
    </message>
    <message>
        <source>2-D centrelines (*.csv)</source>
        <translation>二维中心线 (*.csv)</translation>
    </message>
    <message>
        <source>There are no vessels yet. Open a centreline, or trace a scan.</source>
        <translation>尚无血管。请打开中心线，或从扫描中提取。</translation>
    </message>
    <message>
        <source>Export vessel tree</source>
        <translation>导出血管树</translation>
    </message>
    <message>
        <source>Centrelines (*.vtp *.csv *.swc *.mrk.json)</source>
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
        <source>No check points or rings have been set yet.</source>
        <translation>尚未设置检查点或环。</translation>
    </message>
    <message>
        <source>Export check points</source>
        <translation>导出检查点</translation>
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
    <name>angiopose::app::FollowController</name>
    <message>
        <source>Following the vessels through the run: %1 %</source>
        <translation>正在序列中跟踪血管：%1 %</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>The vessels cannot be followed</source>
        <translation>无法跟踪血管</translation>
    </message>
    <message>
        <source>Something else is under way. Let it end first.</source>
        <translation>其他任务正在进行，请等待其结束。</translation>
    </message>
    <message>
        <source>Open vessels and an angiogram first.</source>
        <translation>请先打开血管和血管造影。</translation>
    </message>
    <message>
        <source>Following the vessels through the run …</source>
        <translation>正在序列中跟踪血管……</translation>
    </message>
    <message>
        <source>Follow the vessels through the run</source>
        <translation>在序列中跟踪血管</translation>
    </message>
    <message>
        <source>The vessels were moved meanwhile: follow them again.</source>
        <translation>血管已被移动：请重新跟踪。</translation>
    </message>
    <message>
        <source>breath every %1 s, %2 mm to and fro</source>
        <translation>呼吸周期 %1 秒，往复 %2 毫米</translation>
    </message>
    <message>
        <source>heartbeat every %1 s, %2 mm to and fro</source>
        <translation>心跳周期 %1 秒，往复 %2 毫米</translation>
    </message>
    <message>
        <source>Followed through %1 frames: scroll or play them</source>
        <translation>已跟踪 %1 帧：可滚动或播放</translation>
    </message>
    <message>
        <source>Followed through %1 frames; %2 of them do not show the vessels well enough</source>
        <translation>已跟踪 %1 帧；其中 %2 帧未能充分显示血管</translation>
    </message>
    <message>
        <source>Export followed poses</source>
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
        <source>Finds where a 3-D vessel tree lies in a 2-D angiogram, without correspondences.

Not for clinical use: AngioPose is a research program, not a medical device.

Apache License 2.0. Built on Qt, VTK, ITK, OpenCV, NLopt, Eigen and nanoflann.</source>
        <translation>无需对应点即可求出三维血管树在二维造影图像中的位姿。

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
        <source>Drop a case, or vessels and an angiogram, anywhere. “Open the sample case” works without own data.</source>
        <translation>将病例，或血管与造影图像，拖到任意处。“打开示例病例”无需自己的数据。</translation>
    </message>
    <message>
        <source>The way to a result</source>
        <translation>得到结果的步骤</translation>
    </message>
    <message>
        <source>Each step has a tick, or says in its tool tip what is missing. Click any of them, in any order.</source>
        <translation>每一步带有对勾，或在提示中说明缺少什么。可按任意顺序单击。</translation>
    </message>
    <message>
        <source>The vessel tree</source>
        <translation>血管树</translation>
    </message>
    <message>
        <source>Its branches with length and distance to the image. A takes a branch into the auxiliary set, X leaves it out.</source>
        <translation>其分支及长度、到图像的距离。A 将分支放入辅助集，X 排除。</translation>
    </message>
    <message>
        <source>The angiogram</source>
        <translation>造影图像</translation>
    </message>
    <message>
        <source>The projected tree lies over it, coloured by distance. Wheel: frames. N: move the tree with arrows or mouse. H: hide it.</source>
        <translation>投影血管树叠加其上，按距离着色。滚轮：帧。N：用方向键或鼠标移动。H：隐藏。</translation>
    </message>
    <message>
        <source>Register</source>
        <translation>配准</translation>
    </message>
    <message>
        <source>R finds the pose. Stop keeps the best one so far, Ctrl+Z brings the old one back.</source>
        <translation>R 求位姿。停止保留目前最佳，Ctrl+Z 恢复原位姿。</translation>
    </message>
    <message>
        <source>Can it be trusted?</source>
        <translation>可信吗？</translation>
    </message>
    <message>
        <source>Numbers in mm, and sentences on what the image cannot tell. Shift+F1 shows good and bad fits.</source>
        <translation>毫米数值，以及图像无法确定之处的说明。Shift+F1 显示好与坏的配准。</translation>
    </message>
    <message>
        <source>Help is never far</source>
        <translation>随时有帮助</translation>
    </message>
    <message>
        <source>F1 explains what the mouse points at, ? lists and changes all keys. This tour is under Help.</source>
        <translation>F1 解释鼠标所指内容，? 列出并修改快捷键。本导览在“帮助”菜单中。</translation>
    </message>
    <message>
        <source>The angiogram is drawn by VTK (OpenGL).</source>
        <translation>血管造影由 VTK（OpenGL）绘制。</translation>
    </message>
    <message>
        <source>The angiogram is drawn by the processor.</source>
        <translation>血管造影由处理器绘制。</translation>
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
        <source>Not the same patient in all inputs</source>
        <translation>输入并非来自同一患者</translation>
    </message>
    <message>
        <source>The inputs do not belong together</source>
        <translation>输入不属于同一检查</translation>
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
        <translation>投影 %1</translation>
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
        <source>Centrelines (*.vtp *.vtk *.csv *.swc *.json)</source>
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
    <name>angiopose::app::JudgementController</name>
    <message>
        <source>nothing to judge yet</source>
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
        <source>place beside the vessels</source>
        <translation>血管旁的位置</translation>
    </message>
    <message>
        <source>Fewer than four pairs: what they leave open stays as it is.</source>
        <translation>少于四对：其未能确定的量保持不变。</translation>
    </message>
    <message>
        <source>The pairs leave %1 px; for clicks off by 2 px: rotation ±%2°, depth ±%3 mm.</source>
        <translation>点对残余 %1 px；若点击偏 2 px：旋转 ±%2°，深度 ±%3 mm。</translation>
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
        <source>Place vessels by landmarks</source>
        <translation>按标志点放置血管</translation>
    </message>
</context>
<context>
    <name>angiopose::app::LinkedCrosshair</name>
    <message>
        <source>The cross-hair links views that stand side by side (%1).</source>
        <translation>十字线用于联动并排显示的视图（%1）。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::LookController</name>
    <message>
        <source>Near vessels bright, far ones dim</source>
        <translation>近处血管亮、远处血管暗</translation>
    </message>
    <message>
        <source>Depth cue off</source>
        <translation>深度提示已关闭</translation>
    </message>
    <message>
        <source>Vessels as centrelines</source>
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
        <source>Swipe: the overlay ends at the mouse</source>
        <translation>卷帘：叠加图止于鼠标处</translation>
    </message>
    <message>
        <source>Lens: the bare angiogram under the mouse</source>
        <translation>透镜：鼠标处只显示造影图像</translation>
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
        <source>Worst %1 of %2: %3 mm median · W next · 1 fits</source>
        <translation>最差第 %1 / %2：中位数 %3 mm · W 下一个 · 1 适合窗口</translation>
    </message>
    <message>
        <source>Seen from the source: only the view is mirrored</source>
        <translation>从源方向看：仅视图镜像</translation>
    </message>
    <message>
        <source>Seen from the detector</source>
        <translation>从探测器方向看</translation>
    </message>
    <message>
        <source>Vessels as a radiograph of the scan (DRR)</source>
        <translation>血管显示为扫描的 X 射线像（DRR）</translation>
    </message>
    <message>
        <source>Vessels as a radiograph of tubes (DRR)</source>
        <translation>血管显示为管状模型的 X 射线像（DRR）</translation>
    </message>
</context>
<context>
    <name>angiopose::app::Notices</name>
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
        <translation>充盈随时间变化</translation>
    </message>
</context>
<context>
    <name>angiopose::app::OpenController</name>
    <message>
        <source>The pose is of an image of %1 × %2 px, the angiogram has %3 × %4. Open the pose of this image.</source>
        <translation>位姿属于 %1 × %2 px 的图像，而血管造影为 %3 × %4。请打开此图像的位姿。</translation>
    </message>
    <message>
        <source>The camera of the pose is mirrored against the angiogram: one is seen from the detector, the other from the source. Mirror the image, or say so in the geometry.</source>
        <translation>位姿的相机与血管造影互为镜像：一个从探测器看，另一个从射线源看。请镜像图像，或在几何中说明。</translation>
    </message>
    <message>
        <source>The pose was found with other vessels than these.</source>
        <translation>该位姿是用其他血管求得的，不是这些。</translation>
    </message>
    <message>
        <source>The pose was found in another angiogram than this.</source>
        <translation>该位姿是在另一幅血管造影中求得的。</translation>
    </message>
    <message>
        <source>A pose belongs to a case. Open vessels and an angiogram first, then the pose.</source>
        <translation>位姿属于病例。请先打开血管和血管造影，再打开位姿。</translation>
    </message>
    <message>
        <source>At this pose the vessels lie behind the X-ray source. It may be of another patient, or lead from camera to patient: then invert it.</source>
        <translation>按此位姿，血管位于射线源之后。它可能属于其他患者，或是从相机到患者的变换：请将其求逆。</translation>
    </message>
    <message>
        <source>The camera of the pose counts now. The geometry panel takes it back.</source>
        <translation>现在以位姿的相机为准。可在几何面板中撤回。</translation>
    </message>
    <message>
        <source>Open pose %1</source>
        <translation>打开位姿 %1</translation>
    </message>
    <message>
        <source>Points belong to vessels. Open those first, then the points.</source>
        <translation>点属于血管。请先打开血管，再打开点。</translation>
    </message>
    <message>
        <source>Check points added: %1.</source>
        <translation>已添加检查点：%1 个。</translation>
    </message>
    <message>
        <source>None of them lies near the vessels. They may be of another patient, or in other coordinates.</source>
        <translation>没有一个靠近血管。它们可能属于其他患者，或用了其他坐标。</translation>
    </message>
    <message>
        <source>Open points %1</source>
        <translation>打开点 %1</translation>
    </message>
    <message>
        <source>Pose of %1 taken.</source>
        <translation>已采用 %1 的位姿。</translation>
    </message>
    <message>
        <source>A registration is running. Stop it before opening another file.</source>
        <translation>配准正在进行。打开其他文件前请先停止。</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>正在读取 %1……</translation>
    </message>
    <message>
        <source>A registration was started meanwhile. Open the file again when it has ended.</source>
        <translation>期间已开始配准。请在结束后重新打开文件。</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>打开 %1</translation>
    </message>
    <message>
        <source>A blind trial is under way. End it before opening another file.</source>
        <translation>盲法试验进行中。打开其他文件前请结束。</translation>
    </message>
    <message>
        <source>A blind trial was started meanwhile. Open the file again when it has ended.</source>
        <translation>期间已开始盲法试验。请在结束后重新打开文件。</translation>
    </message>
    <message>
        <source>Add view %1</source>
        <translation>添加视图 %1</translation>
    </message>
    <message>
        <source>View added: a click in the strip above the image shows it.</source>
        <translation>已添加视图：单击图像上方的条即可显示。</translation>
    </message>
    <message>
        <source>Further runs become views once there are vessels. Open them again then.</source>
        <translation>有血管之后，其余序列才能成为视图。届时请再次打开。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::OpenDialogs</name>
    <message>
        <source>Whose camera counts?</source>
        <translation>以哪个相机为准？</translation>
    </message>
    <message>
        <source>“%1” brings a camera that is not the one of the case. A pose shows the vessels in their place by its own camera only.</source>
        <translation>“%1”带有与病例不同的相机。只有用其自身的相机，位姿才会把血管显示在正确位置。</translation>
    </message>
    <message>
        <source>Take pose and camera</source>
        <translation>采用位姿和相机</translation>
    </message>
    <message>
        <source>Take the pose alone</source>
        <translation>只采用位姿</translation>
    </message>
    <message>
        <source>Not the same patient?</source>
        <translation>不是同一患者？</translation>
    </message>
    <message>
        <source>If “%1” is opened all the same, every picture and report of the case will say so, and no registration of its images is trusted. Open it as the same patient where pseudonyms differ.</source>
        <translation>如果仍然打开“%1”，该病例的每张图片和报告都会注明这一点，且其图像的任何配准都不被视为可信。如果只是假名不同，请作为同一患者打开。</translation>
    </message>
    <message>
        <source>Do not open it</source>
        <translation>不打开</translation>
    </message>
    <message>
        <source>Open it all the same</source>
        <translation>仍然打开</translation>
    </message>
    <message>
        <source>It is the same patient</source>
        <translation>是同一患者</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Open folder or disc</source>
        <translation>打开文件夹或光盘</translation>
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
        <source>The case has an angiogram. “%1” can stand beside it, to register both together, or take its place.</source>
        <translation>病例已有血管造影。“%1”可与其并列以一起配准，或替换它。</translation>
    </message>
    <message>
        <source>Add as a view</source>
        <translation>添加为视图</translation>
    </message>
    <message>
        <source>Replace the angiogram</source>
        <translation>替换血管造影</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>A scan beside the vessels?</source>
        <translation>扫描与血管并列？</translation>
    </message>
    <message>
        <source>The case has its vessels from a file. “%1” can be shown in slices with them, or its own vessels are traced and take their place.</source>
        <translation>病例的血管来自文件。“%1”可与其一起在切片中显示，或重新提取其血管并替换。</translation>
    </message>
    <message>
        <source>Show beside the vessels</source>
        <translation>与血管并列显示</translation>
    </message>
    <message>
        <source>Trace its vessels</source>
        <translation>提取其血管</translation>
    </message>
    <message>
        <source>Making the sample case …</source>
        <translation>正在生成示例病例……</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>Could not make the sample case</source>
        <translation>无法生成示例病例</translation>
    </message>
    <message>
        <source>Save the open case first?</source>
        <translation>先保存当前病例吗？</translation>
    </message>
    <message>
        <source>“%1” has changes that are not saved.</source>
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
        <source>Keep the open case</source>
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
        <source>“%1” does not say in what unit its points are, and in millimetres it is unusually small or large for vessels. The case remembers what you choose.</source>
        <translation>“%1”未说明点坐标的单位；若为毫米，则对血管而言异常小或大。病例会记住您的选择。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>What is the unit of the file?</source>
        <translation>文件的单位是什么？</translation>
    </message>
    <message>
        <source>Discard what was done?</source>
        <translation>放弃所做的工作？</translation>
    </message>
    <message>
        <source>“%1” has no vessels yet, so there is no case to save. What was done here is lost.</source>
        <translation>“%1”尚无血管，因此没有可保存的病例。此处所做的工作将丢失。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::OpenNotes</name>
    <message>
        <source>The vessels do not lie in this scan: it may be another one, or have other axes.</source>
        <translation>血管不在此扫描内：可能是其他扫描，或坐标轴不同。</translation>
    </message>
    <message>
        <source>The scan is shown without vessels: place a seed or set the threshold in the slices (%1), then trace.</source>
        <translation>显示的扫描没有血管：请在切片（%1）中放置种子点或设置阈值，然后提取。</translation>
    </message>
    <message>
        <source>One unit of the file is %1 mm, as you chose.</source>
        <translation>按您的选择，文件的一个单位为 %1 mm。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PictureController</name>
    <message>
        <source>The window is in the clipboard as a picture</source>
        <translation>窗口图片已复制到剪贴板</translation>
    </message>
    <message>
        <source>Save picture of the window</source>
        <translation>保存窗口图片</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG 图片 (*.png)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>Could not save the picture</source>
        <translation>无法保存图片</translation>
    </message>
    <message>
        <source>%1 could not be written. Choose another folder.</source>
        <translation>无法写入 %1。请选择其他文件夹。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PivotController</name>
    <message>
        <source>Pick the pivot</source>
        <translation>选取旋转中心</translation>
    </message>
    <message>
        <source>The vessels turn about the picked place now.</source>
        <translation>血管现在围绕所选位置转动。</translation>
    </message>
    <message>
        <source>Pivot back to the centroid</source>
        <translation>旋转中心恢复为质心</translation>
    </message>
    <message>
        <source>The vessels turn about their centroid again.</source>
        <translation>血管重新围绕其质心转动。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PlotExport</name>
    <message>
        <source>Copy picture</source>
        <translation>复制图片</translation>
    </message>
    <message>
        <source>Export as SVG …</source>
        <translation>导出为 SVG……</translation>
    </message>
    <message>
        <source>Export as PNG …</source>
        <translation>导出为 PNG……</translation>
    </message>
    <message>
        <source>Export plot</source>
        <translation>导出图表</translation>
    </message>
    <message>
        <source>Drawings (*.svg)</source>
        <translation>矢量图 (*.svg)</translation>
    </message>
    <message>
        <source>PNG pictures (*.png)</source>
        <translation>PNG 图片 (*.png)</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PoseController</name>
    <message>
        <source>Move vessels</source>
        <translation>移动血管</translation>
    </message>
    <message>
        <source>There is no pose to nudge yet: vessels, angiogram and geometry come first.</source>
        <translation>尚无可微调的位姿：请先提供血管、造影图像和几何参数。</translation>
    </message>
    <message>
        <source>“%1” is locked.</source>
        <translation>“%1”已锁定。</translation>
    </message>
    <message>
        <source>Back to start pose</source>
        <translation>回到初始位姿</translation>
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
        <source>Nudge mode: arrows move, drag moves or rolls, N ends</source>
        <translation>微调模式：方向键平移，拖动平移或旋转，N 结束</translation>
    </message>
    <message>
        <source>Nudge mode off</source>
        <translation>微调模式已关闭</translation>
    </message>
    <message>
        <source>Copied: camera from patient, 4 × 4, mm</source>
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
        <source>The pose as it is</source>
        <translation>当前位姿</translation>
    </message>
    <message>
        <source>The vessels of this frame are still being traced.</source>
        <translation>此帧血管仍在提取。</translation>
    </message>
    <message>
        <source>Starting …</source>
        <translation>开始……</translation>
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
        <source>Open a vessel centreline first.</source>
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
        <source>A blind trial is fitted by hand.</source>
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
        <source>Other way %1 of %2, probability %3 % · %4 takes it</source>
        <translation>另一路径 %1 / %2，概率 %3 % · %4 采用</translation>
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
        <source>sideways</source>
        <translation>左右</translation>
    </message>
    <message>
        <source>up–down</source>
        <translation>上下</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>There is no run to replay. Register first (R).</source>
        <translation>没有可回放的过程。请先配准（R）。</translation>
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
        <source>The run found no other solution.</source>
        <translation>未找到其他解。</translation>
    </message>
    <message>
        <source>There is no run yet. Register first (R).</source>
        <translation>尚未配准。请先配准（R）。</translation>
    </message>
    <message>
        <source>The solution itself</source>
        <translation>最优解本身</translation>
    </message>
    <message>
        <source>J shows the other solutions first.</source>
        <translation>请先按 J 显示其他解。</translation>
    </message>
    <message>
        <source>Take solution %1</source>
        <translation>采用解 %1</translation>
    </message>
    <message>
        <source>Other solution %1 of %2, score %3 · %4 takes it</source>
        <translation>其他解 %1 / %2，评分 %3 · %4 采用</translation>
    </message>
    <message>
        <source>By image noise only, poses within ±%1 mm (2 σ, mostly %2) look alike</source>
        <translation>仅因图像噪声，±%1 mm 内的位姿（2 σ，主要为 %2）看起来相同</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ReviewController</name>
    <message>
        <source>Choose another frame</source>
        <translation>选择另一帧</translation>
    </message>
    <message>
        <source>Before: start pose</source>
        <translation>之前：初始位姿</translation>
    </message>
    <message>
        <source>No bent vessels are known of this pose</source>
        <translation>此位姿没有已知的弯曲血管</translation>
    </message>
    <message>
        <source>Colours: how far from the traced vessels</source>
        <translation>颜色：到提取血管的距离</translation>
    </message>
    <message>
        <source>Colours: how far the bent vessels lie from the rigid ones</source>
        <translation>颜色：弯曲血管到刚性血管的距离</translation>
    </message>
    <message>
        <source>Vessels as the rigid pose has them</source>
        <translation>血管：按刚性位姿显示</translation>
    </message>
    <message>
        <source>Vessels as they are bent</source>
        <translation>血管：按弯曲显示</translation>
    </message>
    <message>
        <source>After: pose as it is</source>
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
        <source>Tracing the vessels of this frame …</source>
        <translation>正在提取此帧的血管……</translation>
    </message>
    <message>
        <source>Registration cannot run</source>
        <translation>无法进行配准</translation>
    </message>
    <message>
        <source>Registering: %1 · %2 % · %3 px</source>
        <translation>配准中：%1 · %2 % · %3 px</translation>
    </message>
    <message>
        <source>Stopped, NOT RELIABLE: the best pose so far is kept, undo takes it back</source>
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
        <source>A blind trial is under way. End it before saving.</source>
        <translation>盲法试验进行中。保存前请结束。</translation>
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
        <source>A case holds vessels and an angiogram. Until it has one, save the vessels alone, as centrelines: opened together with any angiogram they make a case.</source>
        <translation>病例含有血管和造影图像。在有造影图像之前，可单独将血管存为中心线：与任一造影图像一起打开即成为病例。</translation>
    </message>
    <message>
        <source>Save the vessels …</source>
        <translation>保存血管……</translation>
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
        <source>Vessels saved as centrelines</source>
        <translation>血管已存为中心线</translation>
    </message>
    <message>
        <source>Changed elsewhere</source>
        <translation>已在别处更改</translation>
    </message>
    <message>
        <source>“%1” was saved by another window or program since it was opened here. Overwriting discards what was saved there; reloading discards what was changed here.</source>
        <translation>“%1”在此处打开后，已被另一个窗口或程序保存。覆盖会丢弃在那里保存的内容；重新载入会丢弃在此处所做的更改。</translation>
    </message>
    <message>
        <source>Save as …</source>
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
        <source>Case packed: %1</source>
        <translation>病例已打包：%1</translation>
    </message>
    <message>
        <source>Could not pack the case</source>
        <translation>无法打包病例</translation>
    </message>
    <message>
        <source>DICOM objects written: %1</source>
        <translation>已写出 DICOM 对象：%1</translation>
    </message>
    <message>
        <source>The program could not be started again. Start it from the menu of the system.</source>
        <translation>程序无法再次启动。请从系统菜单启动。</translation>
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
        <source>AngioPose is a research program. It is not a medical device: do not use it for diagnosis, treatment or navigation. Results can be wrong; one projection cannot tell everything about depth.</source>
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
        <source>Saving …</source>
        <translation>正在保存……</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>正在写入……</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>Could not export</source>
        <translation>无法导出</translation>
    </message>
    <message>
        <source>The automatic copy cannot be written; it is tried again every minute. %1</source>
        <translation>无法写入自动备份；每分钟重试一次。%1</translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>已停止；未写入任何内容。</translation>
    </message>
    <message>
        <source>Some files were refused</source>
        <translation>部分文件被拒绝</translation>
    </message>
    <message>
        <source>Could not de-identify the files</source>
        <translation>无法对文件去标识</translation>
    </message>
    <message>
        <source>The audit file is not complete</source>
        <translation>审计文件不完整</translation>
    </message>
</context>
<context>
    <name>angiopose::app::SideBySideController</name>
    <message>
        <source>No other views during a blind trial: they would tell the answer.</source>
        <translation>盲法试验期间不显示其他视图：它们会泄露答案。</translation>
    </message>
    <message>
        <source>There is no angiogram yet that another could stand beside.</source>
        <translation>尚无血管造影可与另一幅并排。</translation>
    </message>
    <message>
        <source>This case has one view. Another angiogram of the same vessels (%1) will stand beside it.</source>
        <translation>此病例只有一个视图。添加同一血管的另一造影（%1）后将并排显示。</translation>
    </message>
    <message>
        <source>no geometry</source>
        <translation>无几何参数</translation>
    </message>
    <message>
        <source>moves along</source>
        <translation>随动</translation>
    </message>
    <message>
        <source>pose of its own</source>
        <translation>独立位姿</translation>
    </message>
    <message>
        <source>The vessels move here as they do in the shown view.</source>
        <translation>此处的血管随当前视图一同移动。</translation>
    </message>
    <message>
        <source>The views are not registered together: the vessels stay here while they are moved in the shown view.</source>
        <translation>各视图未一起配准：在当前视图中移动血管时，此处的血管保持不动。</translation>
    </message>
    <message>
        <source>A click here, or a double click in the image, makes it the shown view.</source>
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
        <source>There is no pose to keep yet.</source>
        <translation>尚无可保留的位姿。</translation>
    </message>
    <message>
        <source>Keep %1</source>
        <translation>保留 %1</translation>
    </message>
    <message>
        <source>Kept as “%1” · Y compares</source>
        <translation>已保留为“%1” · Y 比较</translation>
    </message>
    <message>
        <source>“%1”: median %2 mm · Esc goes back</source>
        <translation>“%1”：中位数 %2 mm · Esc 返回</translation>
    </message>
    <message>
        <source>“%1” · Esc goes back</source>
        <translation>“%1” · Esc 返回</translation>
    </message>
    <message>
        <source>There is nothing to compare with yet: K keeps a pose, R leaves one.</source>
        <translation>尚无可比较：K 保留位姿，R 也会留下一个。</translation>
    </message>
    <message>
        <source>A: the pose as it is</source>
        <translation>A：当前位姿</translation>
    </message>
    <message>
        <source>Restore %1</source>
        <translation>恢复 %1</translation>
    </message>
    <message>
        <source>Describe a pose</source>
        <translation>描述位姿</translation>
    </message>
    <message>
        <source>Delete a pose</source>
        <translation>删除位姿</translation>
    </message>
    <message>
        <source>Delete %1 poses</source>
        <translation>删除 %1 个位姿</translation>
    </message>
</context>
<context>
    <name>angiopose::app::SolutionController</name>
    <message>
        <source>%1 %: %2</source>
        <translation>%1 %：%2</translation>
    </message>
    <message>
        <source>%1 Return takes it.</source>
        <translation>%1按回车采用。</translation>
    </message>
    <message>
        <source>Branches %1: probability %2 %, %3 % of the wire along them, %4 mm off their axes.</source>
        <translation>分支 %1：概率 %2 %，%3 % 的导丝沿其走行，偏离轴线 %4 mm。</translation>
    </message>
    <message>
        <source>found</source>
        <translation>所求</translation>
    </message>
    <message>
        <source>The solution itself</source>
        <translation>最优解本身</translation>
    </message>
    <message>
        <source>%1 mm, %2°</source>
        <translation>%1 mm，%2°</translation>
    </message>
    <message>
        <source>Other solution %1, score %2: %3 mm aside, %4 mm in depth and %5° turned from the one found. Return takes it.</source>
        <translation>其他解 %1，评分 %2：与所求解相差横向 %3 mm、深度 %4 mm、旋转 %5°。回车采用。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::StartPoseController</name>
    <message>
        <source>Start pose from angles</source>
        <translation>由角度得初始位姿</translation>
    </message>
    <message>
        <source>Start pose from the angles, the isocentre in the vessels</source>
        <translation>由角度得初始位姿，等中心在血管内</translation>
    </message>
    <message>
        <source>Vessels, angiogram and geometry come first.</source>
        <translation>请先提供血管、造影图像和几何参数。</translation>
    </message>
    <message>
        <source>Start pose by hand</source>
        <translation>手动初始位姿</translation>
    </message>
    <message>
        <source>The pose as it is has become the start pose</source>
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
        <source>tracing …</source>
        <translation>提取中……</translation>
    </message>
    <message>
        <source>given centreline</source>
        <translation>给定中心线</translation>
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
        <source>contradictory</source>
        <translation>相互矛盾</translation>
    </message>
    <message>
        <source>partly assumed</source>
        <translation>部分为假定</translation>
    </message>
    <message>
        <source>Some values are assumed. Type them if you know them.</source>
        <translation>部分数值为假定。如已知请输入。</translation>
    </message>
    <message>
        <source>pixel spacing typed</source>
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
        <source>running …</source>
        <translation>进行中……</translation>
    </message>
    <message>
        <source>moved by hand</source>
        <translation>手动移动</translation>
    </message>
    <message>
        <source>followed</source>
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
        <source>other frame</source>
        <translation>其他帧</translation>
    </message>
    <message>
        <source>This pose was found in frame %1. R registers in the one that is shown.</source>
        <translation>该位姿由第 %1 帧求得。按 R 在当前帧中配准。</translation>
    </message>
    <message>
        <source>%1 mm median</source>
        <translation>中位数 %1 mm</translation>
    </message>
    <message>
        <source>written</source>
        <translation>已写入</translation>
    </message>
    <message>
        <source>Open a CT angiogram, a segmentation, a surface or a centreline.</source>
        <translation>打开 CT 血管造影、分割、表面或中心线。</translation>
    </message>
    <message>
        <source>%1 pieces</source>
        <translation>%1 段</translation>
    </message>
    <message>
        <source>The vessels are in pieces. Below the branch list is how to join them.</source>
        <translation>血管不连续。分支列表下方说明如何连接。</translation>
    </message>
    <message>
        <source>another patient?</source>
        <translation>另一患者？</translation>
    </message>
    <message>
        <source>frame %1, edited</source>
        <translation>第 %1 帧，已编辑</translation>
    </message>
    <message>
        <source>The header gives no pixel spacing: %1. Type it, or press Enter in the field to confirm it.</source>
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
        <source>Nothing was traced in the scan. Place a seed or set the threshold beside its slices.</source>
        <translation>扫描中未提取到任何内容。请在切片旁放置种子点或设置阈值。</translation>
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
        <source>Whole run in one picture</source>
        <translation>整个序列合成一幅</translation>
    </message>
    <message>
        <source>One frame at a time</source>
        <translation>逐帧显示</translation>
    </message>
    <message>
        <source>Choose mask frames</source>
        <translation>选择蒙片帧</translation>
    </message>
    <message>
        <source>A registration is running. Stop it to edit.</source>
        <translation>配准正在进行。请先停止再编辑。</translation>
    </message>
    <message>
        <source>Open an angiogram first.</source>
        <translation>请先打开造影图像。</translation>
    </message>
    <message>
        <source>Move the mask</source>
        <translation>移动蒙片</translation>
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
        <source>Tracing the vessels of the scan … %1 %</source>
        <translation>正在提取扫描的血管…… %1 %</translation>
    </message>
    <message>
        <source>Stopped: the vessels are as they were</source>
        <translation>已停止：血管保持原样</translation>
    </message>
    <message>
        <source>These vessels were not traced: open a scan, a segmentation or a surface.</source>
        <translation>这些血管并非提取所得：请打开扫描、分割或表面。</translation>
    </message>
    <message>
        <source>A registration is running. Stop it first.</source>
        <translation>配准正在进行。请先停止。</translation>
    </message>
    <message>
        <source>Tracing the vessels of the scan …</source>
        <translation>正在提取扫描的血管……</translation>
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
        <source>No label is ticked: tick those that are vessels.</source>
        <translation>没有勾选标签：请勾选属于血管的标签。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::TreeActions</name>
    <message>
        <source>Select one branch: click it in the list or in a view.</source>
        <translation>请选择一个分支：在列表或视图中单击。</translation>
    </message>
    <message>
        <source>%1 pieces, too far apart to belong together</source>
        <translation>%1 段，相距过远，不属于一体</translation>
    </message>
    <message>
        <source>Seed here</source>
        <translation>在此放种子点</translation>
    </message>
    <message>
        <source>Avoid this place</source>
        <translation>避开此处</translation>
    </message>
    <message>
        <source>%1 pieces · gap %2 mm: %3 – %4</source>
        <translation>%1 段 · 间隙 %2 mm：%3 – %4</translation>
    </message>
    <message>
        <source>Turn the vessels about this place</source>
        <translation>围绕此处转动血管</translation>
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
        <source>At least one branch has to stay.</source>
        <translation>至少须保留一个分支。</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>删除 %1</translation>
    </message>
    <message>
        <source>Delete %1 and what leaves it</source>
        <translation>删除 %1 及其分出的分支</translation>
    </message>
    <message>
        <source>Click the place of the cut first, in a slice or on the branch in the 3-D view.</source>
        <translation>请先在断层或三维视图的分支上单击切断位置。</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <translation>切断 %1</translation>
    </message>
    <message>
        <source>Select the two branches to join: Ctrl adds the second one.</source>
        <translation>请选择要连接的两个分支：Ctrl 追加第二个。</translation>
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
        <source>Root at %1</source>
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
        <source>No end branch is shorter or thinner than that.</source>
        <translation>没有更短或更细的末端分支。</translation>
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
        <translation>为此视图命名……</translation>
    </message>
    <message>
        <source>Name this view</source>
        <translation>为此视图命名</translation>
    </message>
    <message>
        <source>Name of the view %1 (empty: its angles)</source>
        <translation>视图 %1 的名称（留空则显示角度）</translation>
    </message>
    <message>
        <source>Name a view</source>
        <translation>为视图命名</translation>
    </message>
    <message>
        <source>Take this view out</source>
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
        <source>%1. A click shows it, Delete takes the shown view out.</source>
        <translation>%1。单击显示，Delete 移除所示视图。</translation>
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
        <source>No other view can be shown in its place.</source>
        <translation>没有其他视图可替代显示。</translation>
    </message>
    <message>
        <source>Take a view out</source>
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
        <source>start pose</source>
        <translation>初始位姿</translation>
    </message>
    <message>
        <source>a step of the run</source>
        <translation>配准过程中的一步</translation>
    </message>
    <message>
        <source>a pose that image noise allows</source>
        <translation>图像噪声允许的位姿</translation>
    </message>
    <message>
        <source>another solution</source>
        <translation>另一个解</translation>
    </message>
    <message>
        <source>a kept pose</source>
        <translation>保留的位姿</translation>
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
        <source>Opacification by frame · frame %1 of %2 · fullest: %3</source>
        <translation>各帧显影 · 第 %1 帧，共 %2 帧 · 最充盈：%3</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>1 is the most likely way, 2 the next one, and so on.</source>
        <translation>1 为最可能的路径，2 为其次，依此类推。</translation>
    </message>
    <message>
        <source>Adds the prior chosen above to the attraction.</source>
        <translation>在吸引项上加入上方所选先验。</translation>
    </message>
    <message>
        <source>Alternates between a few auxiliary points and all points by kernel-weighted PnP (Song, Ghaffari).</source>
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
        <source>Annealed particles around the start, or a walk over the out-of-plane angles.</source>
        <translation>围绕初始位姿的退火粒子，或遍历平面外角度。</translation>
    </message>
    <message>
        <source>Another number draws other lots; the same repeats them.</source>
        <translation>不同数值产生不同随机序列；相同数值可重复。</translation>
    </message>
    <message>
        <source>Attracted by</source>
        <translation>吸引来源</translation>
    </message>
    <message>
        <source>Auxiliary points</source>
        <translation>辅助点</translation>
    </message>
    <message>
        <source>Best-first search over sequences of matched branches, a pose from each (after Zhu; re-implementation, parameters ours).</source>
        <translation>在匹配分支的序列中最佳优先搜索，每个序列给出一个位姿（参照 Zhu；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Brightness under the vessels at their own width, evolution strategy (Jomier 2006; re-implementation, parameters ours).</source>
        <translation>按血管自身宽度取其下亮度，进化策略（Jomier 2006；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Chosen branches (nodes where none is chosen), nodes, the widest branches up to a third of the length, or random points.</source>
        <translation>所选分支（未选时为节点）、节点、最粗且不超过总长三分之一的分支，或随机点。</translation>
    </message>
    <message>
        <source>Coarse search, then robust point-to-line refinement about the tree&apos;s centroid, with uncertainty.</source>
        <translation>先粗搜索，再绕血管树质心做稳健的点到线精配准，并给出不确定度。</translation>
    </message>
    <message>
        <source>Covariance matrix adaptation, or one parent and one child at a time.</source>
        <translation>协方差矩阵自适应，或每次一父一子。</translation>
    </message>
    <message>
        <source>Damped steps on the Huber loss with fresh matches, or L-BFGS on the squared distances.</source>
        <translation>对 Huber 损失做阻尼步并重新匹配，或对距离平方用 L-BFGS。</translation>
    </message>
    <message>
        <source>Direction kernel</source>
        <translation>方向核</translation>
    </message>
    <message>
        <source>Directions count</source>
        <translation>计入方向</translation>
    </message>
    <message>
        <source>Distance between the points of the traced vessels.</source>
        <translation>提取血管的点间距。</translation>
    </message>
    <message>
        <source>Distance between the tree points that are matched; smaller is slower.</source>
        <translation>参与匹配的血管树点间距；越小越慢。</translation>
    </message>
    <message>
        <source>Distance beyond which a point hardly counts in the end; the noise of the image may widen it.</source>
        <translation>最终阶段超过此距离的点几乎不计；图像噪声会使其变宽。</translation>
    </message>
    <message>
        <source>Distance from which a point&apos;s pull stops growing.</source>
        <translation>超过此距离后单点拉力不再增大。</translation>
    </message>
    <message>
        <source>Edge scale</source>
        <translation>边缘尺度</translation>
    </message>
    <message>
        <source>Edges found along the vessel walls&apos; normals, a pose chosen by RANSAC with gradient matching (Markelj 2008; re-implementation, parameters ours).</source>
        <translation>沿血管壁法线寻找边缘，以 RANSAC 和梯度匹配选位姿（Markelj 2008；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Evaluations at most</source>
        <translation>最多评估次数</translation>
    </message>
    <message>
        <source>Even spacing</source>
        <translation>等间距</translation>
    </message>
    <message>
        <source>Factor by which the kernel narrows with each step after the first thirty.</source>
        <translation>前三十步之后每步核收窄的倍数。</translation>
    </message>
    <message>
        <source>Final scale</source>
        <translation>最终尺度</translation>
    </message>
    <message>
        <source>First kernel width</source>
        <translation>初始核宽</translation>
    </message>
    <message>
        <source>First reach</source>
        <translation>初始范围</translation>
    </message>
    <message>
        <source>First reach in the image</source>
        <translation>图像中初始范围</translation>
    </message>
    <message>
        <source>Flow steps at most</source>
        <translation>最多流步数</translation>
    </message>
    <message>
        <source>Gradient ascent of the mean kernel between tree and traced vessels, or of the image&apos;s brightness (Aylward 2003; re-implementation, parameters ours).</source>
        <translation>对血管树与提取血管之间的平均核，或图像亮度做梯度上升（Aylward 2003；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Gradient flow of the inner product of tree and traced vessels as functions of the image (Ghaffari 2019; re-implementation, parameters ours).</source>
        <translation>血管树与提取血管作为图像函数之内积的梯度流（Ghaffari 2019；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Gradient steps at each of the three widths at most.</source>
        <translation>三个宽度各自的最多梯度步数。</translation>
    </message>
    <message>
        <source>How alike directions must be; small is strict.</source>
        <translation>方向须多相似；越小越严格。</translation>
    </message>
    <message>
        <source>How far a bifurcation or end of the tree and one of the image may lie apart to be the same.</source>
        <translation>树的分叉或端点与图像中的可相距多远仍视为同一处。</translation>
    </message>
    <message>
        <source>How far across the ray the search reaches.</source>
        <translation>搜索在垂直射线方向的范围。</translation>
    </message>
    <message>
        <source>How far along the vessel walls&apos; normals edges are sought at first.</source>
        <translation>最初沿血管壁法线寻找边缘的距离。</translation>
    </message>
    <message>
        <source>How far branches and the traced vessels that show them may lie apart at first.</source>
        <translation>分支与显示它的提取血管起初可相距多远。</translation>
    </message>
    <message>
        <source>How far the mask reaches beyond the projected vessels.</source>
        <translation>掩膜超出投影血管的距离。</translation>
    </message>
    <message>
        <source>How far the search reaches in LAO/RAO and CRA/CAU.</source>
        <translation>搜索在 LAO/RAO 和 CRA/CAU 方向的范围。</translation>
    </message>
    <message>
        <source>How far the search turns the vessels in the image.</source>
        <translation>搜索在图像内旋转血管的范围。</translation>
    </message>
    <message>
        <source>How many, where the auxiliary points are random.</source>
        <translation>辅助点为随机时的数量。</translation>
    </message>
    <message>
        <source>How the pull towards the start pose is weighed against the image.</source>
        <translation>初始位姿约束与图像的权衡方式。</translation>
    </message>
    <message>
        <source>How they are found: the tree and the grid are exact, the map is right to within three pixels.</source>
        <translation>查找方式：树和网格为精确，距离图误差在三个像素内。</translation>
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
        <source>ICP iterations at most</source>
        <translation>ICP 最多迭代</translation>
    </message>
    <message>
        <source>Image point spacing</source>
        <translation>图像点间距</translation>
    </message>
    <message>
        <source>Image points that pull each tree point: the nearest, the five nearest, or all within three kernel widths.</source>
        <translation>作用于每个树点的图像点：最近的、最近五个，或三倍核宽内的全部。</translation>
    </message>
    <message>
        <source>Iterations at most</source>
        <translation>最多迭代</translation>
    </message>
    <message>
        <source>Keeps the projected tree as wide as the traced vessels; lower it where many branches are missing from the image.</source>
        <translation>使投影血管树与提取血管同宽；图像中缺失许多分支时请降低。</translation>
    </message>
    <message>
        <source>Keeps the projected tree from shrinking; lower it where many branches are missing from the image.</source>
        <translation>防止投影血管树收缩；图像缺少较多分支时应降低。</translation>
    </message>
    <message>
        <source>Kernel decay</source>
        <translation>核衰减</translation>
    </message>
    <message>
        <source>Kernel width at first: the largest distance, or its square as the paper prints it.</source>
        <translation>初始核宽：最大距离，或如论文所示取其平方。</translation>
    </message>
    <message>
        <source>Kernel-weighted iterative PnP on all points (Song, Ghaffari).</source>
        <translation>对全部点的核加权迭代 PnP（Song、Ghaffari）。</translation>
    </message>
    <message>
        <source>L2 distance of oriented Gaussian mixtures of tree and traced vessels (Baka 2014; re-implementation, parameters ours).</source>
        <translation>血管树与提取血管的有向高斯混合之 L2 距离（Baka 2014；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Last kernel width</source>
        <translation>最终核宽</translation>
    </message>
    <message>
        <source>Last pose ±, depth</source>
        <translation>上次位姿 ±，深度</translation>
    </message>
    <message>
        <source>Last pose ±, rotation</source>
        <translation>上次位姿 ±，旋转</translation>
    </message>
    <message>
        <source>Last pose ±, shift</source>
        <translation>上次位姿 ±，平移</translation>
    </message>
    <message>
        <source>Least Huber loss of the distances to the nearest traced vessel (Rivest-Hénault 2012; re-implementation, parameters ours).</source>
        <translation>到最近提取血管距离的 Huber 损失最小（Rivest-Hénault 2012；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Least squares on branches matched by their graphs, then vessels that move with their lengths kept (Groher 2009; re-implementation, parameters ours).</source>
        <translation>按图匹配分支后的最小二乘，随后血管保持长度移动（Groher 2009；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Least squares on nearest pairs by OpenCV&apos;s SQPNP, repeated: what library parts make in an afternoon.</source>
        <translation>用 OpenCV 的 SQPNP 对最近点对反复做最小二乘：用现成库一下午可拼成的方法。</translation>
    </message>
    <message>
        <source>Let vessels move</source>
        <translation>允许血管移动</translation>
    </message>
    <message>
        <source>Lets the auxiliary and the full problem take turns.</source>
        <translation>辅助问题与完整问题交替求解。</translation>
    </message>
    <message>
        <source>Lets the auxiliary points and all points take turns.</source>
        <translation>辅助点与全部点交替。</translation>
    </message>
    <message>
        <source>Line searches along all six directions.</source>
        <translation>沿六个方向的线搜索。</translation>
    </message>
    <message>
        <source>Looks for the pose around the start before refining it.</source>
        <translation>精配准前先在初始位姿附近搜索。</translation>
    </message>
    <message>
        <source>Many poses at once, drawn anew by likelihood, or a walk over the out-of-plane angles (after Tian 2022; re-implementation, parameters ours).</source>
        <translation>同时维持多个位姿并按似然重采样，或遍历平面外角度（参照 Tian 2022；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Mask margin</source>
        <translation>掩膜边距</translation>
    </message>
    <message>
        <source>Matching and choosing a pose end after so many rounds.</source>
        <translation>匹配与选位姿的最多轮数。</translation>
    </message>
    <message>
        <source>Matching and solving end after so many rounds.</source>
        <translation>匹配与求解的最多轮数。</translation>
    </message>
    <message>
        <source>Matching branches and fitting the pose end after so many.</source>
        <translation>分支匹配与位姿拟合在此轮数后结束。</translation>
    </message>
    <message>
        <source>Moves the branches onto their partners after the rigid fit, lengths kept, and tells how far; the pose stays.</source>
        <translation>刚性拟合后将分支移向其对应血管并保持长度，说明移动多少；位姿不变。</translation>
    </message>
    <message>
        <source>NICP inside the alternating search (Song, Ghaffari; re-implementation, parameters ours).</source>
        <translation>交替搜索中的 NICP（Song、Ghaffari；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Narrows the kernel after five steps, or once no further point comes within its reach.</source>
        <translation>五步后收窄核，或在不再有新点进入范围时收窄。</translation>
    </message>
    <message>
        <source>Nearest points</source>
        <translation>最近点</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>邻点</translation>
    </message>
    <message>
        <source>Off the axis ±</source>
        <translation>偏离轴线 ±</translation>
    </message>
    <message>
        <source>Only a wire or catheter is visible: which way of the tree it takes, and the pose near the last full one.</source>
        <translation>仅可见导丝或导管：它在血管树中走哪条路径，以及上次完整位姿附近的位姿。</translation>
    </message>
    <message>
        <source>Particles</source>
        <translation>粒子数</translation>
    </message>
    <message>
        <source>Pixels compared</source>
        <translation>比较像素</translation>
    </message>
    <message>
        <source>Points attract each other the more, the more alike the vessels run there.</source>
        <translation>血管走向越一致，点之间吸引越强。</translation>
    </message>
    <message>
        <source>Population</source>
        <translation>种群</translation>
    </message>
    <message>
        <source>Poses from three random correspondences per round.</source>
        <translation>每轮由三个随机对应求得的位姿数。</translation>
    </message>
    <message>
        <source>Poses kept per round.</source>
        <translation>每轮保留的位姿数。</translation>
    </message>
    <message>
        <source>Poses tried in all.</source>
        <translation>总共尝试的位姿数。</translation>
    </message>
    <message>
        <source>Poses tried per generation.</source>
        <translation>每代尝试的位姿数。</translation>
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
        <source>Pull to the start</source>
        <translation>向初始的拉力</translation>
    </message>
    <message>
        <source>Radiographs computed at most.</source>
        <translation>最多计算的模拟 X 线图数。</translation>
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
        <source>Rank correlation of the image with radiographs of the CTA or of tubes, Nelder–Mead (Steininger 2012; re-implementation, parameters ours).</source>
        <translation>图像与 CTA 或管状模型模拟 X 线图的秩相关，Nelder–Mead（Steininger 2012；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Reach of the attraction at first.</source>
        <translation>初始吸引范围。</translation>
    </message>
    <message>
        <source>Reach of the attraction in the end.</source>
        <translation>最终吸引范围。</translation>
    </message>
    <message>
        <source>Reach of the roots</source>
        <translation>根的范围</translation>
    </message>
    <message>
        <source>Rigid only, or an affine stage after it, of which the rigid part is kept if it fits better.</source>
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
        <source>Rounds at most</source>
        <translation>最多轮数</translation>
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
        <source>Search roll</source>
        <translation>搜索滚转</translation>
    </message>
    <message>
        <source>Search tilt</source>
        <translation>搜索倾角</translation>
    </message>
    <message>
        <source>Self term</source>
        <translation>自身项</translation>
    </message>
    <message>
        <source>Sequences of matched branches tried at most.</source>
        <translation>最多尝试的匹配分支序列数。</translation>
    </message>
    <message>
        <source>Share of the mask that the rank correlation is taken over; at least 2000 pixels.</source>
        <translation>秩相关所用掩膜比例；至少 2000 像素。</translation>
    </message>
    <message>
        <source>Smoothing under the gradients of the image.</source>
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
        <source>Spreads the points evenly before matching; off takes them as they are.</source>
        <translation>匹配前将点等距化；关闭则按原样使用。</translation>
    </message>
    <message>
        <source>Standard deviation of the last full pose across the ray.</source>
        <translation>上次完整位姿垂直于射线的标准差。</translation>
    </message>
    <message>
        <source>Standard deviation of the last full pose along the ray.</source>
        <translation>上次完整位姿沿射线的标准差。</translation>
    </message>
    <message>
        <source>Standard deviation of the last full pose&apos;s angles.</source>
        <translation>上次完整位姿角度的标准差。</translation>
    </message>
    <message>
        <source>Standard deviation of the start pose across the ray.</source>
        <translation>初始位姿垂直射线方向的标准差。</translation>
    </message>
    <message>
        <source>Standard deviation of the start pose along the ray.</source>
        <translation>初始位姿沿射线方向的标准差。</translation>
    </message>
    <message>
        <source>Standard deviation of the start pose&apos;s angles; holds what the image cannot tell.</source>
        <translation>初始位姿角度的标准差；约束图像无法确定的量。</translation>
    </message>
    <message>
        <source>Standard deviation of the wire from the vessel&apos;s axis, beside what the vessel&apos;s width lets it.</source>
        <translation>导丝偏离血管轴线的标准差，不含血管管径所允许的部分。</translation>
    </message>
    <message>
        <source>Start depth ±</source>
        <translation>初始深度 ±</translation>
    </message>
    <message>
        <source>Steps along the flow, at all widths together.</source>
        <translation>沿流的步数，各宽度合计。</translation>
    </message>
    <message>
        <source>Way taken</source>
        <translation>采用的路径</translation>
    </message>
    <message>
        <source>Weight of chosen branches</source>
        <translation>所选分支的权重</translation>
    </message>
    <message>
        <source>How much the branches chosen as auxiliary count against the fit of all; 1: they are not fitted apart.</source>
        <translation>选作辅助的分支相对于全部分支的拟合计多少权；1：不单独拟合。</translation>
    </message>
    <message>
        <source>Errors of the geometry</source>
        <translation>几何误差</translation>
    </message>
    <message>
        <source>Whether focal length and principal point may be off by what is usual where they come from, by what is given below, or not at all.</source>
        <translation>焦距和主点的误差：按其来源的常见值、按下方给定值，或不考虑。</translation>
    </message>
    <message>
        <source>Focal length ±</source>
        <translation>焦距 ±</translation>
    </message>
    <message>
        <source>Standard deviation of the focal length where it is given.</source>
        <translation>给定时焦距的标准差。</translation>
    </message>
    <message>
        <source>Principal point ±</source>
        <translation>主点 ±</translation>
    </message>
    <message>
        <source>Standard deviation of each coordinate of the principal point where it is given.</source>
        <translation>给定时主点各坐标的标准差。</translation>
    </message>
    <message>
        <source>Estimate the geometry</source>
        <translation>估计几何参数</translation>
    </message>
    <message>
        <source>Where the images clearly contradict focal length or principal point, takes over those that they show and registers again.</source>
        <translation>当图像明显与焦距或主点不符时，采用图像所显示的值并重新配准。</translation>
    </message>
    <message>
        <source>Mirrored and turned images</source>
        <translation>镜像和旋转的图像</translation>
    </message>
    <message>
        <source>Where a fit is in doubt, tells whether the image looks mirrored or turned.</source>
        <translation>结果可疑时，说明图像是否像被镜像或旋转。</translation>
    </message>
    <message>
        <source>Bent vessels</source>
        <translation>血管形变</translation>
    </message>
    <message>
        <source>Whether the vessels are bent onto the image after the rigid registration: never, where the fit looks as if they were bent (angiopose, nothing locked), or always.</source>
        <translation>刚性配准后是否将血管弯曲到图像上：从不、在拟合看起来像血管弯曲时（angiopose，且无锁定），或总是。</translation>
    </message>
    <message>
        <source>Start rotation ±</source>
        <translation>初始旋转 ±</translation>
    </message>
    <message>
        <source>Start scale</source>
        <translation>初始尺度</translation>
    </message>
    <message>
        <source>Start shift ±</source>
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
        <source>Strength of the pull towards the start pose.</source>
        <translation>向初始位姿拉力的强度。</translation>
    </message>
    <message>
        <source>The refinement ends after so many steps.</source>
        <translation>精配准的最多步数。</translation>
    </message>
    <message>
        <source>The spread narrows by a quarter in each.</source>
        <translation>每轮散布缩小四分之一。</translation>
    </message>
    <message>
        <source>The traced vessels, or the brightness of the image at each vessel&apos;s own width.</source>
        <translation>提取的血管，或按各血管宽度的图像亮度。</translation>
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
        <source>Turns about the source before all else.</source>
        <translation>首先绕射线源旋转。</translation>
    </message>
    <message>
        <source>Turns and shifts in balance, or raw radians beside millimetres, which hardly shifts.</source>
        <translation>旋转与平移平衡，或弧度与毫米直接并用（几乎不平移）。</translation>
    </message>
    <message>
        <source>Vessel walls against image gradients, Powell&apos;s method (Mitrović 2013; re-implementation, parameters ours).</source>
        <translation>血管壁与图像梯度匹配，Powell 法（Mitrović 2013；重新实现，参数自定）。</translation>
    </message>
    <message>
        <source>Width of the mixtures&apos; Gaussians at first.</source>
        <translation>高斯混合的初始宽度。</translation>
    </message>
    <message>
        <source>Width of the mixtures&apos; Gaussians in the end.</source>
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
        <translation>弯曲</translation>
    </message>
    <message>
        <source>stopped by the user</source>
        <translation>用户停止</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>所选</translation>
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
        <source>Angles that show %1</source>
        <translation>能看清 %1 的角度</translation>
    </message>
    <message>
        <source>No branch</source>
        <translation>无分支</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::AngleDialog</name>
    <message>
        <source>Only where it takes off, 10 mm around</source>
        <translation>仅看其发出处，周围 10 mm</translation>
    </message>
    <message>
        <source>C-arm angles</source>
        <translation>C 臂角度</translation>
    </message>
    <message>
        <source>Blue: seen at full length and clear of other vessels. Amber: foreshortened or hidden.</source>
        <translation>蓝色：全长可见且不与其他血管重叠。琥珀色：缩短或被遮挡。</translation>
    </message>
    <message>
        <source>Where the gantry stood for this image.</source>
        <translation>拍摄此图像时 C 臂的位置。</translation>
    </message>
    <message>
        <source>The gantry reaches</source>
        <translation>C 臂可达</translation>
    </message>
    <message>
        <source>Now: %1</source>
        <translation>当前：%1</translation>
    </message>
    <message>
        <source>%1: foreshortened by %2 %, covered by other vessels %3 %</source>
        <translation>%1：缩短 %2 %，被其他血管遮盖 %3 %</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::AngleMapPlot</name>
    <message>
        <source>Map of the gantry&apos;s angles</source>
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
        <source>The vessels from these angles</source>
        <translation>从这些角度看到的血管</translation>
    </message>
</context>
<context>
    <name>messages</name>
    <message>
        <source>The camera or pose has an entry that is not a finite number. Export it again.</source>
        <comment>projection.not-finite</comment>
        <translation>相机或位姿中有不是有限数的值。请重新导出。</translation>
    </message>
    <message>
        <source>The left 3 x 3 part of the projection matrix has no inverse, so that it is no X-ray camera. Export it again.</source>
        <comment>projection.degenerate</comment>
        <translation>投影矩阵左侧 3 x 3 不可逆，因此不是 X 射线相机。请重新导出。</translation>
    </message>
    <message>
        <source>The pixels of the camera are not at right angles (a skew of %1). Give a camera without skew, or resample the image.</source>
        <comment>projection.skewed</comment>
        <translation>相机的像素不成直角（偏斜 %1）。请给出没有偏斜的相机，或对图像重采样。</translation>
    </message>
    <message>
        <source>K must hold focal lengths and principal point only: fx 0 cx, 0 fy cy, 0 0 1. Is it transposed?</source>
        <comment>projection.intrinsics</comment>
        <translation>K 只能含焦距和主点：fx 0 cx, 0 fy cy, 0 0 1。是否转置了？</translation>
    </message>
    <message>
        <source>R is not a rotation (scale or shear). Give a rigid pose in mm.</source>
        <comment>projection.no-rotation</comment>
        <translation>R 不是旋转（含缩放或剪切）。请给出以 mm 为单位的刚性位姿。</translation>
    </message>
    <message>
        <source>it holds no camera with its pose. Give P (3 x 4), or K (3 x 3), R (3 x 3, or rvec) and t (3).</source>
        <comment>exchange.no-pose</comment>
        <translation>其中没有带位姿的相机。请给出 P (3 x 4)，或 K (3 x 3)、R (3 x 3 或 rvec) 和 t (3)。</translation>
    </message>
    <message>
        <source>it holds %1 numbers. P = K [R t] has 12 (three rows of four), a pose cameraFromPatient 16.</source>
        <comment>exchange.numbers</comment>
        <translation>其中有 %1 个数。P = K [R t] 有 12 个（三行四列），位姿 cameraFromPatient 有 16 个。</translation>
    </message>
    <message>
        <source>its camera bends straight lines (distortion coefficients). Undistort the image, then give a camera without them.</source>
        <comment>exchange.distorted</comment>
        <translation>其相机使直线弯曲（畸变系数）。请先校正图像畸变，再给出没有畸变的相机。</translation>
    </message>
    <message>
        <source>a pose in this form needs its camera. Give one: a case, or a pose with a camera.</source>
        <comment>exchange.no-camera</comment>
        <translation>此形式的位姿需要其相机。请给出：一个病例，或带相机的位姿。</translation>
    </message>
    <message>
        <source>a camera with its pose is written as .json, .txt, .yml, .yaml or .xml. Change the extension.</source>
        <comment>exchange.extension</comment>
        <translation>带位姿的相机写为 .json、.txt、.yml、.yaml 或 .xml。请更改扩展名。</translation>
    </message>
    <message>
        <source>this is a file of PyTorch, which can run programs when it is read. Write its pose as JSON first (FORMATS §3.4).</source>
        <comment>exchange.pickle</comment>
        <translation>这是 PyTorch 文件，读取时可能运行程序。请先将其位姿写为 JSON（FORMATS §3.4）。</translation>
    </message>
    <message>
        <source>it is no view of DiffDRR: %1 is missing or wrong. FORMATS §3.4 names the keys.</source>
        <comment>exchange.diffdrr-keys</comment>
        <translation>不是 DiffDRR 的视图：%1 缺失或有误。FORMATS §3.4 列出了各键。</translation>
    </message>
    <message>
        <source>it holds no fiducials. Export the points of a markups node.</source>
        <comment>fiducials.none</comment>
        <translation>其中没有标志点。请导出 markups 节点的点。</translation>
    </message>
    <message>
        <source>line %1 holds no point (id,x,y,z,…). Export the points again.</source>
        <comment>fiducials.line</comment>
        <translation>第 %1 行没有点 (id,x,y,z,…)。请重新导出这些点。</translation>
    </message>
    <message>
        <source>its coordinate system is %1, not LPS or RAS. Export the points in patient coordinates.</source>
        <comment>fiducials.system</comment>
        <translation>其坐标系是 %1，不是 LPS 或 RAS。请以患者坐标导出这些点。</translation>
    </message>
    <message>
        <source>points are written as .fcsv or .mrk.json. Change the extension.</source>
        <comment>fiducials.extension</comment>
        <translation>点写为 .fcsv 或 .mrk.json。请更改扩展名。</translation>
    </message>
    <message>
        <source>%1 is a pose or holds points. Open it by itself while the case that it belongs to is open.</source>
        <comment>open.pose-alone</comment>
        <translation>%1 是位姿或点。请在其所属病例打开时单独打开它。</translation>
    </message>
    <message>
        <source>The pose brings a camera that is not the one of the case. The picture is drawn by its own.</source>
        <comment>pose.other-camera</comment>
        <translation>位姿带有与病例不同的相机。图片按它自己的相机绘制。</translation>
    </message>
    <message>
        <source>The pose is of an image of %1 x %2 px, the angiogram has %3 x %4. Choose the pose of this image.</source>
        <comment>pose.other-image</comment>
        <translation>位姿属于 %1 x %2 px 的图像，而血管造影为 %3 x %4。请选择此图像的位姿。</translation>
    </message>
    <message>
        <source>the case has no landmarks, check points or rings. Set some in the window first.</source>
        <comment>convert.no-points</comment>
        <translation>病例没有标志点、检查点或环。请先在窗口中设置。</translation>
    </message>
    <message>
        <source>The pose is taken as of a detector at negative z without an extrinsic matrix, as xReg has X-ray runs. Give --camera if the image is mirrored.</source>
        <comment>convert.xreg-guessed</comment>
        <translation>位姿按探测器在负 z、没有外参矩阵处理，与 xReg 的 X 射线序列一致。若图像为镜像，请给出 --camera。</translation>
    </message>
    <message>
        <source>the system gives no random numbers, so that nothing could be kept secret.</source>
        <comment>deidentify.no-random-key</comment>
        <translation>系统没有提供随机数，因此无法保密。</translation>
    </message>
    <message>
        <source>Letters are drawn into the picture, at column %1, row %2 and elsewhere: read them, or have them blacked out.</source>
        <comment>deidentify.letters-stay</comment>
        <translation>图像中绘有文字（第 %1 列、第 %2 行及其他位置）：请阅读，或将其涂黑。</translation>
    </message>
    <message>
        <source>Letters drawn into the picture were blacked out (%1 % of its area). Look whether all are gone.</source>
        <comment>deidentify.letters-blacked-out</comment>
        <translation>图像中绘入的文字已涂黑（占面积的 %1 %）。请检查是否全部去除。</translation>
    </message>
    <message>
        <source>The header says that identity is drawn into the picture, and no letters were found in it: look at every frame.</source>
        <comment>deidentify.letters-declared</comment>
        <translation>文件头称图像中绘有身份信息，但未找到文字：请查看每一帧。</translation>
    </message>
    <message>
        <source>The colours became grey, as the program shows them.</source>
        <comment>deidentify.colour-dropped</comment>
        <translation>颜色已变为灰度，与程序的显示一致。</translation>
    </message>
    <message>
        <source>Damaged frames were stored as they could be decoded: %1 of %2.</source>
        <comment>deidentify.frames-damaged</comment>
        <translation>损坏的帧按可解码的程度保存：%1 / %2。</translation>
    </message>
    <message>
        <source>Files that hold no image were left out: %1 of %2.</source>
        <comment>deidentify.files-left-out</comment>
        <translation>不含图像的文件未写出：%1 / %2。</translation>
    </message>
    <message>
        <source>its segments are stored in a way that cannot be stored again. Convert it to .nii.gz or .nrrd: labels have no names there.</source>
        <comment>deidentify.segmentation</comment>
        <translation>其分割的存储方式无法重新存储。请转换为 .nii.gz 或 .nrrd：其中标签没有名称。</translation>
    </message>
    <message>
        <source>its compressed pixels of 32 bits cannot be stored again. Convert it to .nii.gz or .nrrd.</source>
        <comment>deidentify.pixels-too-wide</comment>
        <translation>其 32 位压缩像素无法重新保存。请转换为 .nii.gz 或 .nrrd。</translation>
    </message>
    <message>
        <source>only PNG, JPEG, TIFF and DICOM pictures can be freed of what is written beside the pixels. Save it as PNG.</source>
        <comment>deidentify.picture</comment>
        <translation>只有 PNG、JPEG、TIFF 和 DICOM 图像可以去除像素以外写入的内容。请另存为 PNG。</translation>
    </message>
    <message>
        <source>the folder is not empty. Choose a new one, so that nothing else is handed on with it.</source>
        <comment>deidentify.output-not-empty</comment>
        <translation>该文件夹不为空。请选择新文件夹，以免其他内容一并交出。</translation>
    </message>
    <message>
        <source>it holds no DICOM image. Choose the folder of one study.</source>
        <comment>deidentify.nothing</comment>
        <translation>其中没有 DICOM 图像。请选择一次检查的文件夹。</translation>
    </message>
    <message>
        <source>an input of the case could not be read and is not in the archive: %1</source>
        <comment>pack.input-missing</comment>
        <translation>病例的一个输入无法读取，未放入归档：%1</translation>
    </message>
    <message>
        <source>a case is packed as .zip. Give the file that ending.</source>
        <comment>pack.format</comment>
        <translation>病例打包为 .zip。请使用该扩展名。</translation>
    </message>
    <message>
        <source>the archive cannot be written (%1). Choose another folder or make room.</source>
        <comment>pack.not-written</comment>
        <translation>无法写入归档（%1）。请选择其他文件夹或腾出空间。</translation>
    </message>
    <message>
        <source>Names, notes and texts typed by hand were taken out: %1. Numbers stand in their places.</source>
        <comment>pack.texts-cleared</comment>
        <translation>手工输入的名称、备注和文字已去除：%1。以编号代替。</translation>
    </message>
    <message>
        <source>the packed case does not open as the one it came from: %1 Nothing was written.</source>
        <comment>pack.differs</comment>
        <translation>打包的病例打开后与原病例不同：%1 未写出任何内容。</translation>
    </message>
    <message>
        <source>Branches keep their names: look whether they name anatomy alone.</source>
        <comment>pack.branch-names</comment>
        <translation>分支保留其名称：请检查其是否仅为解剖名称。</translation>
    </message>
    <message>
        <source>a view is missing.</source>
        <comment>pack.views</comment>
        <translation>缺少一个视图。</translation>
    </message>
    <message>
        <source>the pixels of an image differ.</source>
        <comment>pack.pixels</comment>
        <translation>一幅图像的像素不同。</translation>
    </message>
    <message>
        <source>a result does not hold.</source>
        <comment>pack.results</comment>
        <translation>一个结果不再有效。</translation>
    </message>
    <message>
        <source>the vessels differ.</source>
        <comment>pack.vessels</comment>
        <translation>血管不同。</translation>
    </message>
    <message>
        <source>a key needs at least 16 bytes. Make one: head -c 32 /dev/urandom &gt; key</source>
        <comment>deidentify.key-too-short</comment>
        <translation>密钥至少需要 16 字节。可这样生成：head -c 32 /dev/urandom &gt; key</translation>
    </message>
    <message>
        <source>without identity this input becomes a file with the ending %1, or, for a folder, a folder. Name OUT so.</source>
        <comment>deidentify.kind</comment>
        <translation>去除身份后，此输入成为扩展名为 %1 的文件；文件夹成为文件夹。请如此命名 OUT。</translation>
    </message>
    <message>
        <source>it is a TIFF whose pixels cannot be stored again bit by bit (only grey, palette or RGB of 8 or 16 bits or float, in strips). Save it as PNG.</source>
        <comment>deidentify.tiff</comment>
        <translation>该 TIFF 的像素无法逐位重新存储（仅支持条带式的灰度、调色板或 RGB，8 或 16 位或浮点）。请另存为 PNG。</translation>
    </message>
    <message>
        <source>it is a document (PDF), whose pages may show names anywhere. Make it anew from a case without identity.</source>
        <comment>deidentify.pages</comment>
        <translation>这是一份文档（PDF），其页面任何位置都可能显示姓名。请由不含身份信息的病例重新生成。</translation>
    </message>
    <message>
        <source>objects of this kind (class %1) hold what cannot be cleared for sure. Leave it out.</source>
        <comment>deidentify.object</comment>
        <translation>此类对象（类别 %1）含有无法确保清除的内容。请将其略去。</translation>
    </message>
    <message>
        <source>it says that it is no image (class %1) but holds one, which would be lost. Export it again, or leave it out.</source>
        <comment>deidentify.object-with-pixels</comment>
        <translation>它自称不是图像（类别 %1），却含有图像，该图像会丢失。请重新导出，或将其略去。</translation>
    </message>
    <message>
        <source>Words in a report, segmentation or presentation state were taken out, codes and numbers stayed: %1.</source>
        <comment>deidentify.words-cleared</comment>
        <translation>报告、分割或显示状态中的文字已去除，编码和数值保留：%1。</translation>
    </message>
    <message>
        <source>It may as well take %1 (%2).</source>
        <comment>wire.may-follow</comment>
        <translation>它也可能走 %1（%2）。</translation>
    </message>
    <message>
        <source>No way through the vessel tree is likely: the best has a probability of %1.</source>
        <comment>wire.unlikely</comment>
        <translation>血管树中没有可能性高的路径：最佳路径的概率为 %1。</translation>
    </message>
    <message>
        <source>Only %1 of the wire lies along the vessel tree.</source>
        <comment>wire.off-tree</comment>
        <translation>仅 %1 的导丝沿血管树走行。</translation>
    </message>
    <message>
        <source>The traced curves make no single line: %1 of it are gaps. Take out the curves that are no wire.</source>
        <comment>wire.in-pieces</comment>
        <translation>提取的曲线不构成单一线条：其中 %1 为间隙。请去除不是导丝的曲线。</translation>
    </message>
    <message>
        <source>The wire lies along no way of the vessel tree near the start pose. Start from the last full registration, or let it be off by more.</source>
        <comment>wire.nowhere</comment>
        <translation>在起始位姿附近，导丝不沿血管树的任何路径。请从上次完整配准开始，或允许更大的偏差。</translation>
    </message>
    <message>
        <source>The wire takes the branches %1 with a probability of %2; it lies %3 off their axes.</source>
        <comment>wire.follows</comment>
        <translation>导丝以 %2 的概率走分支 %1；偏离其轴线 %3。</translation>
    </message>
    <message>
        <source>There are %1 likely ways: the most likely one is taken instead of the one asked for.</source>
        <comment>wire.fewer-ways</comment>
        <translation>可能的路径有 %1 条：采用最可能的一条，而非所要求的那条。</translation>
    </message>
    <message>
        <source>pictures are written as .png or .svg, and by the window as .pdf. Choose one of these.</source>
        <comment>picture.kind</comment>
        <translation>图像可写为 .png 或 .svg，窗口中还可写为 .pdf。请选择其一。</translation>
    </message>
    <message>
        <source>Grey values of 16 bit are written as .png alone.</source>
        <comment>picture.grey-kind</comment>
        <translation>16 位灰度值只能写为 .png。</translation>
    </message>
    <message>
        <source>The folder &apos;%1&apos; cannot be made: %2.</source>
        <comment>folder.not-made</comment>
        <translation>无法创建文件夹“%1”：%2。</translation>
    </message>
    <message>
        <source>Unexpected failure: %1</source>
        <comment>run.unexpected-failure</comment>
        <translation>意外故障：%1</translation>
    </message>
    <message>
        <source>there is no setting &apos;%1&apos;. The nearest are: %2.</source>
        <comment>setting.unknown</comment>
        <translation>没有名为“%1”的设置。最接近的是：%2。</translation>
    </message>
    <message>
        <source>the setting %1 cannot be &apos;%2&apos;: %3</source>
        <comment>setting.value</comment>
        <translation>设置 %1 不能为“%2”：%3</translation>
    </message>
    <message>
        <source>a batch needs a header row with the column case, or with vessels and angiogram, and a row for each case.</source>
        <comment>batch.header-missing</comment>
        <translation>批处理表需要一行表头，含有 case 列，或 vessels 和 angiogram 列，并且每个病例一行。</translation>
    </message>
    <message>
        <source>line %1, column %2: %3</source>
        <comment>batch.cell</comment>
        <translation>第 %1 行，%2 列：%3</translation>
    </message>
    <message>
        <source>line %1 names a case and inputs beside it. Name either the case, or its vessels and its angiogram.</source>
        <comment>batch.not-both</comment>
        <translation>第 %1 行既给出病例又给出输入。请只给出病例，或只给出其血管和造影图像。</translation>
    </message>
    <message>
        <source>line %1 names too little. Name a case, or both vessels and an angiogram.</source>
        <comment>batch.inputs-lack</comment>
        <translation>第 %1 行给出的内容不足。请给出病例，或同时给出血管和造影图像。</translation>
    </message>
    <message>
        <source>line %1: the seeds &apos;%2&apos; are no points. Write x y z in mm (LPS), and &apos;;&apos; between points.</source>
        <comment>batch.seeds-unclear</comment>
        <translation>第 %1 行：种子点“%2”不是点。请写成以毫米为单位的 x y z（LPS），点之间用“;”分隔。</translation>
    </message>
    <message>
        <source>the program that worked on it ended before its time (%1). What was written of it is not kept.</source>
        <comment>batch.crashed</comment>
        <translation>处理它的程序提前结束（%1）。已写出的部分不予保留。</translation>
    </message>
    <message>
        <source>it took longer than %1 and was ended. Give it more time with --time-limit.</source>
        <comment>batch.out-of-time</comment>
        <translation>用时超过 %1，已被终止。请用 --time-limit 给它更多时间。</translation>
    </message>
    <message>
        <source>the program that works on the cases, %1, cannot be started.</source>
        <comment>batch.no-worker</comment>
        <translation>无法启动处理病例的程序 %1。</translation>
    </message>
    <message>
        <source>it holds %1 series. Name a file of one of them, or a case that names the series.</source>
        <comment>batch.several-series</comment>
        <translation>其中含有 %1 个序列。请给出其中一个序列的文件，或指明序列的病例。</translation>
    </message>
    <message>
        <source>its vessels are %1 units across, which are hardly millimetres. Name a case that tells the unit.</source>
        <comment>batch.unit-unclear</comment>
        <translation>其血管跨度为 %1 个单位，不大可能是毫米。请给出说明单位的病例。</translation>
    </message>
    <message>
        <source>no folder holds an outcome of this row. Run it, with --resume.</source>
        <comment>batch.row-missing</comment>
        <translation>没有文件夹含有此行的结果。请用 --resume 运行它。</translation>
    </message>
    <message>
        <source>the outcomes of %1 and %2 come from other settings or another version. Merge what was run alike.</source>
        <comment>batch.merge-differs</comment>
        <translation>%1 与 %2 的结果来自不同的设置或不同的版本。请只合并以相同方式运行的结果。</translation>
    </message>
    <message>
        <source>nothing has been registered in this case: its vessels are where they start. Give --register, or --from with a result; --start-pose where the start itself is wanted.</source>
        <comment>dicom-export.at-start</comment>
        <translation>此病例尚未配准：血管仍在起始处。请给出 --register，或用 --from 给出结果；若需要起始位姿本身，请用 --start-pose。</translation>
    </message>
    <message>
        <source>Nothing has been registered in this case: its vessels are drawn where they start. Register it with --save, or give --pose or --from.</source>
        <comment>command.drawn-at-start</comment>
        <translation>此病例尚未配准：血管画在起始位姿处。请用 --save 配准，或给出 --pose 或 --from。</translation>
    </message>
    <message>
        <source>at the start pose: nothing registered</source>
        <comment>pose.at-start</comment>
        <translation>处于起始位姿：尚未配准</translation>
    </message>
    <message>
        <source>it is no result of a registration. Give a result.json or joint.json that `register` or `batch` wrote.</source>
        <comment>result.not-one</comment>
        <translation>这不是配准结果。请给出由 `register` 或 `batch` 写出的 result.json 或 joint.json。</translation>
    </message>
    <message>
        <source>it does not hold what it was found from: an earlier version found it, or its registration estimated the geometry. Register its case instead.</source>
        <comment>result.without-case</comment>
        <translation>其中不含得出结果所用的内容：它由较早的版本得出，或其配准估计了几何。请改为配准其病例。</translation>
    </message>
    <message>
        <source>its input %1 is nowhere to be found with the content that it was found from (SHA-256 %2). Name the folder that it lies in with --inputs.</source>
        <comment>result.input-missing</comment>
        <translation>找不到内容与得出结果时相同的输入 %1（SHA-256 %2）。请用 --inputs 给出它所在的文件夹。</translation>
    </message>
    <message>
        <source>its input %1 has other content than it was found from. Name the folder of the right one with --inputs.</source>
        <comment>result.input-changed</comment>
        <translation>输入 %1 的内容与得出结果时不同。请用 --inputs 给出正确输入所在的文件夹。</translation>
    </message>
    <message>
        <source>--shard needs a part and a number of parts such as 2/4, not &apos;%1&apos;.</source>
        <comment>command.shard-unclear</comment>
        <translation>--shard 需要部分号和总份数，例如 2/4，而不是“%1”。</translation>
    </message>
    <message>
        <source>There is no degree of freedom &apos;%1&apos; to lock. Use %2, or none.</source>
        <comment>command.no-such-freedom</comment>
        <translation>没有可锁定的自由度“%1”。可用：%2，或 none。</translation>
    </message>
    <message>
        <source>no bent vessels are known of its pose. Register it where they look bent, or with the option deformable=always.</source>
        <comment>command.no-bent-vessels</comment>
        <translation>其位姿没有已知的弯曲血管。请在血管看似弯曲处配准，或使用选项 deformable=always。</translation>
    </message>
    <message>
        <source>the image of this view could not be read.</source>
        <comment>command.view-image-unread</comment>
        <translation>无法读取该视图的图像。</translation>
    </message>
    <message>
        <source>The folders to merge hold runs of &apos;%1&apos;, not of &apos;%2&apos;.</source>
        <comment>command.merge-of-others</comment>
        <translation>要合并的文件夹中是“%1”的运行结果，而不是“%2”的。</translation>
    </message>
    <message>
        <source>it holds no centrelines yet. Trace them: angiopose-cli trace-vessel %1 --output %2.</source>
        <comment>convert.no-curves</comment>
        <translation>其中还没有中心线。请先追踪：angiopose-cli trace-vessel %1 --output %2。</translation>
    </message>
    <message>
        <source>it is neither a volume nor a surface, so it makes no volume. Choose a scan (DICOM, NIfTI, NRRD, MetaImage) or a surface, or give another output name.</source>
        <comment>convert.no-volume</comment>
        <translation>既不是体数据也不是表面，因此无法生成体数据。请选择扫描（DICOM、NIfTI、NRRD、MetaImage）或表面，或改用其他输出文件名。</translation>
    </message>
    <message>
        <source>the extension is none that is written. Centrelines: .vtp, .csv, .swc, .mrk.json; volumes: .nii, .nii.gz, .nrrd, .mha; surfaces: .stl; poses: .json, .tfm, .h5; X-ray runs: .dcm.</source>
        <comment>convert.extension</comment>
        <translation>不支持写入该扩展名。中心线：.vtp、.csv、.swc、.mrk.json；体数据：.nii、.nii.gz、.nrrd、.mha；表面：.stl；位姿：.json、.tfm、.h5；X 射线序列：.dcm。</translation>
    </message>
    <message>
        <source>this is the input, which is never overwritten. Choose another name.</source>
        <comment>convert.onto-input</comment>
        <translation>这是输入文件，绝不会被覆盖。请选择其他文件名。</translation>
    </message>
    <message>
        <source>it is no label image, so it has no labels. Leave --label out, or choose a segmentation.</source>
        <comment>trace.no-labels</comment>
        <translation>不是标签图像，因此没有标签。请去掉 --label，或选择分割结果。</translation>
    </message>
    <message>
        <source>it holds centrelines already, which need no tracing. `convert` changes their format.</source>
        <comment>trace.centrelines</comment>
        <translation>其中已是中心线，无需追踪。`convert` 可转换其格式。</translation>
    </message>
    <message>
        <source>it cannot be traced. Choose another surface.</source>
        <comment>trace.other-surface</comment>
        <translation>无法追踪。请选择其他表面。</translation>
    </message>
    <message>
        <source>thin vessels are told by the values of a scan, and this has none. Leave --tubes out.</source>
        <comment>trace.tubes-of-mask</comment>
        <translation>细血管由扫描的数值判断，而此文件没有数值。请去掉 --tubes。</translation>
    </message>
    <message>
        <source>it cannot be traced. Choose a scan.</source>
        <comment>trace.no-scan</comment>
        <translation>无法追踪。请选择扫描。</translation>
    </message>
    <message>
        <source>this is no file that AngioPose reads. It reads cases (.angiopose), centrelines (VTP, VTK, CSV, SWC, .mrk.json), scans and segmentations (DICOM, NIfTI, NRRD, MetaImage), surfaces (STL, PLY, OBJ), angiograms (DICOM, PNG, TIFF, JPEG) and poses (.json, .tfm).</source>
        <comment>info.unknown</comment>
        <translation>AngioPose 不读取此文件。可读取病例（.angiopose）、中心线（VTP、VTK、CSV、SWC、.mrk.json）、扫描和分割（DICOM、NIfTI、NRRD、MetaImage）、表面（STL、PLY、OBJ）、血管造影（DICOM、PNG、TIFF、JPEG）以及位姿（.json、.tfm）。</translation>
    </message>
    <message>
        <source>this is %1, nothing that AngioPose reads. It reads cases (.angiopose), centrelines (VTP, VTK, CSV, SWC, .mrk.json), scans and segmentations (DICOM, NIfTI, NRRD, MetaImage), surfaces (STL, PLY, OBJ), angiograms (DICOM, PNG, TIFF, JPEG) and poses (.json, .tfm).</source>
        <comment>info.other</comment>
        <translation>这是%1，AngioPose 不读取。可读取病例（.angiopose）、中心线（VTP、VTK、CSV、SWC、.mrk.json）、扫描和分割（DICOM、NIfTI、NRRD、MetaImage）、表面（STL、PLY、OBJ）、血管造影（DICOM、PNG、TIFF、JPEG）以及位姿（.json、.tfm）。</translation>
    </message>
    <message>
        <source>There is not enough memory for this. Close other programs or use smaller inputs.</source>
        <comment>run.not-enough-memory</comment>
        <translation>内存不足。请关闭其他程序或使用较小的数据。</translation>
    </message>
    <message>
        <source>A library gave up: %1. Check the inputs.</source>
        <comment>run.library-gave-up</comment>
        <translation>库函数失败：%1。请检查输入。</translation>
    </message>
    <message>
        <source>Stopped before the run began.</source>
        <comment>run.stopped-before</comment>
        <translation>运行开始前已停止。</translation>
    </message>
    <message>
        <source>There is nothing to show yet.</source>
        <comment>run.not-shown</comment>
        <translation>还没有可显示的内容。</translation>
    </message>
    <message>
        <source>The scan does not reach to the vessels. Show all of it, or open the scan that the vessels lie in.</source>
        <comment>scan.beside-vessels</comment>
        <translation>扫描未覆盖血管。请显示整个扫描，或打开血管所在的扫描。</translation>
    </message>
    <message>
        <source>An overlay needs a vessel tree and an angiogram. Open both first.</source>
        <comment>picture.overlay-incomplete</comment>
        <translation>叠加图需要血管树和造影图像。请先打开两者。</translation>
    </message>
    <message>
        <source>A picture needs a vessel tree and an angiogram. Open both first.</source>
        <comment>picture.incomplete</comment>
        <translation>图片需要血管树和造影图像。请先打开两者。</translation>
    </message>
    <message>
        <source>it was stopped; whole objects that came are kept.</source>
        <comment>archive.stopped</comment>
        <translation>已停止；已完整收到的对象予以保留。</translation>
    </message>
    <message>
        <source>the host %1 is not known. Check its name in the list of archives, and the network.</source>
        <comment>archive.unknown-host</comment>
        <translation>主机 %1 未知。请检查归档列表中的名称和网络。</translation>
    </message>
    <message>
        <source>%1 cannot be reached (%2). Check host and port, the network, and that the archive runs.</source>
        <comment>archive.no-connection</comment>
        <translation>无法连接 %1（%2）。请检查主机、端口、网络以及归档是否在运行。</translation>
    </message>
    <message>
        <source>%1 took the connection and did not answer within %2. Check that the port is that of a DICOM archive.</source>
        <comment>archive.silent</comment>
        <translation>%1 接受了连接，但在 %2 内没有应答。请检查该端口是否属于 DICOM 归档。</translation>
    </message>
    <message>
        <source>no answer came within %1. Try again later, or allow it more “Time for an answer”; whole objects that came are kept.</source>
        <comment>archive.no-answer</comment>
        <translation>在 %1 内没有应答。请稍后再试，或延长其“应答时限”；已完整收到的对象予以保留。</translation>
    </message>
    <message>
        <source>the connection broke off (%1). Try again; whole objects that came are kept.</source>
        <comment>archive.broken</comment>
        <translation>连接中断（%1）。请再试一次；已完整收到的对象予以保留。</translation>
    </message>
    <message>
        <source>there is no AE title %1 at %2. Correct the AE title of this archive in the list of archives.</source>
        <comment>archive.unknown-title</comment>
        <translation>%2 上没有 AE 标题 %1。请在归档列表中更正该归档的 AE 标题。</translation>
    </message>
    <message>
        <source>our AE title %1 is not allowed there. Have it entered in the archive, or correct ours in the list of archives.</source>
        <comment>archive.title-not-allowed</comment>
        <translation>那里不允许我方的 AE 标题 %1。请让归档登记它，或在归档列表中更正我方标题。</translation>
    </message>
    <message>
        <source>the association was refused (%1). Ask who runs the archive whether this computer may connect.</source>
        <comment>archive.refused</comment>
        <translation>关联被拒绝（%1）。请询问归档的管理者本机是否可以连接。</translation>
    </message>
    <message>
        <source>the archive ended the association in the middle. Look into its log, or try again; whole objects that came are kept.</source>
        <comment>archive.aborted</comment>
        <translation>归档中途结束了关联。请查看其日志或再试一次；已完整收到的对象予以保留。</translation>
    </message>
    <message>
        <source>it does not offer %1. Ask who runs it to allow that for our AE title %2.</source>
        <comment>archive.no-service</comment>
        <translation>它不提供 %1。请管理者为我方 AE 标题 %2 开放。</translation>
    </message>
    <message>
        <source>%1 failed with %2. Look into the archive&apos;s log, or ask who runs it.</source>
        <comment>archive.status</comment>
        <translation>%1 失败：%2。请查看归档日志，或询问管理者。</translation>
    </message>
    <message>
        <source>its answer makes no sense (%1). Check that host, port and address are those of a DICOM archive.</source>
        <comment>archive.nonsense</comment>
        <translation>其应答没有意义（%1）。请检查主机、端口和地址是否属于 DICOM 归档。</translation>
    </message>
    <message>
        <source>no secure connection came about (%1). Check the CA file of this archive, the certificates, and whether it wants TLS at this port.</source>
        <comment>archive.tls-refused</comment>
        <translation>未能建立安全连接（%1）。请检查该归档的 CA 文件、证书，以及该端口是否要求 TLS。</translation>
    </message>
    <message>
        <source>the file %1 is of no use for TLS (%2). Check its path and content.</source>
        <comment>archive.tls-file</comment>
        <translation>文件 %1 不能用于 TLS（%2）。请检查其路径和内容。</translation>
    </message>
    <message>
        <source>its certificate is not one of the host %1. Check the host; where it is right, switch “Its certificate must be one of the host” off for this archive.</source>
        <comment>archive.tls-host</comment>
        <translation>其证书不属于主机 %1。请检查主机；如无误，请为该归档关闭“其证书必须属于该主机”。</translation>
    </message>
    <message>
        <source>it is no list of archives (%1). Correct it, or remove the file.</source>
        <comment>archive.list-invalid</comment>
        <translation>这不是归档列表（%1）。请更正或删除该文件。</translation>
    </message>
    <message>
        <source>there is no archive %1 in %2; known: %3. Add it, or correct the name.</source>
        <comment>archive.unknown</comment>
        <translation>%2 中没有归档 %1；已知：%3。请添加，或更正名称。</translation>
    </message>
    <message>
        <source>an archive has no name of 1 to 64 characters. Name it.</source>
        <comment>archive.no-name</comment>
        <translation>有归档缺少 1 至 64 个字符的名称。请命名。</translation>
    </message>
    <message>
        <source>it has neither a host nor a DICOMweb address. Give one.</source>
        <comment>archive.no-address</comment>
        <translation>它既没有主机也没有 DICOMweb 地址。请提供其一。</translation>
    </message>
    <message>
        <source>%1 is no host. Give a name or an address without port and spaces.</source>
        <comment>archive.bad-host</comment>
        <translation>%1 不是主机。请给出不含端口和空格的名称或地址。</translation>
    </message>
    <message>
        <source>the port %1 is not one of 1 to 65535. Correct it.</source>
        <comment>archive.bad-port</comment>
        <translation>端口 %1 不在 1 至 65535 之间。请更正。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no AE title. Give 1 to 16 letters, digits or signs other than the backslash.</source>
        <comment>archive.bad-title</comment>
        <translation>“%1”不是 AE 标题。请给出 1 至 16 个字母、数字或除反斜杠外的符号。</translation>
    </message>
    <message>
        <source>%1 is no DICOMweb address. Give one that begins with https:// or http://.</source>
        <comment>archive.bad-url</comment>
        <translation>%1 不是 DICOMweb 地址。请给出以 https:// 或 http:// 开头的地址。</translation>
    </message>
    <message>
        <source>the “Time for an answer” must be 1 to 600 s. Correct it.</source>
        <comment>archive.bad-time</comment>
        <translation>“应答时限”必须在 1 至 600 秒之间。请更正。</translation>
    </message>
    <message>
        <source>a certificate and its key belong together, and one is missing. Give both files.</source>
        <comment>archive.key-without-certificate</comment>
        <translation>证书和密钥须成对提供，现缺其一。请给出两个文件。</translation>
    </message>
    <message>
        <source>it has a DICOMweb address only. Give host and port too, or use DICOMweb.</source>
        <comment>archive.no-dimse</comment>
        <translation>它只有 DICOMweb 地址。请同时给出主机和端口，或使用 DICOMweb。</translation>
    </message>
    <message>
        <source>it has no DICOMweb address. Give one, or use DIMSE.</source>
        <comment>archive.no-web</comment>
        <translation>它没有 DICOMweb 地址。请给出一个，或使用 DIMSE。</translation>
    </message>
    <message>
        <source>names and images go to %1 without encryption. Use https:// or TLS where others share the network.</source>
        <comment>archive.plain-text</comment>
        <translation>姓名和图像未加密地发往 %1。网络与他人共用时请使用 https:// 或 TLS。</translation>
    </message>
    <message>
        <source>%1 is no date. Write YYYY-MM-DD, or two of them with .. between: 2024-01-01..2024-02-01.</source>
        <comment>archive.bad-date</comment>
        <translation>%1 不是日期。请写成 YYYY-MM-DD，或用 .. 连接两个日期：2024-01-01..2024-02-01。</translation>
    </message>
    <message>
        <source>there are more than %1 matches; the rest is left out. Ask for less.</source>
        <comment>archive.many-matches</comment>
        <translation>匹配项多于 %1 个；其余略去。请缩小查询范围。</translation>
    </message>
    <message>
        <source>it holds nothing of %1. Search again.</source>
        <comment>archive.nothing-there</comment>
        <translation>它没有 %1 的任何内容。请重新查询。</translation>
    </message>
    <message>
        <source>%1 is no UID. Copy it from what find prints.</source>
        <comment>archive.bad-uid</comment>
        <translation>%1 不是 UID。请从 find 的输出中复制。</translation>
    </message>
    <message>
        <source>%1 of %2 objects came, the archive did not send the others (%3). Retrieve again, or look into its log.</source>
        <comment>archive.not-all-came</comment>
        <translation>%2 个对象中收到 %1 个，其余归档没有发送（%3）。请再次获取，或查看其日志。</translation>
    </message>
    <message>
        <source>it does not offer C-GET, and C-MOVE needs a port of our own. Set its “Port for C-MOVE”, and have AE title, host and port entered in the archive.</source>
        <comment>archive.no-way-back</comment>
        <translation>它不提供 C-GET，而 C-MOVE 需要我方端口。请设置其“C-MOVE 端口”，并让归档登记 AE 标题、主机和端口。</translation>
    </message>
    <message>
        <source>port %1 cannot be listened on (%2). Choose another port, above 1024.</source>
        <comment>archive.port-taken</comment>
        <translation>无法监听端口 %1（%2）。请选择 1024 以上的其他端口。</translation>
    </message>
    <message>
        <source>an object is larger than the limit of %1 and was not kept. Raise the limit if it is wanted (--max-object).</source>
        <comment>archive.object-too-large</comment>
        <translation>有对象超过上限 %1，未予保留。如确需要请提高上限（--max-object）。</translation>
    </message>
    <message>
        <source>an object that came is no readable DICOM object, and was not kept. Look into the archive&apos;s log.</source>
        <comment>archive.object-unreadable</comment>
        <translation>收到的一个对象不是可读的 DICOM 对象，未予保留。请查看归档日志。</translation>
    </message>
    <message>
        <source>an object that came is not the one that was announced (%1), and was not kept. Look into the archive&apos;s log.</source>
        <comment>archive.object-foreign</comment>
        <translation>收到的一个对象与所通知的不符（%1），未予保留。请查看归档日志。</translation>
    </message>
    <message>
        <source>an object came whose UID (%1) is that of another one here; the earlier one is kept. Find out which is right.</source>
        <comment>archive.object-differs</comment>
        <translation>收到的对象与此处另一对象的 UID（%1）相同；保留先前的。请查明哪个正确。</translation>
    </message>
    <message>
        <source>the series does not fit into the cache of %1. Raise its limit, or empty it.</source>
        <comment>archive.cache-too-small</comment>
        <translation>该序列放不进 %1 的缓存。请提高上限，或清空缓存。</translation>
    </message>
    <message>
        <source>the folder cannot be made or used (%1). Choose another one, or make room.</source>
        <comment>archive.no-folder</comment>
        <translation>无法创建或使用该文件夹（%1）。请选择其他文件夹，或腾出空间。</translation>
    </message>
    <message>
        <source>it is no whole DICOM file with its transfer syntax, and was not sent. Write it anew, or choose another.</source>
        <comment>archive.not-sendable</comment>
        <translation>这不是带有传输语法的完整 DICOM 文件，未发送。请重新写出，或选择其他文件。</translation>
    </message>
    <message>
        <source>the archive does not take objects of its kind as they are stored (class %1, transfer syntax %2). Convert it, or ask who runs the archive.</source>
        <comment>archive.not-taken</comment>
        <translation>归档不接受以所存形式发送的此类对象（类 %1，传输语法 %2）。请转换它，或询问归档的管理者。</translation>
    </message>
    <message>
        <source>the archive refused it with %1. Look into its log, or ask who runs it.</source>
        <comment>archive.store-refused</comment>
        <translation>归档以 %1 拒绝了它。请查看其日志，或询问管理者。</translation>
    </message>
    <message>
        <source>%1 was answered with HTTP status %2. Check the DICOMweb address, or ask who runs the archive.</source>
        <comment>archive.http-status</comment>
        <translation>%1 的应答为 HTTP 状态 %2。请检查 DICOMweb 地址，或询问归档的管理者。</translation>
    </message>
    <message>
        <source>access was refused (HTTP status %1). Check the client certificate or the authorization file of this archive.</source>
        <comment>archive.http-forbidden</comment>
        <translation>访问被拒绝（HTTP 状态 %1）。请检查该归档的客户端证书或授权文件。</translation>
    </message>
    <message>
        <source>its answer is larger than %1. Ask for less.</source>
        <comment>archive.http-too-large</comment>
        <translation>其应答大于 %1。请缩小查询范围。</translation>
    </message>
    <message>
        <source>%1 (AE title %2) was turned away: it is not on the list of those that may call.</source>
        <comment>archive.title-turned-away</comment>
        <translation>%1（AE 标题 %2）被拒绝：不在允许呼叫的名单上。</translation>
    </message>
    <message>
        <source>%1 (AE title %2) was turned away: it called %3, which is not our AE title. Correct it there.</source>
        <comment>archive.called-otherwise</comment>
        <translation>%1（AE 标题 %2）被拒绝：它呼叫的 %3 不是我方 AE 标题。请在对方更正。</translation>
    </message>
    <message>
        <source>a call to the port came to nothing (%1). Look at the caller: address, port, whether it uses TLS.</source>
        <comment>archive.call-failed</comment>
        <translation>对端口的一次呼叫未能成立（%1）。请检查呼叫方：地址、端口、是否使用 TLS。</translation>
    </message>
    <message>
        <source>a caller was turned away: no secure connection came about (%1). Check its certificate, those trusted here, and whether it uses TLS.</source>
        <comment>archive.call-not-secured</comment>
        <translation>一个呼叫方被拒绝：未能建立安全连接（%1）。请检查其证书、此处信任的证书，以及它是否使用 TLS。</translation>
    </message>
    <message>
        <source>TLS at a port needs a certificate of ours and its key. Give both files.</source>
        <comment>archive.port-unsecured</comment>
        <translation>端口上的 TLS 需要我方证书及其密钥。请给出两个文件。</translation>
    </message>
    <message>
        <source>%1 does not exist. Check the name, or whether its drive is mounted.</source>
        <comment>open.missing</comment>
        <translation>%1 不存在。请检查名称或驱动器是否挂载。</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2. Check its permissions.</source>
        <comment>open.unreadable</comment>
        <translation>无法读取 %1：%2。请检查权限。</translation>
    </message>
    <message>
        <source>%1 is empty. Copy the file again from where it came from.</source>
        <comment>open.empty</comment>
        <translation>%1 为空。请从来源重新复制。</translation>
    </message>
    <message>
        <source>%1 is not a file that AngioPose opens. Open a case (.angiopose), a centreline (VTP, VTK, CSV, SWC), a CT scan (DICOM folder, NIfTI, NRRD, MetaImage), a surface (STL, PLY, OBJ) or an angiogram (DICOM, PNG, TIFF).</source>
        <comment>open.unknown</comment>
        <translation>AngioPose 无法打开 %1。请打开病例（.angiopose）、中心线（VTP、VTK、CSV、SWC）、CT 扫描（DICOM 文件夹、NIfTI、NRRD、MetaImage）、表面（STL、PLY、OBJ）或造影图像（DICOM、PNG、TIFF）。</translation>
    </message>
    <message>
        <source>%1 is a case. Open it alone, without other files.</source>
        <comment>open.case-alone</comment>
        <translation>%1 是病例。请单独打开，不要与其他文件一起。</translation>
    </message>
    <message>
        <source>%1 is a second vessel tree. Open one vessel tree at a time.</source>
        <comment>open.second-tree</comment>
        <translation>%1 是第二个血管树。一次只能打开一个血管树。</translation>
    </message>
    <message>
        <source>%1 is a second 2-D centreline. Open one 2-D centreline at a time.</source>
        <comment>open.second-centreline</comment>
        <translation>%1 是第二条二维中心线。一次只能打开一条二维中心线。</translation>
    </message>
    <message>
        <source>%1 is a second angiogram. Open one at a time; others join it as views.</source>
        <comment>open.second-angiogram</comment>
        <translation>%1 是第二个血管造影。一次只能打开一个；其余的可作为视图加入。</translation>
    </message>
    <message>
        <source>%1 has moved and was found as %2. Save the case to remember.</source>
        <comment>open.moved</comment>
        <translation>%1 已移动，找到为 %2。保存病例以记住。</translation>
    </message>
    <message>
        <source>this is no angiogram. Choose an XA image, or a case with one.</source>
        <comment>open.no-angiogram</comment>
        <translation>这不是血管造影。请选择 XA 图像，或含有血管造影的病例。</translation>
    </message>
    <message>
        <source>none of its %1 series can be opened. %2</source>
        <comment>open.no-series</comment>
        <translation>其中的 %1 个序列都无法打开。%2</translation>
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
        <source>before: at the start pose</source>
        <comment>picture.before</comment>
        <translation>之前：初始位姿</translation>
    </message>
    <message>
        <source>after: at this pose</source>
        <comment>picture.after</comment>
        <translation>之后：此位姿</translation>
    </message>
    <message>
        <source>%1 · median %2</source>
        <comment>picture.pose</comment>
        <translation>%1 · 中位数 %2</translation>
    </message>
    <message>
        <source>%1 · median %2 · not trustworthy</source>
        <comment>picture.pose-not-trustworthy</comment>
        <translation>%1 · 中位数 %2 · 不可信</translation>
    </message>
    <message>
        <source>moved, mm</source>
        <comment>picture.motion-scale</comment>
        <translation>位移，mm</translation>
    </message>
    <message>
        <source>bent on frame %1, another one</source>
        <comment>picture.bent-on-frame</comment>
        <translation>弯曲取自第 %1 帧，而非此帧</translation>
    </message>
    <message>
        <source>bend along the ray: not told</source>
        <comment>picture.bent-depth-untold</comment>
        <translation>沿射线的弯曲：未知</translation>
    </message>
    <message>
        <source>rigid: %1</source>
        <comment>picture.of-rigid-vessels</comment>
        <translation>刚性：%1</translation>
    </message>
    <message>
        <source>vessels rigid; bent ones are known</source>
        <comment>picture.vessels-rigid</comment>
        <translation>血管为刚性；弯曲血管已知</translation>
    </message>
    <message>
        <source>vessels bent by up to %1, not sure</source>
        <comment>picture.vessels-bent-unsure</comment>
        <translation>血管弯曲，最多 %1，不确定</translation>
    </message>
    <message>
        <source>vessels bent by up to %1</source>
        <comment>picture.vessels-bent</comment>
        <translation>血管弯曲，最多 %1</translation>
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
        <source>user</source>
        <comment>origin.user</comment>
        <translation>用户</translation>
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
        <source>The simulation&apos;s %1 must lie between %2 and %3, not %4.</source>
        <comment>simulation.out-of-range</comment>
        <translation>模拟的 %1 须在 %2 至 %3 之间，不能是 %4。</translation>
    </message>
    <message>
        <source>Method &apos;%1&apos; has no option with the choice &apos;%2&apos;. Write it as option=value.</source>
        <comment>contest.no-such-choice</comment>
        <translation>方法“%1”没有可取“%2”的选项。请写成 option=value。</translation>
    </message>
    <message>
        <source>Method &apos;%1&apos; has more than one option with the choice &apos;%2&apos;. Write it as option=value.</source>
        <comment>contest.choice-of-several</comment>
        <translation>方法“%1”有多个可取“%2”的选项。请写成 option=value。</translation>
    </message>
    <message>
        <source>No method is named. See the methods in: angiopose-cli evaluate --help</source>
        <comment>contest.no-method-named</comment>
        <translation>没有指定方法。可用方法见：angiopose-cli evaluate --help</translation>
    </message>
    <message>
        <source>The experiment &apos;%1&apos; has no condition &apos;%2&apos;. See the conditions in: angiopose-cli evaluate --help</source>
        <comment>experiment.no-such-condition</comment>
        <translation>实验“%1”没有条件“%2”。可用条件见：angiopose-cli evaluate --help</translation>
    </message>
    <message>
        <source>The condition &apos;%1&apos; is not one of &apos;%2&apos;. Merge runs of this program&apos;s version.</source>
        <comment>merge.foreign-condition</comment>
        <translation>条件“%1”不属于“%2”。请合并本程序版本的运行结果。</translation>
    </message>
    <message>
        <source>Two parts disagree about %1 in trial %2 of %3. Merge runs of the same program and settings.</source>
        <comment>merge.parts-disagree</comment>
        <translation>两部分关于 %1 在 %3 的第 %2 次试验不一致。请合并同一程序和相同设置的运行结果。</translation>
    </message>
    <message>
        <source>There are no runs to merge.</source>
        <comment>merge.nothing</comment>
        <translation>没有可合并的运行结果。</translation>
    </message>
    <message>
        <source>Runs of &apos;%1&apos;, seed %2, and of &apos;%3&apos;, seed %4, do not belong together. Merge parts of one experiment.</source>
        <comment>merge.runs-of-others</comment>
        <translation>“%1”（种子 %2）与“%3”（种子 %4）的运行结果不属于同一实验。请合并同一实验的各部分。</translation>
    </message>
    <message>
        <source>The focal lengths fx and fy must be finite and not zero.</source>
        <comment>camera.focal-lengths</comment>
        <translation>焦距 fx 和 fy 必须有限且非零。</translation>
    </message>
    <message>
        <source>The principal point cx, cy must be finite.</source>
        <comment>camera.principal-point</comment>
        <translation>主点 cx、cy 必须有限。</translation>
    </message>
    <message>
        <source>The camera needs the image size: width and height must be positive.</source>
        <comment>camera.image-size</comment>
        <translation>相机需要图像尺寸：宽和高必须为正。</translation>
    </message>
    <message>
        <source>The camera is for images of %1 x %2 pixels, the angiogram has %3 x %4. Use the camera that belongs to the angiogram.</source>
        <comment>camera.other-image</comment>
        <translation>相机对应 %1 x %2 像素的图像，而造影图像为 %3 x %4。请使用该造影图像对应的相机。</translation>
    </message>
    <message>
        <source>The picture must be 1 to %1 px wide and high; choose another size.</source>
        <comment>picture.size</comment>
        <translation>图片的宽和高须为 1 至 %1 px；请选择其他尺寸。</translation>
    </message>
    <message>
        <source>%1 is missing or not positive. Add it to the geometry of the C-arm (the image header does not tell).</source>
        <comment>geometry.value-missing</comment>
        <translation>%1 缺失或不为正。请补入 C 形臂几何（图像头未给出）。</translation>
    </message>
    <message>
        <source>The distance source to detector (SID)</source>
        <comment>geometry.the-sid</comment>
        <translation>源到探测器距离（SID）</translation>
    </message>
    <message>
        <source>The distance source to patient (SOD)</source>
        <comment>geometry.the-sod</comment>
        <translation>源到患者距离（SOD）</translation>
    </message>
    <message>
        <source>The detector pixel spacing</source>
        <comment>geometry.the-spacing</comment>
        <translation>探测器像素间距</translation>
    </message>
    <message>
        <source>The positioner angles (LAO/RAO, CRA/CAU) are missing or not finite. Add them to the geometry of the C-arm.</source>
        <comment>geometry.angles-missing</comment>
        <translation>投照角度（LAO/RAO、CRA/CAU）缺失或非有限数。请补入 C 形臂几何。</translation>
    </message>
    <message>
        <source>The isocentre has a coordinate that is not a number (NaN or infinite). Give its place in the patient in mm.</source>
        <comment>geometry.isocentre-not-finite</comment>
        <translation>等中心有非数值坐标（NaN 或无穷大）。请以 mm 给出其在患者中的位置。</translation>
    </message>
    <message>
        <source>Source to detector distance (SID): type it, usually 900 to 1200 mm.</source>
        <comment>geometry.ask-sid</comment>
        <translation>源到探测器距离（SID）：请输入，通常 900 至 1200 mm。</translation>
    </message>
    <message>
        <source>Source to isocentre distance (SOD): type it, usually 700 to 800 mm.</source>
        <comment>geometry.ask-sod</comment>
        <translation>源到等中心距离（SOD）：请输入，通常 700 至 800 mm。</translation>
    </message>
    <message>
        <source>Detector pixel spacing: type it, or the width of the field of view on the detector divided by the columns.</source>
        <comment>geometry.ask-spacing</comment>
        <translation>探测器像素间距：请输入，或用探测器上视野宽度除以列数。</translation>
    </message>
    <message>
        <source>LAO/RAO angle: type it, or place the vessels by landmarks.</source>
        <comment>geometry.ask-primary-angle</comment>
        <translation>LAO/RAO 角：请输入，或按标志点放置血管。</translation>
    </message>
    <message>
        <source>CRA/CAU angle: type it, or place the vessels by landmarks.</source>
        <comment>geometry.ask-secondary-angle</comment>
        <translation>CRA/CAU 角：请输入，或按标志点放置血管。</translation>
    </message>
    <message>
        <source>A source to detector distance (SID) of %1 is unlike a C-arm (500 to 2000 mm): check its unit.</source>
        <comment>geometry.sid-unusual</comment>
        <translation>源到探测器距离（SID）%1 不像 C 形臂（500 至 2000 mm）：请检查单位。</translation>
    </message>
    <message>
        <source>SOD (%1) is not smaller than SID (%2): the patient would lie behind the detector. Correct one of them.</source>
        <comment>geometry.sod-beyond-sid</comment>
        <translation>SOD（%1）不小于 SID（%2）：患者将位于探测器之后。请更正其一。</translation>
    </message>
    <message>
        <source>SID is %1 times SOD; angiograms are magnified 1.0 to 2.5 times. Check both distances.</source>
        <comment>geometry.magnification-unusual</comment>
        <translation>SID 为 SOD 的 %1 倍；造影放大率为 1.0 至 2.5。请检查两个距离。</translation>
    </message>
    <message>
        <source>The header&apos;s magnification of %1 (0018,1114) is not SID/SOD = %2: one of the three is stale. Check SID and SOD.</source>
        <comment>geometry.magnification-stale</comment>
        <translation>文件头中的放大倍数 %1 (0018,1114) 与 SID/SOD = %2 不符：三者之一已过时。请检查 SID 和 SOD。</translation>
    </message>
    <message>
        <source>A detector pixel spacing of %1 lies outside 0.05 to 2 mm: check its unit.</source>
        <comment>geometry.spacing-unusual</comment>
        <translation>探测器像素间距 %1 不在 0.05 至 2 mm 之间：请检查单位。</translation>
    </message>
    <message>
        <source>Pixels are %1 times as high as wide by their spacing, %2 times by the pixel aspect: check the pixel spacing.</source>
        <comment>geometry.aspect-differs</comment>
        <translation>按间距像素高为宽的 %1 倍，按像素长宽比为 %2 倍：请检查像素间距。</translation>
    </message>
    <message>
        <source>The image covers %1 x %2 of the detector by its pixel spacing</source>
        <comment>geometry.image-covers</comment>
        <translation>按像素间距图像覆盖探测器 %1 x %2</translation>
    </message>
    <message>
        <source>%1: no detector of a C-arm is like that. Check the pixel spacing.</source>
        <comment>geometry.extent-unlike-detector</comment>
        <translation>%1：C 形臂没有这样的探测器。请检查像素间距。</translation>
    </message>
    <message>
        <source>%1, the field of view is %2 x %3: the image may be zoomed, cropped or resampled. Check the pixel spacing.</source>
        <comment>geometry.extent-unlike-field</comment>
        <translation>%1，视野为 %2 x %3：图像可能经过缩放、裁剪或重采样。请检查像素间距。</translation>
    </message>
    <message>
        <source>%1, more than the intensifier of %2. Check the pixel spacing.</source>
        <comment>geometry.extent-beyond-intensifier</comment>
        <translation>%1，超过 %2 的影像增强器。请检查像素间距。</translation>
    </message>
    <message>
        <source>%1, more than its active %2 x %3. Check the pixel spacing.</source>
        <comment>geometry.extent-beyond-detector</comment>
        <translation>%1，超过有效范围 %2 x %3。请检查像素间距。</translation>
    </message>
    <message>
        <source>The calibrated pixel spacing of %1 times SID/SOD is %2, not the detector&apos;s %3: the calibration or a distance is off.</source>
        <comment>geometry.calibration-off</comment>
        <translation>校准像素间距 %1 乘以 SID/SOD 为 %2，而非探测器的 %3：校准或距离有误。</translation>
    </message>
    <message>
        <source>Pixel Spacing (0028,0030) says %1 without a calibration, the detector&apos;s pixels are %2: check which is meant.</source>
        <comment>geometry.spacings-differ</comment>
        <translation>Pixel Spacing (0028,0030) 未校准为 %1，探测器像素为 %2：请核对。</translation>
    </message>
    <message>
        <source>The primary angle (LAO/RAO) lies outside ±180°. Correct it.</source>
        <comment>geometry.primary-angle-outside</comment>
        <translation>主角度（LAO/RAO）超出 ±180°。请更正。</translation>
    </message>
    <message>
        <source>The secondary angle (CRA/CAU) lies outside ±90°. Correct it.</source>
        <comment>geometry.secondary-angle-outside</comment>
        <translation>次角度（CRA/CAU）超出 ±90°。请更正。</translation>
    </message>
    <message>
        <source>The roll lies outside ±180°. Correct it.</source>
        <comment>geometry.roll-outside</comment>
        <translation>滚转超出 ±180°。请更正。</translation>
    </message>
    <message>
        <source>The principal point (%1, %2) lies outside the image: right for a cropped image only.</source>
        <comment>geometry.principal-point-outside</comment>
        <translation>主点（%1，%2）在图像之外：仅对裁剪图像正确。</translation>
    </message>
    <message>
        <source>Two of the angiograms seem to be of different patients (%1 differs). Check that they are the right ones.</source>
        <comment>patient.of-runs-differs</comment>
        <translation>其中两个血管造影似乎来自不同患者（%1不同）。请检查是否正确。</translation>
    </message>
    <message>
        <source>Two of the angiograms seem to be of different patients (%1 differ). Check that they are the right ones.</source>
        <comment>patient.of-runs-differs-in-several</comment>
        <translation>其中两个血管造影似乎来自不同患者（%1不同）。请检查是否正确。</translation>
    </message>
    <message>
        <source>Two of the angiograms are of opposite sides of the patient. Check that they are the right ones.</source>
        <comment>patient.side-of-runs-differs</comment>
        <translation>其中两个血管造影是患者相反的两侧。请检查是否正确。</translation>
    </message>
    <message>
        <source>The run that found this pose did not trust it.</source>
        <comment>pose.run-distrusted</comment>
        <translation>找到此位姿的运行并不信任它。</translation>
    </message>
    <message>
        <source>Not the same patient in all images?</source>
        <comment>picture.not-same-patient</comment>
        <translation>所有图像是否同一患者？</translation>
    </message>
    <message>
        <source>Two of the angiograms are of different examinations (accession number differs): the vessels may have moved between them.</source>
        <comment>patient.examination-of-runs-differs</comment>
        <translation>两幅造影来自不同的检查（检查号不同）：其间血管可能已移动。</translation>
    </message>
    <message>
        <source>Do these images belong together?</source>
        <comment>picture.not-together</comment>
        <translation>这些图像属于同一检查吗？</translation>
    </message>
    <message>
        <source>Scan and angiogram seem to be of different patients (%1 differs). Check that both are the right ones.</source>
        <comment>patient.differs</comment>
        <translation>扫描与血管造影似乎来自不同患者（%1不同）。请检查两者是否正确。</translation>
    </message>
    <message>
        <source>Scan and angiogram seem to be of different patients (%1 differ). Check that both are the right ones.</source>
        <comment>patient.differs-in-several</comment>
        <translation>扫描与血管造影似乎来自不同患者（%1不同）。请检查两者是否正确。</translation>
    </message>
    <message>
        <source>number</source>
        <comment>patient.number</comment>
        <translation>编号</translation>
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
        <source>The scan is of the patient&apos;s %1 side, the angiogram of the other. Check that both are the right ones.</source>
        <comment>patient.side-differs</comment>
        <translation>CT 为患者%1侧，造影为另一侧。请核对。</translation>
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
        <source>There is no angiogram yet. Give an image first.</source>
        <comment>case.no-angiogram</comment>
        <translation>尚无造影图像。请先给出图像。</translation>
    </message>
    <message>
        <source>There is no vessel tree yet. Give a centreline first.</source>
        <comment>case.no-vessel-tree</comment>
        <translation>尚无血管树。请先给出中心线。</translation>
    </message>
    <message>
        <source>All six degrees of freedom are locked: nothing is left to find. Unlock at least one.</source>
        <comment>options.all-locked</comment>
        <translation>六个自由度均已锁定：无可求解。请至少解锁一个。</translation>
    </message>
    <message>
        <source>%1 solves for all six degrees of freedom at once and cannot keep one. Unlock them, or choose another method.</source>
        <comment>options.method-cannot-lock</comment>
        <translation>%1 同时求解全部六个自由度，无法固定其中之一。请解锁或选择其他方法。</translation>
    </message>
    <message>
        <source>There is no method &apos;%1&apos;. Choose one of: %2.</source>
        <comment>options.no-such-method</comment>
        <translation>没有方法“%1”。可选：%2。</translation>
    </message>
    <message>
        <source>The option %1 is out of range. Give a number from %2 to %3.</source>
        <comment>options.out-of-range</comment>
        <translation>选项 %1 超出范围。请给出 %2 至 %3 之间的数。</translation>
    </message>
    <message>
        <source>Option &apos;%1&apos; needs a value, not &apos;%2&apos;.</source>
        <comment>options.needs-value</comment>
        <translation>选项“%1”需要一个值，而不是“%2”。</translation>
    </message>
    <message>
        <source>Option &apos;%1&apos; must be one of %2, not &apos;%3&apos;.</source>
        <comment>options.needs-choice</comment>
        <translation>选项“%1”须为 %2 之一，不能是“%3”。</translation>
    </message>
    <message>
        <source>Option &apos;%1&apos; must be a whole number, not %2.</source>
        <comment>options.needs-whole-number</comment>
        <translation>选项“%1”须为整数，不能是 %2。</translation>
    </message>
    <message>
        <source>Option &apos;%1&apos; must lie between %2 and %3, not %4.</source>
        <comment>options.value-out-of-range</comment>
        <translation>选项“%1”须在 %2 与 %3 之间，而不是 %4。</translation>
    </message>
    <message>
        <source>Option &apos;%1&apos; is unknown. See the options in: angiopose-cli register --help</source>
        <comment>options.no-such-option</comment>
        <translation>选项“%1”未知。可用选项见：angiopose-cli register --help</translation>
    </message>
    <message>
        <source>Branch %1 is chosen as %2 but the vessel tree has no such branch. Choose among its branches.</source>
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
        <source>The image is not of the size that the camera takes. Use the camera that belongs to the image.</source>
        <comment>input.image-not-of-camera</comment>
        <translation>图像尺寸与相机不符。请使用该图像对应的相机。</translation>
    </message>
    <message>
        <source>%1 points of the traced vessels came in no order: each was joined to its neighbours.</source>
        <comment>input.target-reordered</comment>
        <translation>描迹血管的 %1 个点没有顺序：每个点已与其相邻点相连。</translation>
    </message>
    <message>
        <source>The chosen branches lie %1 from the traced vessels at the median; in the fit of all branches it was %2. Choosing them turned the pose by %3 and shifted it by %4.</source>
        <comment>result.chosen-branches-fitted</comment>
        <translation>所选分支与所描血管距离的中位数为 %1；全部分支的拟合中为 %2。此选择使位姿旋转 %3、平移 %4。</translation>
    </message>
    <message>
        <source>Where they may leave the rigid pose, the vessels move by %1 (rms; %2 at most) towards the matched branches: the median distance becomes %3, with the rigid pose it is %4. The pose is the rigid one.</source>
        <comment>result.matched-branches-moved</comment>
        <translation>若允许离开刚性位姿，血管向所匹配的分支移动 %1（rms；最大 %2）：距离中位数变为 %3，刚性位姿时为 %4。位姿仍为刚性位姿。</translation>
    </message>
    <message>
        <source>The start pose is not a rigid motion: its rotation must be orthonormal with determinant +1 and all numbers finite. Correct cameraFromPatient or derive the start pose from the angles.</source>
        <comment>input.start-pose-not-rigid</comment>
        <translation>初始位姿不是刚体变换：旋转须正交且行列式为 +1，所有数有限。请更正 cameraFromPatient 或由角度推导初始位姿。</translation>
    </message>
    <message>
        <source>The start pose puts vessels at or behind the X-ray source, where nothing projects. Check the source-to-patient distance and the direction of the start pose.</source>
        <comment>input.start-pose-behind-source</comment>
        <translation>起始位姿使血管位于 X 射线源处或其后方，无法投影。请检查源到患者距离和起始位姿的方向。</translation>
    </message>
    <message>
        <source>The pose to judge is not a rigid motion: its rotation must be orthonormal with determinant +1 and all numbers finite.</source>
        <comment>input.judged-pose-not-rigid</comment>
        <translation>待评估位姿不是刚体变换：旋转须正交且行列式为 +1，所有数有限。</translation>
    </message>
    <message>
        <source>There are no landmarks yet. Click a place on the vessels and the same place in the image.</source>
        <comment>landmarks.missing</comment>
        <translation>尚无标志点。请单击血管上的位置和图像中的同一位置。</translation>
    </message>
    <message>
        <source>Without angles a pose needs four landmarks; there are %1. Add landmarks, or type the angles: then one is enough.</source>
        <comment>landmarks.too-few</comment>
        <translation>没有角度时需要四个标志点；现有 %1 个。请添加，或输入角度：此时一个即可。</translation>
    </message>
    <message>
        <source>A landmark is not a finite number. Remove it.</source>
        <comment>landmarks.not-finite</comment>
        <translation>有标志点不是有限数。请移除。</translation>
    </message>
    <message>
        <source>The landmarks all lie in one place. Choose some farther apart.</source>
        <comment>landmarks.in-one-place</comment>
        <translation>标志点都在同一处。请选择相距较远的。</translation>
    </message>
    <message>
        <source>The landmarks lie on one line, so the turn about it stays open. Add one off that line.</source>
        <comment>landmarks.on-one-line</comment>
        <translation>标志点共线，绕该线的旋转无法确定。请添加线外一点。</translation>
    </message>
    <message>
        <source>No pose lays these landmarks onto their pixels. Check that each pair shows the same place.</source>
        <comment>landmarks.no-pose</comment>
        <translation>没有位姿能使这些标志点落到其像素上。请检查每对是否为同一位置。</translation>
    </message>
    <message>
        <source>View %1: %2</source>
        <comment>views.in-view</comment>
        <translation>视图 %1：%2</translation>
    </message>
    <message>
        <source>A joint registration needs at least two views.</source>
        <comment>views.too-few</comment>
        <translation>联合配准至少需要两个投影。</translation>
    </message>
    <message>
        <source>A joint registration cannot keep single degrees of freedom. Unlock them first.</source>
        <comment>views.cannot-lock</comment>
        <translation>联合配准无法固定单个自由度。请先解锁。</translation>
    </message>
    <message>
        <source>View %1 uses another vessel tree or other branches than view %2. Give all views the same.</source>
        <comment>views.other-tree</comment>
        <translation>投影 %1 使用的血管树或分支与投影 %2 不同。请统一。</translation>
    </message>
    <message>
        <source>View %1 does not agree with the joint pose.</source>
        <comment>views.disagrees</comment>
        <translation>投影 %1 与联合位姿不符。</translation>
    </message>
    <message>
        <source>The geometry of view %1 is far from its header: check angles and distances.</source>
        <comment>views.far-from-header</comment>
        <translation>投影 %1 的几何与文件头相差很大：请检查角度和距离。</translation>
    </message>
    <message>
        <source>There is only one frame: nothing to follow. Open a run of several frames.</source>
        <comment>follow.one-frame</comment>
        <translation>只有一帧：无可跟踪。请打开多帧序列。</translation>
    </message>
    <message>
        <source>The vessels of this frame are given by a file, those of the others are not. Take the given centreline out of the case to trace every frame.</source>
        <comment>follow.given-target</comment>
        <translation>此帧血管由文件给定，其他帧没有。请从病例中移除给定中心线以提取每一帧。</translation>
    </message>
    <message>
        <source>The gantry turns during this run: frames show other views, not only motion. Register the frames one by one, or as views together.</source>
        <comment>follow.gantry-turns</comment>
        <translation>采集中机架旋转：各帧为不同投影而非仅有运动。请逐帧配准，或作为多投影联合配准。</translation>
    </message>
    <message>
        <source>Only %1 of the vessel tree lies inside the image.</source>
        <comment>trust.outside-image</comment>
        <translation>血管树仅 %1 位于图像内。</translation>
    </message>
    <message>
        <source>Only %1 of the vessel tree lies on a traced vessel, and it explains %2 of the traced vessels.</source>
        <comment>trust.little-agreement</comment>
        <translation>血管树仅 %1 落在提取血管上，解释了提取血管的 %2。</translation>
    </message>
    <message>
        <source>The vessel tree explains only %1 of the traced vessels. Check that it belongs to the image and that its lengths are mm.</source>
        <comment>trust.little-explained</comment>
        <translation>血管树仅能解释 %1 的已识别血管。请检查它是否属于该图像，且长度单位为 mm。</translation>
    </message>
    <message>
        <source>The vessels fit better %1 aside.</source>
        <comment>trust.better-aside</comment>
        <translation>血管偏移 %1 处吻合更好。</translation>
    </message>
    <message>
        <source>The image hardly tells how the vessels are tilted out of the image plane.</source>
        <comment>trust.out-of-plane-uncertain</comment>
        <translation>图像几乎无法确定血管在平面外的倾斜。</translation>
    </message>
    <message>
        <source>The image hardly tells how the vessels are turned in the image plane.</source>
        <comment>trust.in-plane-turn-uncertain</comment>
        <translation>图像几乎无法确定血管在平面内的旋转。</translation>
    </message>
    <message>
        <source>The image hardly tells where along the vessels the tree lies.</source>
        <comment>trust.shift-uncertain</comment>
        <translation>图像几乎无法确定血管树沿血管方向的位置。</translation>
    </message>
    <message>
        <source>The image leaves the pose uncertain by about %1.</source>
        <comment>trust.pose-uncertain</comment>
        <translation>图像使位姿仍有约 %1 的不确定。</translation>
    </message>
    <message>
        <source>Another pose explains the image nearly as well: compare the alternatives.</source>
        <comment>trust.rival</comment>
        <translation>另一位姿几乎同样符合图像：请比较其他解。</translation>
    </message>
    <message>
        <source>Fits that look like this one lie within 2 mm of the vessels in %1 of cases only.</source>
        <comment>trust.often-fails</comment>
        <translation>与此相似的配准中，只有 %1 落在血管 2 mm 以内。</translation>
    </message>
    <message>
        <source>The registration was stopped before its end.</source>
        <comment>trust.stopped</comment>
        <translation>配准在结束前被停止。</translation>
    </message>
    <message>
        <source>The image shows %1 of the vessel tree. These branches seem not to be filled: %2. The pose rests on the others.</source>
        <comment>trust.part-filled</comment>
        <translation>图像显示了血管树的 %1。以下分支似乎未充盈：%2。位姿依据其余分支。</translation>
    </message>
    <message>
        <source>The image shows %1 of the vessel tree: %2 of %3 branches seem not to be filled. The pose rests on the others.</source>
        <comment>trust.few-filled</comment>
        <translation>图像显示了血管树的 %1：%3 个分支中有 %2 个似乎未充盈。位姿依据其余分支。</translation>
    </message>
    <message>
        <source>The image shows %1 of the vessel tree, and of no branch the greater part. The pose rests on the pieces that it shows.</source>
        <comment>trust.pieces-filled</comment>
        <translation>图像显示血管树的 %1，且没有任何分支的大部分可见。位姿依据其显示的片段。</translation>
    </message>
    <message>
        <source>Only a part of the vessel tree seems to be filled, and it explains the image too little to be sure of it.</source>
        <comment>trust.filled-doubtful</comment>
        <translation>似乎只有部分血管树充盈，而它对图像的解释不足以确定位姿。</translation>
    </message>
    <message>
        <source>Only one path of the vessels is seen. It fits in many places, and a wire or catheter lies beside its axis: the method for wires ranks its ways.</source>
        <comment>trust.single-path</comment>
        <translation>只见血管的一条路径。它与多处相符，而且导丝或导管偏离血管轴线：导丝方法会给出各路径的排序。</translation>
    </message>
    <message>
        <source>One view does not tell the depth here: the distance from the source stays close to the start pose.</source>
        <comment>trust.depth-unknown</comment>
        <translation>单一投影无法确定深度：到射线源的距离保持接近初始位姿。</translation>
    </message>
    <message>
        <source>One view does not tell the depth here: the distance from the source is %1 off the start pose and may be wrong. Lock the depth, or add a view.</source>
        <comment>trust.depth-moved</comment>
        <translation>单一投影无法确定深度：到射线源的距离偏离初始位姿 %1，可能有误。请锁定深度，或增加一个投照视图。</translation>
    </message>
    <message>
        <source>The vessels fit clearly better with a focal length %1 longer. Check the distance from source to detector (perhaps larger) and the pixel spacing (perhaps smaller). The option “Estimate the geometry” takes over what the images show.</source>
        <comment>camera.focal-longer</comment>
        <translation>焦距增大 %1 时血管明显更吻合。请检查源到探测器的距离（可能更大）和像素间距（可能更小）。选项“估计几何参数”会采用图像所显示的值。</translation>
    </message>
    <message>
        <source>The vessels fit clearly better with a focal length %1 shorter. Check the distance from source to detector (perhaps smaller) and the pixel spacing (perhaps larger). The option “Estimate the geometry” takes over what the images show.</source>
        <comment>camera.focal-shorter</comment>
        <translation>焦距减小 %1 时血管明显更吻合。请检查源到探测器的距离（可能更小）和像素间距（可能更大）。选项“估计几何参数”会采用图像所显示的值。</translation>
    </message>
    <message>
        <source>The images contradicted the geometry and it was estimated from them: the focal length is %1 of the given one, the principal point lies (%2, %3) px beside it.</source>
        <comment>camera.estimated</comment>
        <translation>图像与几何参数不符，已据图像重新估计：焦距为给定值的 %1，主点偏移 (%2, %3) px。</translation>
    </message>
    <message>
        <source>The vessels fit clearly better with the principal point %1 aside, at (%2, %3). Check it, and whether the image was cropped or shifted.</source>
        <comment>camera.principal-point-off</comment>
        <translation>主点偏移 %1、位于 (%2, %3) 时血管明显更吻合。请检查主点，以及图像是否被裁剪或平移。</translation>
    </message>
    <message>
        <source>The image looks turned clockwise by 90°: turned back, %1 of vessels and image agree, as it is %2. Check how it was exported, or the roll.</source>
        <comment>frame.turned-clockwise</comment>
        <translation>图像似乎顺时针旋转了 90°：转回后血管与图像吻合 %1，现状为 %2。请检查其导出方式或滚转角。</translation>
    </message>
    <message>
        <source>The image looks turned anticlockwise by 90°: turned back, %1 of vessels and image agree, as it is %2. Check how it was exported, or the roll.</source>
        <comment>frame.turned-anticlockwise</comment>
        <translation>图像似乎逆时针旋转了 90°：转回后血管与图像吻合 %1，现状为 %2。请检查其导出方式或滚转角。</translation>
    </message>
    <message>
        <source>The image looks turned by 180°: turned back, %1 of vessels and image agree, as it is %2. Check how it was exported, the roll, and the patient&apos;s position.</source>
        <comment>frame.upside-down</comment>
        <translation>图像似乎旋转了 180°：转回后血管与图像吻合 %1，现状为 %2。请检查其导出方式、滚转角和患者体位。</translation>
    </message>
    <message>
        <source>The image looks mirrored left to right: mirrored back, %1 of vessels and image agree, as it is %2. Check in the geometry from which side it is shown.</source>
        <comment>frame.mirrored-left-right</comment>
        <translation>图像似乎左右镜像：镜像还原后血管与图像吻合 %1，现状为 %2。请在几何设置中检查从哪一侧显示。</translation>
    </message>
    <message>
        <source>The image looks mirrored up to down: mirrored back, %1 of vessels and image agree, as it is %2. Check how it was exported.</source>
        <comment>frame.mirrored-up-down</comment>
        <translation>图像似乎上下镜像：镜像还原后血管与图像吻合 %1，现状为 %2。请检查其导出方式。</translation>
    </message>
    <message>
        <source>The image looks mirrored and turned by 90°: put right, %1 of vessels and image agree, as it is %2. Check how it was exported.</source>
        <comment>frame.mirrored-and-turned</comment>
        <translation>图像似乎既镜像又旋转了 90°：校正后血管与图像吻合 %1，现状为 %2。请检查其导出方式。</translation>
    </message>
    <message>
        <source>The patient lay %1, and the device seems to count its angles from the table: read so, %2 of vessels and image agree, as it is %3. Type these in the geometry: LAO/RAO %4, CRA/CAU %5, roll %6.</source>
        <comment>frame.counted-from-table</comment>
        <translation>患者体位为 %1，该设备似乎以检查床为基准计角：按此理解血管与图像吻合 %2，现状为 %3。请在几何中输入：LAO/RAO %4，CRA/CAU %5，滚转 %6。</translation>
    </message>
    <message>
        <source>Mirrored, the image fits the vessels about as well (%1 of both agree, as it is %2): make sure from which side it is shown.</source>
        <comment>frame.mirror-rival</comment>
        <translation>镜像后的图像与血管同样吻合（吻合 %1，现状为 %2）：请确认图像从哪一侧显示。</translation>
    </message>
    <message>
        <source>The patient lay %1 (0018,5100), not head first and supine. The angles are read as the standard has them: from the patient, head up in the image. If this device counts them from the table, the start pose is turned: a registration that fails tries that, and says which angles to type.</source>
        <comment>dicom.patient-lies</comment>
        <translation>患者体位为 %1 (0018,5100)，而非头先进仰卧。角度按标准理解：以患者为基准，图像中头部朝上。若该设备以检查床为基准，初始位姿会被旋转：配准失败时会尝试这种理解，并给出应输入的角度。</translation>
    </message>
    <message>
        <source>The table moved during this run (%1). That is not used: a pose holds for its own frame only, and frames are not views of one place.</source>
        <comment>dicom.table-moved</comment>
        <translation>采集过程中检查床发生移动（%1）。该移动不被使用：位姿只对其所在帧有效，各帧并非同一位置的投照视图。</translation>
    </message>
    <message>
        <source>the header does not say how far</source>
        <comment>dicom.table-moved-unknown</comment>
        <translation>文件头未说明移动距离</translation>
    </message>
    <message>
        <source>Bent vessels need at least one registered view.</source>
        <comment>bend.no-view</comment>
        <translation>弯曲血管至少需要一个已配准的投照视图。</translation>
    </message>
    <message>
        <source>The traced vessels are single points. Order them to curves before the tree is bent onto them.</source>
        <comment>bend.needs-curves</comment>
        <translation>描出的血管是孤立的点。弯曲之前请先将其连成曲线。</translation>
    </message>
    <message>
        <source>The priors of the pose and the spacing of the knots must be positive numbers.</source>
        <comment>bend.options-unusable</comment>
        <translation>位姿先验和节点间距必须是正数。</translation>
    </message>
    <message>
        <source>The vessels are bent against the tree: the rigid overlay lies %1 off in the mean, most at branch %3 (%2).</source>
        <comment>bend.rigid-off</comment>
        <translation>血管相对于血管树发生了弯曲：刚性叠加平均偏离 %1，在分支 %3 处最大（%2）。</translation>
    </message>
    <message>
        <source>The vessels may be bent against the tree, the image does not show it surely: the rigid overlay would lie %1 off in the mean, most at branch %3 (%2).</source>
        <comment>bend.may-be-off</comment>
        <translation>血管可能相对于血管树发生了弯曲，但图像不能确定：刚性叠加平均将偏离 %1，在分支 %3 处最大（%2）。</translation>
    </message>
    <message>
        <source>Bending was stopped before its end: the rigid pose stays.</source>
        <comment>bend.stopped</comment>
        <translation>弯曲在完成前被停止：保留刚性位姿。</translation>
    </message>
    <message>
        <source>Runs from different starts differ by %1: some branches may lie on other vessels.</source>
        <comment>bend.runs-differ</comment>
        <translation>从不同起点的结果相差 %1：某些分支可能落在其他血管上。</translation>
    </message>
    <message>
        <source>Only %1 of the vessel tree found its vessels in the image.</source>
        <comment>bend.little-seen</comment>
        <translation>只有 %1 的血管树在图像中找到了对应血管。</translation>
    </message>
    <message>
        <source>The traced vessels still lie about %1 beside the bent tree: they moved in finer ways than it follows.</source>
        <comment>bend.not-followed</comment>
        <translation>描出的血管与弯曲后的树仍相差约 %1：其移动比模型所能跟随的更细。</translation>
    </message>
    <message>
        <source>The part of the vessels towards the %1 (%2 of their length) lies %3 off against the rest, towards the %4.</source>
        <comment>bend.part-moved</comment>
        <translation>血管靠%1侧的部分（占其长度的 %2）相对其余部分偏移 %3，方向朝%4。</translation>
    </message>
    <message>
        <source>One view does not tell how the vessels moved along the ray.</source>
        <comment>bend.depth-unknown</comment>
        <translation>单个视图无法判断血管沿射线方向的移动。</translation>
    </message>
    <message>
        <source>front</source>
        <comment>side.front</comment>
        <translation>前</translation>
    </message>
    <message>
        <source>back</source>
        <comment>side.back</comment>
        <translation>后</translation>
    </message>
    <message>
        <source>head</source>
        <comment>side.head</comment>
        <translation>头</translation>
    </message>
    <message>
        <source>feet</source>
        <comment>side.feet</comment>
        <translation>足</translation>
    </message>
    <message>
        <source>The angiogram frame is empty. Choose another frame or file.</source>
        <comment>frame.empty</comment>
        <translation>此帧为空。请选择其他帧或文件。</translation>
    </message>
    <message>
        <source>The angiogram frame has pixels that are not a number (NaN or infinite). Choose another frame, or export the image again.</source>
        <comment>frame.not-finite</comment>
        <translation>此帧有非数值像素（NaN 或无穷）。请换帧或重新导出图像。</translation>
    </message>
    <message>
        <source>The angiogram frame is of one colour: there is nothing to trace. Choose another frame or file.</source>
        <comment>frame.one-colour</comment>
        <translation>此帧为单一颜色：无可提取。请选择其他帧或文件。</translation>
    </message>
    <message>
        <source>This is a page of text, as dose reports are, and no angiogram. Choose the run it belongs to, or another frame.</source>
        <comment>frame.report-page</comment>
        <translation>这是一页文字（如剂量报告），不是血管造影。请选择其所属的序列或其他帧。</translation>
    </message>
    <message>
        <source>What was traced here is in the first frame of the run already: no contrast medium comes between them. If the run holds none, these are catheters, wires and edges of bones, and no vessels.</source>
        <comment>frame.nothing-new</comment>
        <translation>此处提取的内容在序列第一帧中已经存在：两帧之间没有对比剂到达。若该序列不含对比剂，则这些是导管、导丝和骨缘，而不是血管。</translation>
    </message>
    <message>
        <source>Little here looks like vessels filled with contrast medium: what was traced is short or faint, or may be catheters, wires and edges of bones. Choose a fuller frame; if there is none, Edit traced vessels shows what counts.</source>
        <comment>frame.little-contrast</comment>
        <translation>此处几乎没有看起来像充盈对比剂的血管：提取的曲线很短或很淡，或可能是导管、导丝和骨缘。请选择更充盈的帧；若没有，可在“编辑提取的血管”中查看哪些曲线有效。</translation>
    </message>
    <message>
        <source>Nothing like a vessel was found in the angiogram frame. Choose a frame with more contrast, raise the sensitivity, or check whether vessels are dark or bright.</source>
        <comment>frame.no-vessels</comment>
        <translation>此帧造影图像中未发现血管。请选对比度更高的帧、提高灵敏度，或检查血管是暗还是亮。</translation>
    </message>
    <message>
        <source>The thinnest vessel looked for (radius %1) must be positive and no wider than the widest (radius %2).</source>
        <comment>trace.radii-unusable</comment>
        <translation>所找最细血管（半径 %1）须为正，且不得粗于最粗血管（半径 %2）。</translation>
    </message>
    <message>
        <source>The sensitivity of tracing must be above 0, not %1.</source>
        <comment>trace.sensitivity-unusable</comment>
        <translation>识别灵敏度须大于 0，不能是 %1。</translation>
    </message>
    <message>
        <source>The vessel mask has no vessel of at least %1 in it. Draw longer vessels, or lower the shortest length.</source>
        <comment>frame.mask-without-vessels</comment>
        <translation>血管掩膜中没有至少 %1 的血管。请画更长的血管或降低最短长度。</translation>
    </message>
    <message>
        <source>The run has one frame: there is nothing to subtract. Choose a run with frames before the contrast.</source>
        <comment>subtraction.one-frame</comment>
        <translation>该序列只有一帧：无法减影。请选择含造影前帧的序列。</translation>
    </message>
    <message>
        <source>The frames of the run differ in size and cannot be subtracted.</source>
        <comment>subtraction.sizes-differ</comment>
        <translation>该序列各帧大小不同，无法减影。</translation>
    </message>
    <message>
        <source>The run shows contrast medium from its first frame on, so no frame serves as mask. Name the mask frames, or trace without subtraction.</source>
        <comment>subtraction.no-mask</comment>
        <translation>该序列从第一帧起即有对比剂，无法作蒙片。请指定蒙片帧，或不减影提取。</translation>
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
        <source>The volume has no valid voxel spacing. Give the spacing in mm, or export the volume again.</source>
        <comment>volume.no-spacing</comment>
        <translation>体数据没有有效体素间距。请给出 mm 间距或重新导出。</translation>
    </message>
    <message>
        <source>The volume is of one value: there is nothing to trace. Choose another series or file.</source>
        <comment>volume.one-value</comment>
        <translation>体数据只有一个值：无可提取。请选择其他序列或文件。</translation>
    </message>
    <message>
        <source>Tracing was stopped; nothing was kept.</source>
        <comment>tracing.stopped</comment>
        <translation>提取已停止；未保留结果。</translation>
    </message>
    <message>
        <source>There is no vessel in the volume: nothing is set. Lower the threshold, or load another file.</source>
        <comment>tracing.nothing-set</comment>
        <translation>体数据中没有血管：无置位体素。请降低阈值或载入其他文件。</translation>
    </message>
    <message>
        <source>Nothing in the volume is like a vessel: no branch is long enough. Lower the threshold or the shortest branch length.</source>
        <comment>tracing.no-long-branch</comment>
        <translation>体数据中没有类似血管的结构：没有足够长的分支。请降低阈值或最短分支长度。</translation>
    </message>
    <message>
        <source>No contrast-filled vessels were found: soft tissue has %1, and nothing even is as much brighter as contrast medium makes blood. Is this the arterial phase? Choose the CT angiogram, or give the threshold at which the vessels begin.</source>
        <comment>tracing.no-contrast</comment>
        <translation>未找到对比剂充盈的血管：软组织为 %1，没有均匀区域达到对比剂使血液增亮的程度。这是动脉期吗？请选择 CT 血管造影，或给出血管起始阈值。</translation>
    </message>
    <message>
        <source>No contrast-filled vessels were found: besides bone the brightest has %1, soft tissue %2, and it is not like a vessel. Is this the arterial phase? Choose the CT angiogram, or give the threshold at which the vessels begin.</source>
        <comment>tracing.brightest-is-no-vessel</comment>
        <translation>未找到对比剂充盈的血管：除骨骼外最亮处为 %1，软组织为 %2，且形态不似血管。这是动脉期吗？请选择 CT 血管造影，或给出血管起始阈值。</translation>
    </message>
    <message>
        <source>There are places to avoid, but no seed. Place at least one seed in the vessels.</source>
        <comment>tracing.avoid-without-seed</comment>
        <translation>有避开点但没有种子点。请在血管中至少放一个种子点。</translation>
    </message>
    <message>
        <source>(%1, %2, %3)</source>
        <comment>tracing.place</comment>
        <translation>(%1, %2, %3)</translation>
    </message>
    <message>
        <source>The seed %1 mm (LPS) lies in no vessel. Place it inside one, or lower the threshold.</source>
        <comment>tracing.seed-in-no-vessel</comment>
        <translation>种子点 %1 mm（LPS）不在血管内。请放入血管或降低阈值。</translation>
    </message>
    <message>
        <source>The seed %1 mm (LPS) lies in nothing filled: the vessel %2 away was taken.</source>
        <comment>tracing.seed-moved</comment>
        <translation>种子点 %1 mm（LPS）处没有造影剂：已采用距其 %2 的血管。</translation>
    </message>
    <message>
        <source>No seed was placed: the great vessel at %1 mm (LPS) was found and traced. Place a seed in another vessel if it is the wrong one.</source>
        <comment>tracing.no-seed-found-vessel</comment>
        <translation>未放置种子点：已找到并提取位于 %1 mm（LPS）的大血管。如果不对，请在其他血管中放置种子点。</translation>
    </message>
    <message>
        <source>No seed was placed, and nothing is like a great vessel: the largest piece was traced. Place a seed in the vessels if it is not them.</source>
        <comment>tracing.no-seed-largest-piece</comment>
        <translation>未放置种子点，也没有类似大血管的结构：已提取最大的一块。如果它不是所需血管，请在血管中放置种子点。</translation>
    </message>
    <message>
        <source>This is a head, and which of its vessels are arteries is not clear: sinuses and veins may be filled, too. Place a seed in the artery that is to be traced, for example in a carotid artery in the neck or at the base of the skull.</source>
        <comment>tracing.head-needs-seed</comment>
        <translation>这是头部扫描，无法确定哪些血管是动脉：静脉窦和静脉也可能已充盈。请在要提取的动脉中放置种子点，例如颈部或颅底处的颈动脉。</translation>
    </message>
    <message>
        <source>The values of this scan are no Hounsfield units, and nothing in it is a great vessel for sure. Place a seed in the artery that is to be traced, where it is wide.</source>
        <comment>tracing.scan-needs-seed</comment>
        <translation>该扫描的数值不是 Hounsfield 单位，其中没有可以确定为大血管的结构。请在要提取的动脉较宽处放置种子点。</translation>
    </message>
    <message>
        <source>Arteries and sinuses of this head hang together and are filled alike: what was found without a seed runs along the skull. Place a seed in the artery that is to be traced, and mark the sinuses to be avoided.</source>
        <comment>tracing.veins-with-arteries</comment>
        <translation>该头部的动脉与静脉窦相连且充盈程度相同：不用种子点找到的血管沿颅骨走行。请在要提取的动脉中放置种子点，并将静脉窦标记为应避开。</translation>
    </message>
    <message>
        <source>The coil received up to %1 times weaker in parts of the body, which was evened out: the threshold holds where it received best.</source>
        <comment>tracing.coil-evened-out</comment>
        <translation>线圈在身体部分区域的接收最多弱 %1 倍，已予以校正：阈值适用于接收最好的位置。</translation>
    </message>
    <message>
        <source>The curves follow %1 of the mask&apos;s own skeleton within two voxels; most of the rest is at %2 mm (LPS). Where the lumen is wide or its wall rough, they run along its middle instead. Look there for a vessel that is missing.</source>
        <comment>tracing.skeleton-not-followed</comment>
        <translation>曲线在两个体素以内与掩膜自身骨架的 %1 相符；其余大部分位于 %2 mm（LPS）。在管腔较宽或管壁粗糙处，曲线改为沿其中线走行。请检查该处是否缺少血管。</translation>
    </message>
    <message>
        <source>The place %1 mm (LPS) lies outside the scan. Choose one inside.</source>
        <comment>tracing.path-end-outside-scan</comment>
        <translation>位置 %1 mm (LPS) 在扫描之外。请选择扫描内的位置。</translation>
    </message>
    <message>
        <source>The place %1 mm (LPS) lies in nothing brighter than its surroundings. Place it inside the vessel.</source>
        <comment>tracing.path-end-in-nothing</comment>
        <translation>位置 %1 mm (LPS) 处没有比周围更亮的结构。请将其放在血管内。</translation>
    </message>
    <message>
        <source>Both places lie at the same spot of the vessel. Place them farther apart.</source>
        <comment>tracing.path-ends-too-near</comment>
        <translation>两个位置位于血管的同一点。请放得更远一些。</translation>
    </message>
    <message>
        <source>No way was found between the two places. Place them nearer to each other.</source>
        <comment>tracing.path-not-found</comment>
        <translation>两个位置之间未找到路径。请放得更近一些。</translation>
    </message>
    <message>
        <source>For %1 the path runs through nothing like a vessel. Look at it, or place a point in between.</source>
        <comment>tracing.path-outside</comment>
        <translation>路径有 %1 穿过不像血管的部分。请检查，或在中间放置一点。</translation>
    </message>
    <message>
        <source>Thin vessels are traced from seeds, and none is placed. Place one in each vessel, near where it begins.</source>
        <comment>tracing.tubes-need-seed</comment>
        <translation>细血管从种子点开始提取，但尚未放置种子点。请在每条血管的起始处附近放置一个。</translation>
    </message>
    <message>
        <source>No thin vessel of any length leads from the seeds. Place them in the middle of the vessels, or trace without the restriction to thin ones.</source>
        <comment>tracing.no-tube-at-seed</comment>
        <translation>从种子点出发没有足够长的细血管。请将种子点放在血管中央，或取消仅提取细血管的限制。</translation>
    </message>
    <message>
        <source>More was reached than is searched: the vessels are cut short. Look for a leak into lung, liver or bone.</source>
        <comment>tracing.tubes-cut-short</comment>
        <translation>到达的范围超出了搜索上限：血管被截断。请检查是否泄漏到肺、肝或骨骼。</translation>
    </message>
    <message>
        <source>The vessels are %1 pieces that do not connect, each with a root of its own: %2. Join those that belong together, or ask for some by a seed in each.</source>
        <comment>tracing.vessels-in-pieces</comment>
        <translation>血管由 %1 段互不相连的部分组成，每段各有一个根：%2。请连接同属一体的部分，或在所需的各段中放种子点。</translation>
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
        <source>%1 others with %2</source>
        <comment>tracing.other-pieces</comment>
        <translation>另有 %1 段共 %2</translation>
    </message>
    <message>
        <source>A piece that does not connect to the traced vessels was left out: %1 mm (LPS). Place a seed in it if it belongs to the tree.</source>
        <comment>tracing.one-piece-left-out</comment>
        <translation>有一段未与提取血管相连，已略去：%1 mm（LPS）。若属于血管树，请在其中放种子点。</translation>
    </message>
    <message>
        <source>%1 pieces with %2 of the voxels that do not connect to the traced vessels were left out: %3. Place a seed in each that belongs to the tree.</source>
        <comment>tracing.pieces-left-out</comment>
        <translation>有 %1 段（占体素 %2）未与提取血管相连，已略去：%3。请在属于血管树的各段中放种子点。</translation>
    </message>
    <message>
        <source>A piece holds no branch of the shortest length and was left out: %1 mm (LPS). Lower the shortest branch length if it is a vessel.</source>
        <comment>tracing.one-piece-too-short</comment>
        <translation>有一段不含达到最短长度的分支，已略去：%1 mm（LPS）。若为血管，请减小最短分支长度。</translation>
    </message>
    <message>
        <source>%1 pieces with %2 of the voxels hold no branch of the shortest length and were left out: %3. Lower the shortest branch length if they are vessels.</source>
        <comment>tracing.pieces-too-short</comment>
        <translation>有 %1 段（占体素 %2）不含达到最短长度的分支，已略去：%3。若为血管，请减小最短分支长度。</translation>
    </message>
    <message>
        <source>Gaps between pieces over which a vessel clearly goes on were closed: %1, of up to %2. Look there for vessels that do not belong together.</source>
        <comment>tracing.gaps-closed</comment>
        <translation>已闭合血管明显延续的断口：%1 处，最长 %2。请检查该处血管是否同属一体。</translation>
    </message>
    <message>
        <source>1 loop was opened at the thinnest place: look there for vessels that only touch.</source>
        <comment>tracing.one-loop-opened</comment>
        <translation>1 个环在最细处断开：请检查该处是否仅为血管相触。</translation>
    </message>
    <message>
        <source>%1 loops were opened at their thinnest places: look there for vessels that only touch.</source>
        <comment>tracing.loops-opened</comment>
        <translation>%1 个环在最细处断开：请检查这些地方是否仅为血管相触。</translation>
    </message>
    <message>
        <source>Loops that were kept, as asked: %1. A branch ends on another where one closes.</source>
        <comment>tracing.loops-kept</comment>
        <translation>按要求保留的环：%1 个。环闭合处，一条分支止于另一条。</translation>
    </message>
    <message>
        <source>A part less bright than the vessels was left out, as veins and organs are. Place a seed in it if it belongs to the tree.</source>
        <comment>tracing.one-dim-part-left-out</comment>
        <translation>一个不如血管明亮的部分已舍弃：静脉和器官即如此。若属于血管树，请在其中放置种子点。</translation>
    </message>
    <message>
        <source>%1 parts less bright than the vessels were left out, as veins and organs are. Place seeds in those that belong to the tree.</source>
        <comment>tracing.dim-parts-left-out</comment>
        <translation>%1 个不如血管明亮的部分已舍弃：静脉和器官即如此。请在属于血管树的部分中放置种子点。</translation>
    </message>
    <message>
        <source>Nothing in the scan is as dark as air in Hounsfield units: if its values are others, bone cannot be told from blood for sure. Look for bone among the vessels, or export the scan in Hounsfield units.</source>
        <comment>tracing.perhaps-no-hounsfield</comment>
        <translation>扫描中没有像亨氏单位下的空气那样暗的部分：如果其数值不是亨氏单位，就无法可靠地区分骨骼和血液。请检查血管中是否混入骨骼，或以亨氏单位重新导出扫描。</translation>
    </message>
    <message>
        <source>The vessel tree has no branches. Give a centreline with at least one branch.</source>
        <comment>tree.no-branches</comment>
        <translation>血管树没有分支。请给出至少含一个分支的中心线。</translation>
    </message>
    <message>
        <source>Branch %1 occurs twice in the vessel tree. Branch ids must be unique.</source>
        <comment>tree.branch-twice</comment>
        <translation>分支 %1 在血管树中重复。分支编号必须唯一。</translation>
    </message>
    <message>
        <source>Branch %1 of the vessel tree has fewer than two points. Remove it or add points.</source>
        <comment>tree.branch-too-few-points</comment>
        <translation>血管树的 分支 %1 少于两点。请移除或补点。</translation>
    </message>
    <message>
        <source>Branch %1 of the vessel tree has a coordinate that is not a number (NaN or infinite).</source>
        <comment>tree.branch-not-finite</comment>
        <translation>血管树的 分支 %1 有非数值坐标（NaN 或无穷）。</translation>
    </message>
    <message>
        <source>Branch %1 of the vessel tree has no length: all its points coincide.</source>
        <comment>tree.branch-without-length</comment>
        <translation>血管树的 分支 %1 长度为零：所有点重合。</translation>
    </message>
    <message>
        <source>Branch %1 of the vessel tree does not have one radius per point.</source>
        <comment>tree.branch-radii-missing</comment>
        <translation>血管树的 分支 %1 并非每点都有半径。</translation>
    </message>
    <message>
        <source>Branch %1 of the vessel tree has a radius that is negative or not a number. Correct it, or give no radii along this branch.</source>
        <comment>tree.branch-radius-unusable</comment>
        <translation>血管树的分支 %1 有为负或非数值的半径。请更正，或不给出该分支的半径。</translation>
    </message>
    <message>
        <source>The vessel tree has no branch %1.</source>
        <comment>tree.no-such-branch</comment>
        <translation>血管树没有分支 %1。</translation>
    </message>
    <message>
        <source>The range of %1 must be two angles, the lower one first, within ±%2°.</source>
        <comment>angles.range-odd</comment>
        <translation>%1 的范围须为两个角度，小的在前，且在 ±%2° 以内。</translation>
    </message>
    <message>
        <source>Looking for angles was stopped.</source>
        <comment>angles.stopped</comment>
        <translation>角度查找已停止。</translation>
    </message>
    <message>
        <source>The step between angles must be at least %1.</source>
        <comment>angles.step-too-fine</comment>
        <translation>角度步长至少为 %1。</translation>
    </message>
    <message>
        <source>Select one branch in the image, in the 3-D view or in the list.</source>
        <comment>angles.select-one-branch</comment>
        <translation>请在图像、三维视图或列表中选择一个分支。</translation>
    </message>
    <message>
        <source>The vessels come without radii: 1 mm is assumed, so what covers the branch is a guess.</source>
        <comment>tree.radii-assumed</comment>
        <translation>血管没有半径：假定为 1 mm，因此遮盖程度只是估计。</translation>
    </message>
    <message>
        <source>Branch %1 meets no other branch: it has no take-off. Ask for the branch itself.</source>
        <comment>tree.no-take-off</comment>
        <translation>分支 %1 不与其他分支相接，没有发出处。请查询分支本身。</translation>
    </message>
    <message>
        <source>Every branch hangs on branch %1: nothing would be left.</source>
        <comment>edit.all-hang-on-branch</comment>
        <translation>所有分支都连在分支 %1 上：将一无所剩。</translation>
    </message>
    <message>
        <source>Every branch is shorter or thinner than asked: nothing would be left. Lower the limits.</source>
        <comment>edit.all-pruned</comment>
        <translation>所有分支都短于或细于要求：将一无所剩。请降低限值。</translation>
    </message>
    <message>
        <source>Branch %1 cannot be cut so near to its end. Delete it instead, or cut farther in.</source>
        <comment>edit.cut-too-near-end</comment>
        <translation>分支 %1 不能在靠近末端处切断。请改为删除，或在更内侧切断。</translation>
    </message>
    <message>
        <source>The whole way runs inside vessels that are traced already: there is nothing to add.</source>
        <comment>edit.branch-runs-inside</comment>
        <translation>整条路径都在已提取的血管内：没有可添加的部分。</translation>
    </message>
    <message>
        <source>A branch cannot be joined to itself. Choose two branches.</source>
        <comment>edit.joined-to-itself</comment>
        <translation>分支不能与自身连接。请选择两个分支。</translation>
    </message>
    <message>
        <source>The 2-D centreline is empty: no vessel was found in the image. Choose another frame or a higher sensitivity, or give a centreline file.</source>
        <comment>centreline.empty</comment>
        <translation>二维中心线为空：图像中未发现血管。请换帧、提高灵敏度，或提供中心线文件。</translation>
    </message>
    <message>
        <source>Curve %1 of the 2-D centreline has a coordinate that is not a number (NaN or infinite).</source>
        <comment>centreline.curve-not-finite</comment>
        <translation>二维中心线的曲线 %1 有非数值坐标（NaN 或无穷）。</translation>
    </message>
    <message>
        <source>The surface has no triangles, or the voxel size is not positive. Choose another surface.</source>
        <comment>surface.empty</comment>
        <translation>表面没有三角面，或体素大小非正。请选择其他表面。</translation>
    </message>
    <message>
        <source>The surface is flat: it bounds no inside. Choose the wall of a vessel.</source>
        <comment>surface.flat</comment>
        <translation>表面是平的：没有内部。请选择血管壁。</translation>
    </message>
    <message>
        <source>The voxel size is too fine for a surface of this extent. Choose a larger one.</source>
        <comment>surface.voxel-too-fine</comment>
        <translation>对此范围的表面体素过小。请选更大的。</translation>
    </message>
    <message>
        <source>Nothing lies inside the surface: it is too open, or thinner than a voxel. Close its holes, or choose a smaller voxel size.</source>
        <comment>surface.nothing-inside</comment>
        <translation>表面内部为空：开口过大或比一个体素还薄。请封闭孔洞或选更小体素。</translation>
    </message>
    <message>
        <source>it is too large for a case file. Choose an .angiopose file.</source>
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
        <source>a value in it has the wrong kind. Compare it with the published schema.</source>
        <comment>case.wrong-kind</comment>
        <translation>其中有取值类型错误。请与公布的模式比较。</translation>
    </message>
    <message>
        <source>the case was saved by a newer AngioPose. Update the program.</source>
        <comment>case.newer</comment>
        <translation>病例由较新的 AngioPose 保存。请更新程序。</translation>
    </message>
    <message>
        <source>the key %1 is missing. Add it.</source>
        <comment>case.key-missing</comment>
        <translation>缺少键 %1。请补充。</translation>
    </message>
    <message>
        <source>the value is not one of those allowed. See the published schema.</source>
        <comment>case.value-not-allowed</comment>
        <translation>取值不在允许范围。请见公布的模式。</translation>
    </message>
    <message>
        <source>the value is of the wrong kind. See the published schema.</source>
        <comment>case.value-of-wrong-kind</comment>
        <translation>取值类型错误。请见公布的模式。</translation>
    </message>
    <message>
        <source>%1 Correct it.</source>
        <comment>case.value-wrong</comment>
        <translation>%1 请更正。</translation>
    </message>
    <message>
        <source>it does not follow the published schema. Compare it with a case that loads.</source>
        <comment>case.against-schema</comment>
        <translation>不符合公布的模式。请与可载入的病例比较。</translation>
    </message>
    <message>
        <source>this is an input of the case and will not be overwritten. Choose another name.</source>
        <comment>case.is-input</comment>
        <translation>这是病例的输入文件，不会覆盖。请换名。</translation>
    </message>
    <message>
        <source>a file name or a text in the case is not UTF-8. Rename the file.</source>
        <comment>case.not-utf8</comment>
        <translation>病例中的文件名或文本不是 UTF-8。请重命名。</translation>
    </message>
    <message>
        <source>a scan alone is no case yet: the case file needs traced vessels and an angiogram. Trace the vessels and open an angiogram before saving; the scan itself stays as it is.</source>
        <comment>case.scan-alone</comment>
        <translation>仅有扫描还不能成为病例：病例文件需要已追踪的血管和造影图像。保存前请先追踪血管并打开造影图像；扫描本身保持不变。</translation>
    </message>
    <message>
        <source>a case needs a vessel tree and an angiogram. Open both before saving.</source>
        <comment>case.incomplete</comment>
        <translation>病例需要血管树和造影图像。保存前请打开两者。</translation>
    </message>
    <message>
        <source>the pose is not a rigid motion of finite numbers. Reset the pose before saving.</source>
        <comment>case.pose-not-rigid</comment>
        <translation>位姿不是有限数的刚体变换。保存前请重置位姿。</translation>
    </message>
    <message>
        <source>it is for an image of %1 x %2 pixels, but the angiogram has %3 x %4. Give the camera of this image.</source>
        <comment>case.camera-of-other-image</comment>
        <translation>适用于 %1 x %2 像素的图像，但造影图像为 %3 x %4。请给出此图像的相机。</translation>
    </message>
    <message>
        <source>maxVesselRadiusPx is below minVesselRadiusPx. Exchange them.</source>
        <comment>case.radii-swapped</comment>
        <translation>maxVesselRadiusPx 小于 minVesselRadiusPx。请对调。</translation>
    </message>
    <message>
        <source>it names no input. Give the file of the vessels as centerline, segmentation, surface or volume.</source>
        <comment>case.no-input</comment>
        <translation>未指定输入。请以 centerline、segmentation、surface 或 volume 给出血管文件。</translation>
    </message>
    <message>
        <source>%1 Remove the key to go back to the vessels as they were before the edits.</source>
        <comment>case.edited-tree</comment>
        <translation>%1 删除该键可恢复编辑前的血管。</translation>
    </message>
    <message>
        <source>branch %1 is there twice.</source>
        <comment>case.branch-twice</comment>
        <translation>分支 %1 重复。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is unknown. Use one of %2.</source>
        <comment>case.method-unknown</comment>
        <translation>&quot;%1&quot; 未知。可用：%2。</translation>
    </message>
    <message>
        <source>give a number from %1 to %2.</source>
        <comment>case.option-number</comment>
        <translation>请给出 %1 至 %2 之间的数。</translation>
    </message>
    <message>
        <source>give one of %1.</source>
        <comment>case.option-choice</comment>
        <translation>请给出 %1 之一。</translation>
    </message>
    <message>
        <source>it is missing, and the angles do not give a start pose. %1</source>
        <comment>case.no-start-pose</comment>
        <translation>缺失，且角度不足以得出初始位姿。%1</translation>
    </message>
    <message>
        <source>the file has changed since the case was saved. Check that it is the right one.</source>
        <comment>case.file-changed</comment>
        <translation>文件在病例保存后已更改。请确认是否正确。</translation>
    </message>
    <message>
        <source>what was found in it is left out, because the vessels, the image or the traced curves have changed since. Register again.</source>
        <comment>case.result-stale</comment>
        <translation>其中的结果已略去，因为血管、图像或描绘的曲线此后已改变。请重新配准。</translation>
    </message>
    <message>
        <source>what was found in it is left out, because the case file was changed since: %1. Register again.</source>
        <comment>case.result-beside</comment>
        <translation>其中的结果已略去，因为病例文件此后有改动：%1。请重新配准。</translation>
    </message>
    <message>
        <source>where the vessels were followed to is left out, because it does not fit the run or the pose of the case. Follow them again.</source>
        <comment>case.followed-misfit</comment>
        <translation>血管的跟踪结果已略去，因为它与病例的序列或位姿不符。请重新跟踪。</translation>
    </message>
    <message>
        <source>The vessels of a followed run are shown at their poses, but not bent: %1 Follow them again.</source>
        <comment>case.bends-left-out</comment>
        <translation>已跟踪序列的血管按其位姿显示，但不弯曲：%1 请重新跟踪。</translation>
    </message>
    <message>
        <source>the case names no file of their bends.</source>
        <comment>case.bends-unnamed</comment>
        <translation>病例未指明其弯曲的文件。</translation>
    </message>
    <message>
        <source>this is no file of bends.</source>
        <comment>case.bends-none</comment>
        <translation>这不是弯曲文件。</translation>
    </message>
    <message>
        <source>the bends are of other vessels or frames.</source>
        <comment>case.bends-of-others</comment>
        <translation>这些弯曲属于其他血管或帧。</translation>
    </message>
    <message>
        <source>the bends are damaged or cut short.</source>
        <comment>case.bends-cut</comment>
        <translation>弯曲数据已损坏或被截断。</translation>
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
        <translation>描绘的曲线</translation>
    </message>
    <message>
        <source>the geometry</source>
        <comment>part.geometry</comment>
        <translation>几何参数</translation>
    </message>
    <message>
        <source>the start pose</source>
        <comment>part.start-pose</comment>
        <translation>初始位姿</translation>
    </message>
    <message>
        <source>the locked axes</source>
        <comment>part.locks</comment>
        <translation>锁定的轴</translation>
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
        <source>this is another DICOM image than the one the case was made for.</source>
        <comment>case.other-image</comment>
        <translation>这与病例所用的 DICOM 图像不同。</translation>
    </message>
    <message>
        <source>%1 The edited vessels are in the case; it opens without the file.</source>
        <comment>case.opens-without</comment>
        <translation>%1 编辑后的血管已在病例中；无需该文件即可打开。</translation>
    </message>
    <message>
        <source>the tree has no branch %1; it is left out.</source>
        <comment>case.branch-left-out</comment>
        <translation>树中没有分支 %1；已略去。</translation>
    </message>
    <message>
        <source>Another view is left out: %1</source>
        <comment>case.view-left-out</comment>
        <translation>省略另一视图：%1</translation>
    </message>
    <message>
        <source>line %1: the name &apos;%2&apos; is no folder name. Use one without &apos;/&apos;.</source>
        <comment>batch.no-folder-name</comment>
        <translation>第 %1 行：名称“%2”不能用作文件夹名。请使用不含“/”的名称。</translation>
    </message>
    <message>
        <source>line %1: the frame &apos;%2&apos; is no whole number.</source>
        <comment>batch.frame-no-number</comment>
        <translation>第 %1 行：帧“%2”不是整数。</translation>
    </message>
    <message>
        <source>line %1: the name &apos;%2&apos; is taken. Give each case its own.</source>
        <comment>batch.name-twice</comment>
        <translation>第 %1 行：名称“%2”已被占用。请给每个病例各自的名称。</translation>
    </message>
    <message>
        <source>the column %1 is missing. Give a folder that `angiopose-cli evaluate` wrote.</source>
        <comment>runs.column-missing</comment>
        <translation>缺少列 %1。请给出由 `angiopose-cli evaluate` 写出的文件夹。</translation>
    </message>
    <message>
        <source>line %1, column %2 holds no number. Give a folder that `angiopose-cli evaluate` wrote.</source>
        <comment>runs.no-number</comment>
        <translation>第 %1 行第 %2 列不是数字。请给出由 `angiopose-cli evaluate` 写出的文件夹。</translation>
    </message>
    <message>
        <source>it mixes experiments or seeds. Give each its own folder.</source>
        <comment>runs.mixed</comment>
        <translation>混有不同的实验或种子。请为每个分别使用文件夹。</translation>
    </message>
    <message>
        <source>reading was stopped.</source>
        <comment>file.reading-stopped</comment>
        <translation>读取已停止。</translation>
    </message>
    <message>
        <source>there is no such file. Check the path.</source>
        <comment>file.missing</comment>
        <translation>文件不存在。请检查路径。</translation>
    </message>
    <message>
        <source>it cannot be reached (%1). Check the path.</source>
        <comment>file.unreachable</comment>
        <translation>无法访问（%1）。请检查路径。</translation>
    </message>
    <message>
        <source>it cannot be opened (%1). Check that you may read it.</source>
        <comment>file.not-opened</comment>
        <translation>无法打开（%1）。请检查读取权限。</translation>
    </message>
    <message>
        <source>it cannot be read (%1). Copy it to a local disk.</source>
        <comment>file.not-read</comment>
        <translation>无法读取（%1）。请复制到本地磁盘。</translation>
    </message>
    <message>
        <source>it cannot be written (%1). Choose another folder or make room.</source>
        <comment>file.not-written</comment>
        <translation>无法写入（%1）。请选择其他文件夹或腾出空间。</translation>
    </message>
    <message>
        <source>this is a folder. Choose a file in it.</source>
        <comment>file.is-folder</comment>
        <translation>这是文件夹。请选择其中的文件。</translation>
    </message>
    <message>
        <source>this is not a regular file. Choose a file on disk.</source>
        <comment>file.not-regular</comment>
        <translation>这不是普通文件。请选择磁盘上的文件。</translation>
    </message>
    <message>
        <source>the file is empty. Export or copy it again.</source>
        <comment>file.empty</comment>
        <translation>文件为空。请重新导出或复制。</translation>
    </message>
    <message>
        <source>this is a Git LFS pointer, not the file itself. Run `git lfs pull` where it came from.</source>
        <comment>file.lfs-pointer</comment>
        <translation>这是 Git LFS 指针而非文件本身。请在来源处运行 `git lfs pull`。</translation>
    </message>
    <message>
        <source>this is not a place for a file. Give a file name in an existing folder.</source>
        <comment>file.no-place</comment>
        <translation>此处不能存放文件。请给出现有文件夹中的文件名。</translation>
    </message>
    <message>
        <source>the unit must be a positive length in mm.</source>
        <comment>file.wrong-unit</comment>
        <translation>单位须为正的毫米长度。</translation>
    </message>
    <message>
        <source>it declares more data than memory holds. The file is damaged; export it again.</source>
        <comment>file.larger-than-memory</comment>
        <translation>声明的数据超过内存。文件损坏；请重新导出。</translation>
    </message>
    <message>
        <source>it is decoded by the program %1, which is not there or does not start. Install AngioPose again.</source>
        <comment>file.decoder-missing</comment>
        <translation>它由程序 %1 解码，但该程序不存在或无法启动。请重新安装 AngioPose。</translation>
    </message>
    <message>
        <source>its content makes the decoder fail. The file is damaged; export it again, or in another format.</source>
        <comment>file.decoder-died</comment>
        <translation>其内容导致解码程序失败。文件已损坏；请重新导出，或导出为其他格式。</translation>
    </message>
    <message>
        <source>decoding it takes far longer than a file of its size may. The file is damaged; export it again.</source>
        <comment>file.decoder-too-long</comment>
        <translation>解码所需时间远超该大小的文件所应需。文件已损坏；请重新导出。</translation>
    </message>
    <message>
        <source>decoding it takes far more memory than a file of its size may. The file is damaged; export it again.</source>
        <comment>file.decoder-too-large</comment>
        <translation>解码所需内存远超该大小的文件所应需。文件已损坏；请重新导出。</translation>
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
        <source>the folder cannot be read to its end. Copy it to a local disk.</source>
        <comment>folder.not-read-to-end</comment>
        <translation>无法读完文件夹。请复制到本地磁盘。</translation>
    </message>
    <message>
        <source>it holds more than 50000 files. Choose the folder of one study.</source>
        <comment>folder.too-full</comment>
        <translation>含超过 50000 个文件。请选择单个检查的文件夹。</translation>
    </message>
    <message>
        <source>its JSON is nested more than %1 levels deep. This is no file of this program.</source>
        <comment>json.too-deep</comment>
        <translation>JSON 嵌套超过 %1 层。这不是本程序的文件。</translation>
    </message>
    <message>
        <source>it is not valid JSON at line %1. Correct it there.</source>
        <comment>json.invalid</comment>
        <translation>第 %1 行不是有效 JSON。请更正。</translation>
    </message>
    <message>
        <source>a number in it is too large for a double. Correct it.</source>
        <comment>json.number-too-large</comment>
        <translation>其中的数超出双精度范围。请更正。</translation>
    </message>
    <message>
        <source>this is not a text table. Choose a CSV file with a header row.</source>
        <comment>table.no-text</comment>
        <translation>这不是文本表。请选择有表头的 CSV 文件。</translation>
    </message>
    <message>
        <source>line %1 has %2 columns, the first line has %3. Separate columns by commas and use . as decimal point.</source>
        <comment>table.columns</comment>
        <translation>第 %1 行有 %2 列，首行有 %3 列。请以逗号分列，用 . 作小数点。</translation>
    </message>
    <message>
        <source>line %1, column %2: &quot;%3&quot; is not a finite number. Correct or remove the line.</source>
        <comment>table.no-number</comment>
        <translation>第 %1 行 %2 列：&quot;%3&quot; 不是有限数。请更正或删除该行。</translation>
    </message>
    <message>
        <source>line %1: the branch must be a whole number. Correct the line.</source>
        <comment>table.branch-no-number</comment>
        <translation>第 %1 行：branch 必须为整数。请更正。</translation>
    </message>
    <message>
        <source>it does not hold one ITK transform. Export a single rigid transform.</source>
        <comment>pose.no-transform</comment>
        <translation>未含单个 ITK 变换。请导出一个刚性变换。</translation>
    </message>
    <message>
        <source>its transform &quot;%1&quot; is not rigid, or lacks parameters. Export a rigid transform (affine, Euler3D or VersorRigid3D).</source>
        <comment>pose.not-rigid-transform</comment>
        <translation>变换 &quot;%1&quot; 非刚性或缺少参数。请导出刚性变换（affine、Euler3D 或 VersorRigid3D）。</translation>
    </message>
    <message>
        <source>its centre is not finite. Export the transform again.</source>
        <comment>pose.centre-not-finite</comment>
        <translation>中心非有限数。请重新导出变换。</translation>
    </message>
    <message>
        <source>it has no matrix `cameraFromPatient` of four rows of four numbers, at the top or in `pose`. Give one.</source>
        <comment>pose.no-matrix</comment>
        <translation>顶层或 `pose` 中没有四行四列的 `cameraFromPatient` 矩阵。请提供。</translation>
    </message>
    <message>
        <source>cameraFromPatient must have four rows of four numbers.</source>
        <comment>pose.rows</comment>
        <translation>cameraFromPatient 须为四行四列数字。</translation>
    </message>
    <message>
        <source>cameraFromPatient has an entry that is not a finite number.</source>
        <comment>pose.not-finite</comment>
        <translation>cameraFromPatient 含有非有限数。</translation>
    </message>
    <message>
        <source>the last row of cameraFromPatient must be 0 0 0 1. Is the matrix transposed?</source>
        <comment>pose.last-row</comment>
        <translation>cameraFromPatient 末行须为 0 0 0 1。矩阵是否转置了？</translation>
    </message>
    <message>
        <source>cameraFromPatient is a reflection (determinant below 0). A mirrored image belongs into the sign of fx, never into the rotation.</source>
        <comment>pose.reflection</comment>
        <translation>cameraFromPatient 为镜像（行列式小于 0）。镜像应体现在 fx 的符号，而非旋转。</translation>
    </message>
    <message>
        <source>the upper left 3 x 3 of cameraFromPatient is not a rotation (scale or shear). Give a rigid pose in mm.</source>
        <comment>pose.no-rotation</comment>
        <translation>cameraFromPatient 左上 3 x 3 不是旋转（含缩放或剪切）。请给出以 mm 为单位的刚性位姿。</translation>
    </message>
    <message>
        <source>it is too large for a pose. Choose a .json, .tfm, .mat or .h5 file.</source>
        <comment>pose.too-large</comment>
        <translation>作为位姿过大。请选择 .json、.tfm、.mat 或 .h5 文件。</translation>
    </message>
    <message>
        <source>this is no pose. Choose a .json, or an ITK .tfm, .mat or .h5 file.</source>
        <comment>pose.unknown</comment>
        <translation>这不是位姿。请选择 .json 或 ITK 的 .tfm、.mat、.h5 文件。</translation>
    </message>
    <message>
        <source>the pose is not a rigid motion of finite numbers. Reset it before saving.</source>
        <comment>pose.not-saved</comment>
        <translation>位姿不是有限数的刚体变换。保存前请重置。</translation>
    </message>
    <message>
        <source>poses are written as .json, .tfm or .h5. Change the extension.</source>
        <comment>pose.extension</comment>
        <translation>位姿写为 .json、.tfm 或 .h5。请更改扩展名。</translation>
    </message>
    <message>
        <source>this is not a log of observer trials. Choose another name.</source>
        <comment>observer-log.not-one</comment>
        <translation>这不是观察者试验记录。请换名。</translation>
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
        <source>Colour image converted to grey.</source>
        <comment>image.colour-to-grey</comment>
        <translation>彩色图像已转换为灰度。</translation>
    </message>
    <message>
        <source>The transparency of the image is ignored.</source>
        <comment>image.transparency-ignored</comment>
        <translation>忽略图像透明度。</translation>
    </message>
    <message>
        <source>A plain image has no C-arm geometry: enter it in the geometry of the case.</source>
        <comment>image.no-geometry</comment>
        <translation>普通图像没有 C 形臂几何：请在病例几何中输入。</translation>
    </message>
    <message>
        <source>The picture is a mask of two levels: its vessels are taken as they are drawn.</source>
        <comment>image.is-mask</comment>
        <translation>该图像是只有两级灰度的掩膜：血管按所画的样子采用。</translation>
    </message>
    <message>
        <source>this is no image that this program reads. Choose a DICOM XA run, a PNG, TIFF or JPEG image.</source>
        <comment>image.unknown</comment>
        <translation>这不是本程序可读取的图像。请选择 DICOM XA 序列、PNG、TIFF 或 JPEG 图像。</translation>
    </message>
    <message>
        <source>this is %1, not an angiogram. Choose a DICOM XA run, a PNG, TIFF or JPEG image.</source>
        <comment>image.is-other</comment>
        <translation>这是%1，不是造影图像。请选择 DICOM XA 序列、PNG、TIFF 或 JPEG 图像。</translation>
    </message>
    <message>
        <source>this is a gzip archive without a readable DICOM file in it. Unpack it and choose the angiogram itself.</source>
        <comment>image.gzip-without-dicom</comment>
        <translation>这是不含可读 DICOM 文件的 gzip 压缩包。请解压后选择造影图像。</translation>
    </message>
    <message>
        <source>the image is damaged or cut short. Copy or export it again.</source>
        <comment>image.damaged</comment>
        <translation>图像损坏或截断。请重新复制或导出。</translation>
    </message>
    <message>
        <source>the image is damaged or of an unusual kind. Export it in grey or RGB with 8 or 16 bits, without tiles.</source>
        <comment>image.unusual</comment>
        <translation>图像损坏或类型特殊。请以 8 或 16 位灰度或 RGB、不分块导出。</translation>
    </message>
    <message>
        <source>the image has fewer than 8 pixels on a side, or more than this program holds. Export the angiogram at its own size.</source>
        <comment>image.size</comment>
        <translation>图像边长少于 8 像素，或超出程序容量。请按原尺寸导出。</translation>
    </message>
    <message>
        <source>the frames differ in size. All frames of a run must be equally large.</source>
        <comment>image.frames-differ</comment>
        <translation>各帧大小不同。同一序列各帧须等大。</translation>
    </message>
    <message>
        <source>there is no picture to write. Render or trace one first.</source>
        <comment>image.no-picture</comment>
        <translation>没有可写入的图片。请先生成。</translation>
    </message>
    <message>
        <source>a pixel is not a finite number. Correct the image before writing it.</source>
        <comment>image.pixel-not-finite-writing</comment>
        <translation>有像素不是有限数。写入前请更正图像。</translation>
    </message>
    <message>
        <source>a pixel is not a finite number. Export the image again.</source>
        <comment>image.pixel-not-finite</comment>
        <translation>有像素不是有限数。请重新导出图像。</translation>
    </message>
    <message>
        <source>this is %1, not a 2-D centreline. Choose a CSV table or a PNG mask.</source>
        <comment>centreline.is-other</comment>
        <translation>这是%1，不是二维中心线。请选择 CSV 表或 PNG 掩膜。</translation>
    </message>
    <message>
        <source>this is not a mask of two levels. Draw the vessels white on black.</source>
        <comment>centreline.no-mask</comment>
        <translation>这不是二值掩膜。请以黑底白色画血管。</translation>
    </message>
    <message>
        <source>the header row has no columns x and y. The first line must name the columns: x,y and, where known, branch,radius (px).</source>
        <comment>centreline.no-columns</comment>
        <translation>表头缺少 x 和 y 列。首行须为列名：x,y 以及已知的 branch,radius（px）。</translation>
    </message>
    <message>
        <source>it has a column z: this is a 3-D centreline. Choose the centreline traced in the image.</source>
        <comment>centreline.is-3d</comment>
        <translation>含 z 列：这是三维中心线。请选择图像中提取的中心线。</translation>
    </message>
    <message>
        <source>it has more than a million points. Resample the centreline.</source>
        <comment>centreline.too-long</comment>
        <translation>超过一百万个点。请重采样中心线。</translation>
    </message>
    <message>
        <source>line %1 lies far outside any image. Coordinates are in pixels.</source>
        <comment>centreline.outside</comment>
        <translation>第 %1 行远在图像之外。坐标单位为像素。</translation>
    </message>
    <message>
        <source>this is not a DICOM file. Choose a scan.</source>
        <comment>dicom.not-one</comment>
        <translation>这不是 DICOM 文件。请选择扫描。</translation>
    </message>
    <message>
        <source>its deflated content is damaged or cut short. Copy or export it again.</source>
        <comment>dicom.deflate-damaged</comment>
        <translation>压缩内容损坏或截断。请重新复制或导出。</translation>
    </message>
    <message>
        <source>no DICOM element in it can be read. The file is damaged; copy or export it again.</source>
        <comment>dicom.no-element</comment>
        <translation>无法读取任何 DICOM 元素。文件损坏；请重新复制或导出。</translation>
    </message>
    <message>
        <source>the element %1 declares %2 bytes, but %3 are left</source>
        <comment>dicom.element-too-long</comment>
        <translation>元素 %1 声明 %2 字节，但仅剩 %3</translation>
    </message>
    <message>
        <source>the sequence %1 has no end</source>
        <comment>dicom.sequence-without-end</comment>
        <translation>序列 %1 没有结尾</translation>
    </message>
    <message>
        <source>it ends in the middle of an element</source>
        <comment>dicom.ends-within</comment>
        <translation>在某个元素中间结束</translation>
    </message>
    <message>
        <source>The end of the file is damaged (%1); the image is complete.</source>
        <comment>dicom.end-damaged</comment>
        <translation>文件末尾损坏（%1）；图像完整。</translation>
    </message>
    <message>
        <source>%1 is damaged before its pixels: %2. Copy or export it again.</source>
        <comment>dicom.damaged-before-pixels</comment>
        <translation>%1 在像素之前损坏：%2。请重新复制或导出。</translation>
    </message>
    <message>
        <source>%1 holds no image. Choose the X-ray angiography run.</source>
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
        <source>its bits per pixel contradict each other. The header is damaged; export the run again.</source>
        <comment>dicom.bits-contradict</comment>
        <translation>每像素位数相互矛盾。文件头损坏；请重新导出。</translation>
    </message>
    <message>
        <source>it is stored in palette colours. Export the angiogram in grey.</source>
        <comment>dicom.palette-colours</comment>
        <translation>以调色板颜色存储。请以灰度导出造影图像。</translation>
    </message>
    <message>
        <source>its pixels (%1, %2 samples) are not grey or colour. Export the angiogram in grey.</source>
        <comment>dicom.not-grey</comment>
        <translation>像素（%1，%2 个采样）既非灰度也非彩色。请以灰度导出。</translation>
    </message>
    <message>
        <source>its pixels have %1 bits. Export the angiogram with 8 or 16 bits.</source>
        <comment>dicom.pixel-bits</comment>
        <translation>像素为 %1 位。请以 8 或 16 位导出。</translation>
    </message>
    <message>
        <source>its header gives no image size. The file is damaged; export the run again.</source>
        <comment>dicom.no-image-size</comment>
        <translation>文件头无图像尺寸。文件损坏；请重新导出。</translation>
    </message>
    <message>
        <source>it declares %1 frames of %2 x %3 pixels, more than this program holds. Export fewer frames.</source>
        <comment>dicom.too-many-frames</comment>
        <translation>声明 %1 帧、每帧 %2 x %3 像素，超出程序容量。请导出较少帧。</translation>
    </message>
    <message>
        <source>its pixels are cut short: %1 of %2 bytes are there. Copy or export it again.</source>
        <comment>dicom.pixels-cut-short</comment>
        <translation>像素被截断：%2 字节中仅有 %1。请重新复制或导出。</translation>
    </message>
    <message>
        <source>its compressed pixels are cut short. Copy or export it again.</source>
        <comment>dicom.packed-pixels-cut-short</comment>
        <translation>压缩像素被截断。请重新复制或导出。</translation>
    </message>
    <message>
        <source>only %1 of its %2 frames are there. Copy or export it again.</source>
        <comment>dicom.frames-missing</comment>
        <translation>%2 帧中仅有 %1 帧。请重新复制或导出。</translation>
    </message>
    <message>
        <source>frame %1 cannot be decoded (transfer syntax %2): damaged, cut short, or a compression this program does not read. Export the run again, uncompressed if possible.</source>
        <comment>dicom.frame-undecodable</comment>
        <translation>第 %1 帧无法解码（传输语法 %2）：损坏、截断或不支持的压缩。请重新导出，尽量不压缩。</translation>
    </message>
    <message>
        <source>Frames %1 of %2 cannot be decoded: they are shown empty, the others can be read. Export the run again where they matter.</source>
        <comment>dicom.frames-lost</comment>
        <translation>共 %2 帧，其中第 %1 帧无法解码：显示为空白，其余各帧可读。如需要这些帧，请重新导出。</translation>
    </message>
    <message>
        <source>Frames %1 of %2 are damaged in part: what could be decoded is shown. Compare them with another viewer before you use one.</source>
        <comment>dicom.frames-flawed</comment>
        <translation>共 %2 帧，其中第 %1 帧部分损坏：显示能够解码的部分。使用前请与其他阅片软件对照。</translation>
    </message>
    <message>
        <source>The image is damaged in part: what could be decoded is shown. Compare it with another viewer before you use it.</source>
        <comment>image.flawed</comment>
        <translation>图像部分损坏：显示能够解码的部分。使用前请与其他阅片软件对照。</translation>
    </message>
    <message>
        <source>it is only %1 x %2 pixels. Choose the angiogram at its full size.</source>
        <comment>dicom.thumbnail</comment>
        <translation>仅 %1 x %2 像素。请选择原尺寸造影图像。</translation>
    </message>
    <message>
        <source>This is %1, not X-ray angiography: it has no C-arm geometry.</source>
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
        <source>modality %1</source>
        <comment>dicom.modality</comment>
        <translation>模态 %1</translation>
    </message>
    <message>
        <source>an image without modality</source>
        <comment>dicom.no-modality</comment>
        <translation>未注明模态的图像</translation>
    </message>
    <message>
        <source>The header gives no imager pixel spacing: %1 is derived from the calibrated pixel spacing. Check it in the geometry.</source>
        <comment>dicom.spacing-from-calibration</comment>
        <translation>文件头无成像器像素间距：由校准像素间距推算为 %1。请在几何中核对。</translation>
    </message>
    <message>
        <source>The header gives no imager pixel spacing (0018,1164): %1 is derived from the field of view. Check it in the geometry.</source>
        <comment>dicom.spacing-from-field</comment>
        <translation>文件头无成像器像素间距（0018,1164）：由视野推算为 %1。请在几何中核对。</translation>
    </message>
    <message>
        <source>The header gives no imager pixel spacing (0018,1164): enter it in the geometry.</source>
        <comment>dicom.spacing-missing</comment>
        <translation>文件头无成像器像素间距（0018,1164）：请在几何中输入。</translation>
    </message>
    <message>
        <source>The header gives no imager pixel spacing (0018,1164): enter it in the geometry. The intensifier of %1 suggests at most %2.</source>
        <comment>dicom.spacing-missing-intensifier</comment>
        <translation>文件头无成像器像素间距（0018,1164）：请在几何中输入。 影像增强器 %1，提示最多 %2。</translation>
    </message>
    <message>
        <source>The header gives only isocentre angles (0018,9463), whose signs are not certain: enter LAO/RAO and CRA/CAU in the geometry.</source>
        <comment>dicom.angles-of-isocentre</comment>
        <translation>文件头仅有等中心角度（0018,9463），符号不确定：请在几何中输入 LAO/RAO 和 CRA/CAU。</translation>
    </message>
    <message>
        <source>The detector is tilted by %1 (0018,1530): the principal point is uncertain.</source>
        <comment>dicom.detector-tilted</comment>
        <translation>探测器倾斜 %1（0018,1530）：主点不确定。</translation>
    </message>
    <message>
        <source>The image is taken as mirrored, after %1. Check that left and right are where they belong.</source>
        <comment>dicom.image-mirrored</comment>
        <translation>根据 %1 视图像为镜像。请核对左右。</translation>
    </message>
    <message>
        <source>The C-arm moved during this run, but the header gives %1 for its %2 frames: the angles are those of the first frame. Check them for the frame you use.</source>
        <comment>dicom.gantry-moved</comment>
        <translation>采集中 C 形臂有移动，但文件头为 %2 帧只给出 %1：角度取自第一帧。请针对所用帧核对。</translation>
    </message>
    <message>
        <source>no angles</source>
        <comment>dicom.gantry-no-angles</comment>
        <translation>没有角度</translation>
    </message>
    <message>
        <source>%1</source>
        <comment>dicom.gantry-angles</comment>
        <translation>%1</translation>
    </message>
    <message>
        <source>What was traced is hardly longer than wide: check that it is a vessel.</source>
        <comment>vessels.compact</comment>
        <translation>提取结果的长度几乎不大于宽度：请检查是否为血管。</translation>
    </message>
    <message>
        <source>The vessels are %1 across, or of a width that is unusual: if the unit of the file is not the millimetre, give the unit.</source>
        <comment>vessels.unusual-size</comment>
        <translation>血管总跨度为 %1，或其宽度异常：若文件单位不是毫米，请给出单位。</translation>
    </message>
    <message>
        <source>this is no surface that this program reads. Choose a .vtp, .vtk, .stl, .ply or .obj file.</source>
        <comment>surface.unknown</comment>
        <translation>这不是本程序可读取的表面。请选择 .vtp、.vtk、.stl、.ply 或 .obj 文件。</translation>
    </message>
    <message>
        <source>this is %1, not a surface. Choose a .vtp, .vtk, .stl, .ply or .obj file.</source>
        <comment>surface.is-other</comment>
        <translation>这是%1，不是表面。请选择 .vtp、.vtk、.stl、.ply 或 .obj 文件。</translation>
    </message>
    <message>
        <source>it holds no triangles. Choose the surface of a vessel.</source>
        <comment>surface.no-triangles</comment>
        <translation>不含三角面。请选择血管表面。</translation>
    </message>
    <message>
        <source>none of its triangles has an area. Choose the surface of a vessel.</source>
        <comment>surface.no-area</comment>
        <translation>三角面均无面积。请选择血管表面。</translation>
    </message>
    <message>
        <source>it has more triangles than this program holds. Decimate the surface.</source>
        <comment>surface.too-large</comment>
        <translation>三角面超出程序容量。请简化表面。</translation>
    </message>
    <message>
        <source>a coordinate is not a number, or beyond a kilometre. Correct or export it again.</source>
        <comment>surface.coordinate</comment>
        <translation>坐标不是数字或超过一公里。请更正或重新导出。</translation>
    </message>
    <message>
        <source>a triangle refers to a point that does not exist. The file is damaged; export it again.</source>
        <comment>surface.bad-index</comment>
        <translation>三角面引用了不存在的点。文件损坏；请重新导出。</translation>
    </message>
    <message>
        <source>its triangles are damaged or cut short. Copy or export it again.</source>
        <comment>surface.cut-short</comment>
        <translation>三角面损坏或截断。请重新复制或导出。</translation>
    </message>
    <message>
        <source>surfaces are written as .stl. Change the extension.</source>
        <comment>surface.extension</comment>
        <translation>表面写为 .stl。请更改扩展名。</translation>
    </message>
    <message>
        <source>The surface is not closed (%1 open and %2 crowded edges): its inside is decided by majority. Check the result, or close the holes.</source>
        <comment>surface.open</comment>
        <translation>表面未闭合（%1 条开放边、%2 条重叠边）：内部按多数判定。请检查结果或封闭孔洞。</translation>
    </message>
    <message>
        <source>The triangles do not agree on inside and outside; overlapping parts may cancel out.</source>
        <comment>surface.disoriented</comment>
        <translation>三角面内外方向不一致；重叠部分可能抵消。</translation>
    </message>
    <message>
        <source>The surface is %1 across, which is unusual: if its unit is not the millimetre, give the unit.</source>
        <comment>surface.unusual-size</comment>
        <translation>表面跨度为 %1，不寻常：若单位不是毫米，请指定单位。</translation>
    </message>
    <message>
        <source>Points astray were left out with their triangles, since they cannot be of one body with the others: %1 (no numbers, or farther than %2 from the middle). Check the surface.</source>
        <comment>surface.stray-points</comment>
        <translation>已略去离群点及其三角形，因其不可能与其余部分属于同一身体：%1 个（非数值，或距中心超过 %2）。请检查该表面。</translation>
    </message>
    <message>
        <source>the surface is %1 across, larger than any body. Give the unit of the file, or remove points that lie astray.</source>
        <comment>surface.larger-than-body</comment>
        <translation>表面跨度为 %1，大于任何人体。请给出文件的单位，或去除远离的点。</translation>
    </message>
    <message>
        <source>line %1 does not give a point. The file is damaged; export it again.</source>
        <comment>surface.obj-bad-point</comment>
        <translation>第 %1 行不是点。文件损坏；请重新导出。</translation>
    </message>
    <message>
        <source>its PLY header is damaged or cut short. Export it again.</source>
        <comment>surface.ply-header-damaged</comment>
        <translation>PLY 文件头损坏或截断。请重新导出。</translation>
    </message>
    <message>
        <source>its PLY header is damaged: the element &quot;%1&quot; has no properties. Export it again.</source>
        <comment>surface.ply-element-empty</comment>
        <translation>PLY 文件头损坏：元素 &quot;%1&quot; 没有属性。请重新导出。</translation>
    </message>
    <message>
        <source>its PLY data are damaged or cut short, or a face has more than 255 corners. Export it again, as triangles.</source>
        <comment>surface.ply-data-damaged</comment>
        <translation>其 PLY 数据已损坏或不完整，或某个面超过 255 个角点。请重新导出为三角形。</translation>
    </message>
    <message>
        <source>this is %1, not a centreline. Choose a centreline file: .vtp, .vtk, .vtu, .csv, .swc or .mrk.json.</source>
        <comment>tree.is-other</comment>
        <translation>这是%1，不是中心线。请选择中心线文件：.vtp、.vtk、.vtu、.csv、.swc 或 .mrk.json。</translation>
    </message>
    <message>
        <source>this is no centreline format AngioPose reads. Choose a centreline file: .vtp, .vtk, .vtu, .csv, .swc or .mrk.json.</source>
        <comment>tree.format-unknown</comment>
        <translation>AngioPose 不支持此中心线格式。请选择中心线文件：.vtp、.vtk、.vtu、.csv、.swc 或 .mrk.json。</translation>
    </message>
    <message>
        <source>it does not begin like a VTK file. Export the centrelines again.</source>
        <comment>tree.no-vtk-beginning</comment>
        <translation>开头不像 VTK 文件。请重新导出中心线。</translation>
    </message>
    <message>
        <source>vessel trees are written as .vtp, .csv, .swc or .mrk.json. Change the extension.</source>
        <comment>tree.extension</comment>
        <translation>血管树可写为 .vtp、.csv、.swc 或 .mrk.json。请更改扩展名。</translation>
    </message>
    <message>
        <source>it has %1 points; a centreline tree has at most %2. Resample the centrelines.</source>
        <comment>tree.too-many-points</comment>
        <translation>有 %1 个点；中心线树最多 %2 个。请重采样中心线。</translation>
    </message>
    <message>
        <source>it has %1 separate lines; a centreline tree has at most %2. Keep the vessels of interest.</source>
        <comment>tree.too-many-lines</comment>
        <translation>有 %1 条独立线；中心线树最多 %2 条。请只保留感兴趣的血管。</translation>
    </message>
    <message>
        <source>it holds no lines. Choose a file with vessel centrelines.</source>
        <comment>tree.no-lines</comment>
        <translation>不含线。请选择含血管中心线的文件。</translation>
    </message>
    <message>
        <source>it holds a surface, not centrelines. Extract the centrelines first (e.g. with VMTK or Slicer) and open those.</source>
        <comment>tree.is-surface</comment>
        <translation>含表面而非中心线。请先提取中心线（如用 VMTK 或 Slicer）再打开。</translation>
    </message>
    <message>
        <source>a line refers to a point that does not exist. The file is damaged; export it again.</source>
        <comment>tree.bad-index</comment>
        <translation>线引用了不存在的点。文件损坏；请重新导出。</translation>
    </message>
    <message>
        <source>its lines visit the same points too often. The file is damaged; export it again.</source>
        <comment>tree.points-repeated</comment>
        <translation>线过多经过相同的点。文件损坏；请重新导出。</translation>
    </message>
    <message>
        <source>none of its lines has two different points. Choose a file with vessel centrelines.</source>
        <comment>tree.no-length</comment>
        <translation>没有一条线含两个不同的点。请选择含血管中心线的文件。</translation>
    </message>
    <message>
        <source>the third line of a legacy VTK file must be ASCII or BINARY. Export it again.</source>
        <comment>tree.vtk-third-line</comment>
        <translation>旧版 VTK 文件第三行须为 ASCII 或 BINARY。请重新导出。</translation>
    </message>
    <message>
        <source>it holds no data set, not POLYDATA or UNSTRUCTURED_GRID. Export the centrelines as poly-lines.</source>
        <comment>tree.vtk-no-data-set</comment>
        <translation>其中没有数据集，不是 POLYDATA 或 UNSTRUCTURED_GRID。请将中心线导出为折线。</translation>
    </message>
    <message>
        <source>it holds %1, not POLYDATA or UNSTRUCTURED_GRID. Export the centrelines as poly-lines.</source>
        <comment>tree.vtk-other-data-set</comment>
        <translation>含 %1，而非 POLYDATA 或 UNSTRUCTURED_GRID。请以折线导出中心线。</translation>
    </message>
    <message>
        <source>the section &quot;%1&quot; is damaged or cut short. Export it again.</source>
        <comment>tree.vtk-section-damaged</comment>
        <translation>&quot;%1&quot; 部分损坏或截断。请重新导出。</translation>
    </message>
    <message>
        <source>the VTK XML data in it is damaged or cut short. Export it again.</source>
        <comment>tree.vtk-xml-damaged</comment>
        <translation>其中的 VTK XML 数据损坏或截断。请重新导出。</translation>
    </message>
    <message>
        <source>it is not VTK XML PolyData or UnstructuredGrid. Export the centrelines as .vtp.</source>
        <comment>tree.vtk-xml-other</comment>
        <translation>不是 VTK XML PolyData 或 UnstructuredGrid。请导出为 .vtp。</translation>
    </message>
    <message>
        <source>it declares %1, which cannot be. The file is damaged; export it again.</source>
        <comment>tree.vtk-xml-impossible-count</comment>
        <translation>其声明为 %1，这不可能。文件已损坏；请重新导出。</translation>
    </message>
    <message>
        <source>it is not a Slicer markups file with curves. Export the centrelines as .mrk.json curves, .vtp, .vtk, .csv or .swc.</source>
        <comment>tree.markups-none</comment>
        <translation>不是含曲线的 Slicer markups 文件。请将中心线导出为 .mrk.json 曲线、.vtp、.vtk、.csv 或 .swc。</translation>
    </message>
    <message>
        <source>line %1 is not `id type x y z radius parent`. Correct the line or export it again.</source>
        <comment>tree.swc-line</comment>
        <translation>第 %1 行不是 `id type x y z radius parent`。请更正或重新导出。</translation>
    </message>
    <message>
        <source>line %1 repeats an id. Ids must be unique.</source>
        <comment>tree.swc-id-twice</comment>
        <translation>第 %1 行 id 重复。id 必须唯一。</translation>
    </message>
    <message>
        <source>line %1 names a parent, %2, that is not there. Export the whole tree.</source>
        <comment>tree.swc-parent-missing</comment>
        <translation>第 %1 行的父节点 %2 不存在。请导出整棵树。</translation>
    </message>
    <message>
        <source>the first line must name the columns: x,y,z and, where known, radius,branch.</source>
        <comment>tree.table-no-header</comment>
        <translation>首行须为列名：x,y,z 以及已知的 radius,branch。</translation>
    </message>
    <message>
        <source>the header row has no columns x, y and z. Name them (mm, patient LPS).</source>
        <comment>tree.table-no-columns</comment>
        <translation>表头缺少 x、y、z 列。请命名（mm，患者 LPS）。</translation>
    </message>
    <message>
        <source>it looks like a list of graph nodes (column id), which has no order along the vessels. Give a branch column, or export the centrelines themselves.</source>
        <comment>tree.table-is-graph</comment>
        <translation>像是图节点列表（id 列），没有沿血管的顺序。请给出 branch 列，或导出中心线本身。</translation>
    </message>
    <message>
        <source>there is no DICOM image in this folder. Choose the folder of a DICOM scan, or a volume file itself.</source>
        <comment>series.none</comment>
        <translation>此文件夹中没有 DICOM 图像。请选择 DICOM 扫描所在文件夹，或直接选择体数据文件。</translation>
    </message>
    <message>
        <source>this DICOM file holds no image. Choose a scan.</source>
        <comment>series.file-without-image</comment>
        <translation>此 DICOM 文件不含图像。请选择扫描。</translation>
    </message>
    <message>
        <source>the series %1 is not in this folder. Choose the folder it is in.</source>
        <comment>series.not-here</comment>
        <translation>序列 %1 不在此文件夹。请选择其所在文件夹。</translation>
    </message>
    <message>
        <source>the series of the case is not in this folder. Choose the folder it is in.</source>
        <comment>series.of-case-not-here</comment>
        <translation>病例的序列不在此文件夹。请选择其所在文件夹。</translation>
    </message>
    <message>
        <source>no series in this folder makes a volume. Choose another folder.</source>
        <comment>series.none-makes-volume</comment>
        <translation>此文件夹中没有序列可组成体数据。请选择其他文件夹。</translation>
    </message>
    <message>
        <source>it holds %1 volumes (%2). Choose one by its series id; `info` lists them.</source>
        <comment>series.several</comment>
        <translation>含 %1 个体数据（%2）。请按序列号选择；`info` 可列出。</translation>
    </message>
    <message>
        <source>this is an X-ray run, not a volume. Open it as the angiogram.</source>
        <comment>series.is-xray</comment>
        <translation>这是 X 线序列，不是体数据。请作为造影图像打开。</translation>
    </message>
    <message>
        <source>it is a DICOM segmentation. Export it as a NIfTI or NRRD label image.</source>
        <comment>series.is-segmentation</comment>
        <translation>是 DICOM 分割。请导出为 NIfTI 或 NRRD 标签图像。</translation>
    </message>
    <message>
        <source>it is a single slice, not a volume. Copy all slices of the series, or choose another one.</source>
        <comment>series.single-slice</comment>
        <translation>是单层而非体数据。请复制该序列全部层面，或另选。</translation>
    </message>
    <message>
        <source>its images do not say how large a pixel is, so they make no volume. Choose another series.</source>
        <comment>series.no-pixel-size</comment>
        <translation>图像未说明像素大小，无法组成体数据。请选择其他序列。</translation>
    </message>
    <message>
        <source>its images do not say where they lie in the patient, so they make no volume. Choose another series.</source>
        <comment>series.no-place</comment>
        <translation>图像未说明在患者中的位置，无法组成体数据。请选择其他序列。</translation>
    </message>
    <message>
        <source>its slices lie beside each other rather than above. Choose another series.</source>
        <comment>series.beside-each-other</comment>
        <translation>层面并排而非堆叠。请选择其他序列。</translation>
    </message>
    <message>
        <source>its slices lie too unevenly to make a volume of them (%1 over %2). Copy all slices of the series, or choose another one.</source>
        <comment>series.too-uneven</comment>
        <translation>层间距过于不均，无法组成体数据（%2 内 %1 层）。请复制全部层面，或另选。</translation>
    </message>
    <message>
        <source>it is a colour image. Choose the scan itself, in grey values.</source>
        <comment>series.colour</comment>
        <translation>是彩色图像。请选择灰度扫描本身。</translation>
    </message>
    <message>
        <source>its pixels are not of the size its header gives. Export it again.</source>
        <comment>series.slice-size</comment>
        <translation>像素尺寸与文件头不符。请重新导出。</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced (%1 to %2): resampled to %3.</source>
        <comment>series.uneven-slices</comment>
        <translation>层间距不均（%1 至 %2）：已重采样为 %3。</translation>
    </message>
    <message>
        <source>The slices are not stacked upright (%1 off, as with a tilted gantry): shifted within their planes to where they lie.</source>
        <comment>series.slanted</comment>
        <translation>层面未垂直堆叠（偏 %1，如机架倾斜）：已在面内平移到实际位置。</translation>
    </message>
    <message>
        <source>1 of %1 slices is missing (%2): filled in between their neighbours. Copy the series again if you can.</source>
        <comment>series.slice-missing</comment>
        <translation>%1 层中缺 1 层（%2）：已由相邻层插补。如可能请重新复制该序列。</translation>
    </message>
    <message>
        <source>%1 of %2 slices are missing (%3): filled in between their neighbours. Copy the series again if you can.</source>
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
        <translation>第 %1 层之后 等处</translation>
    </message>
    <message>
        <source>%1 of %2 slices lie where another one does; the first recorded of each is used.</source>
        <comment>series.overlap</comment>
        <translation>%2 层中 %1 层位置重复；采用最先采集的。</translation>
    </message>
    <message>
        <source>%1 files of the series are there twice.</source>
        <comment>series.files-twice</comment>
        <translation>该序列 %1 个文件重复。</translation>
    </message>
    <message>
        <source>%1 files of the series are damaged at their end.</source>
        <comment>series.files-damaged</comment>
        <translation>该序列 %1 个文件末尾损坏。</translation>
    </message>
    <message>
        <source>The series mixes images of %1 sizes or orientations; each is listed by itself.</source>
        <comment>series.mixed</comment>
        <translation>该序列混有 %1 种尺寸或方位的图像；已分别列出。</translation>
    </message>
    <message>
        <source>part %1 of %2</source>
        <comment>series.part</comment>
        <translation>第 %1 部分，共 %2</translation>
    </message>
    <message>
        <source>Its slices are stored with different scales or as float. %1</source>
        <comment>series.scales</comment>
        <translation>其层面以不同比例或浮点存储。%1</translation>
    </message>
    <message>
        <source>this is no volume that this program reads. Choose a DICOM folder, NIfTI, NRRD or MetaImage (.mha, .mhd).</source>
        <comment>volume.unknown</comment>
        <translation>这不是本程序可读取的体数据。请选择 DICOM 文件夹、NIfTI、NRRD 或 MetaImage（.mha、.mhd）。</translation>
    </message>
    <message>
        <source>this is %1, not a volume. Choose a DICOM folder, NIfTI, NRRD or MetaImage (.mha, .mhd).</source>
        <comment>volume.is-other</comment>
        <translation>这是%1，不是体数据。请选择 DICOM 文件夹、NIfTI、NRRD 或 MetaImage（.mha、.mhd）。</translation>
    </message>
    <message>
        <source>it holds a %1, not an image. Choose the scan.</source>
        <comment>volume.holds-other</comment>
        <translation>含 %1，而非图像。请选择扫描。</translation>
    </message>
    <message>
        <source>it declares %1, more than this program holds. Crop the scan to the vessels.</source>
        <comment>volume.declares</comment>
        <translation>声明 %1，超出程序容量。请将扫描裁剪到血管范围。</translation>
    </message>
    <message>
        <source>the volume is larger than this computer&apos;s memory. Crop the scan to the vessels.</source>
        <comment>volume.larger-than-memory</comment>
        <translation>体数据超过本机内存。请裁剪到血管范围。</translation>
    </message>
    <message>
        <source>it has %1: a single slice is no volume. Choose the whole scan.</source>
        <comment>volume.single-slice</comment>
        <translation>有 %1：单层不是体数据。请选择完整扫描。</translation>
    </message>
    <message>
        <source>it is %1-dimensional, but a volume has three dimensions. Choose the whole scan.</source>
        <comment>volume.not-three-dimensional</comment>
        <translation>为 %1 维，而体数据为三维。请选择完整扫描。</translation>
    </message>
    <message>
        <source>it has %1 dimensions (4-D or more). Save the one volume to use and open that.</source>
        <comment>volume.dimensions</comment>
        <translation>有 %1 维（四维或以上）。请单独保存所需体数据再打开。</translation>
    </message>
    <message>
        <source>it holds %1 volumes or values per voxel (4-D). Extract the one to use and open that.</source>
        <comment>volume.several-4d</comment>
        <translation>含 %1 个体数据或每体素多值（四维）。请提取所需的再打开。</translation>
    </message>
    <message>
        <source>it holds %1 volumes, layers or values per voxel (4-D). Save the one to use and open that.</source>
        <comment>volume.several-layers</comment>
        <translation>含 %1 个体数据、层或每体素多值（四维）。请单独保存所需的再打开。</translation>
    </message>
    <message>
        <source>it has %1 values per voxel. Choose the scan itself, in grey values.</source>
        <comment>volume.channels</comment>
        <translation>每体素有 %1 个值。请选择灰度扫描本身。</translation>
    </message>
    <message>
        <source>its first axis has %1 entries: this is a colour picture, not a volume. Choose the scan.</source>
        <comment>volume.colour-axis</comment>
        <translation>第一轴有 %1 项：这是彩色图片而非体数据。请选择扫描。</translation>
    </message>
    <message>
        <source>its voxels are colours. Choose the scan itself, in grey values.</source>
        <comment>volume.colours</comment>
        <translation>体素为彩色。请选择灰度扫描本身。</translation>
    </message>
    <message>
        <source>its header gives %1. The file is damaged; export it again.</source>
        <comment>volume.header-gives</comment>
        <translation>文件头给出 %1。文件损坏；请重新导出。</translation>
    </message>
    <message>
        <source>its header gives no usable voxel size or place. Export the volume again.</source>
        <comment>volume.no-place</comment>
        <translation>文件头无可用的体素大小或位置。请重新导出。</translation>
    </message>
    <message>
        <source>its header is damaged: it names %1 dimensions. Export it again.</source>
        <comment>volume.header-dimensions</comment>
        <translation>文件头损坏：标注 %1 维。请重新导出。</translation>
    </message>
    <message>
        <source>its header is damaged: the voxels begin at an impossible place. Export it again.</source>
        <comment>volume.impossible-start</comment>
        <translation>文件头损坏：体素起始位置不可能。请重新导出。</translation>
    </message>
    <message>
        <source>its axes are %1 apart instead of 90°. Resample the volume to perpendicular axes.</source>
        <comment>volume.skewed</comment>
        <translation>各轴夹角为 %1 而非 90°。请重采样到正交轴。</translation>
    </message>
    <message>
        <source>its header cannot be read (%1). Export it again.</source>
        <comment>volume.header-not-read</comment>
        <translation>文件头无法读取（%1）。请重新导出。</translation>
    </message>
    <message>
        <source>its %1 header cannot be read. Export it again.</source>
        <comment>volume.format-header-not-read</comment>
        <translation>其 %1 文件头无法读取。请重新导出。</translation>
    </message>
    <message>
        <source>its HeaderSize makes no sense. Correct the header.</source>
        <comment>volume.header-size</comment>
        <translation>HeaderSize 无意义。请更正文件头。</translation>
    </message>
    <message>
        <source>it does not say where its voxels are (ElementDataFile). Export it again.</source>
        <comment>volume.no-data-file</comment>
        <translation>未说明体素所在（ElementDataFile）。请重新导出。</translation>
    </message>
    <message>
        <source>its line skip or byte skip makes no sense. Correct the header.</source>
        <comment>volume.skips</comment>
        <translation>line skip 或 byte skip 无意义。请更正文件头。</translation>
    </message>
    <message>
        <source>it skips lines of another file. Save header and voxels as one file.</source>
        <comment>volume.skips-lines-elsewhere</comment>
        <translation>跳过了另一文件的行。请将文件头与体素保存为一个文件。</translation>
    </message>
    <message>
        <source>its voxels lie in several files. Save it as one file.</source>
        <comment>volume.several-files</comment>
        <translation>体素分在多个文件。请存为一个文件。</translation>
    </message>
    <message>
        <source>its voxel type (&quot;%1&quot;) is not read. Save it as 16-bit or float.</source>
        <comment>volume.voxel-type</comment>
        <translation>不支持体素类型（&quot;%1&quot;）。请存为 16 位或浮点。</translation>
    </message>
    <message>
        <source>its voxel type (NIfTI datatype %1) is not read. Save it as 16-bit or float.</source>
        <comment>volume.nifti-type</comment>
        <translation>不支持体素类型（NIfTI 类型 %1）。请存为 16 位或浮点。</translation>
    </message>
    <message>
        <source>its voxel type is not read. Save it as 16-bit or float.</source>
        <comment>volume.other-voxel-type</comment>
        <translation>不支持其体素类型。请存为 16 位或浮点。</translation>
    </message>
    <message>
        <source>its voxels are packed with bzip2. Save it with gzip or raw encoding.</source>
        <comment>volume.bzip2</comment>
        <translation>体素以 bzip2 压缩。请用 gzip 或 raw 编码保存。</translation>
    </message>
    <message>
        <source>its voxels are written as text (%1). Save it with gzip or raw encoding.</source>
        <comment>volume.text-encoding</comment>
        <translation>体素以文本写入（%1）。请用 gzip 或 raw 编码保存。</translation>
    </message>
    <message>
        <source>its voxels are written as text. Save it with binary data.</source>
        <comment>volume.text</comment>
        <translation>体素以文本写入。请以二进制保存。</translation>
    </message>
    <message>
        <source>its voxels are cut short, or their packing is damaged. Copy or export it again.</source>
        <comment>volume.packing-damaged</comment>
        <translation>体素被截断或压缩损坏。请重新复制或导出。</translation>
    </message>
    <message>
        <source>its voxels are cut short or damaged. Copy or export it again.</source>
        <comment>volume.voxels-damaged</comment>
        <translation>体素被截断或损坏。请重新复制或导出。</translation>
    </message>
    <message>
        <source>its voxels are cut short. Copy or export it again.</source>
        <comment>volume.cut-short</comment>
        <translation>体素被截断。请重新复制或导出。</translation>
    </message>
    <message>
        <source>its voxels are cut short: %1 of %2 bytes are there. Copy or export it again.</source>
        <comment>volume.cut-short-by</comment>
        <translation>体素被截断：%2 字节中仅有 %1。请重新复制或导出。</translation>
    </message>
    <message>
        <source>its voxels are in %1, which is not there. Copy both files together.</source>
        <comment>volume.voxels-not-there</comment>
        <translation>其体素在 %1 中，但该文件不存在。请将两个文件一起复制。</translation>
    </message>
    <message>
        <source>the file with its voxels cannot be read (%1).</source>
        <comment>volume.voxel-file-not-read</comment>
        <translation>无法读取体素文件（%1）。</translation>
    </message>
    <message>
        <source>its voxels begin with the header of another volume. Open that file itself, or give the bytes to skip: -1 where the voxels are the last ones.</source>
        <comment>volume.voxels-are-header</comment>
        <translation>其体素以另一个体数据的文件头开始。请直接打开该文件，或给出要跳过的字节数：体素位于末尾时为 -1。</translation>
    </message>
    <message>
        <source>none of its voxels is a number. Export the volume again.</source>
        <comment>volume.no-numbers</comment>
        <translation>没有体素是数字。请重新导出。</translation>
    </message>
    <message>
        <source>%1 voxels are not numbers; they are taken as the lowest value.</source>
        <comment>volume.not-numbers</comment>
        <translation>%1 个体素不是数字；按最低值处理。</translation>
    </message>
    <message>
        <source>The %1 voxels are rounded to 16 bit, in steps of %2.</source>
        <comment>volume.rounded</comment>
        <translation>%1 体素舍入为 16 位，步长 %2。</translation>
    </message>
    <message>
        <source>The header does not say how the axes lie in the patient: i to the left, j to the back and k to the head are assumed. Check left and right.</source>
        <comment>volume.axes-assumed</comment>
        <translation>文件头未说明轴向：假定 i 向左、j 向后、k 向头。请核对左右。</translation>
    </message>
    <message>
        <source>The header does not say how the voxels lie in the patient: +x right to left, +y front to back and +z up are assumed to be i, j reversed and k. Check left and right.</source>
        <comment>volume.voxels-assumed</comment>
        <translation>文件头未说明体素方位：假定 +x 右到左、+y 前到后、+z 向上分别为 i、反向 j 和 k。请核对左右。</translation>
    </message>
    <message>
        <source>The header gives no voxel size: 1 x 1 x 1 mm is assumed.</source>
        <comment>volume.size-assumed</comment>
        <translation>文件头无体素大小：假定为 1 x 1 x 1 mm。</translation>
    </message>
    <message>
        <source>The voxel size is given as 1 x 1 x 1 mm: check that it was not lost on the way.</source>
        <comment>volume.size-of-one</comment>
        <translation>体素大小为 1 x 1 x 1 mm：请确认未在转换中丢失。</translation>
    </message>
    <message>
        <source>NIfTI holds at most 32767 voxels along an axis. Write .nrrd or .mha.</source>
        <comment>volume.nifti-too-long</comment>
        <translation>NIfTI 每轴最多 32767 个体素。请写为 .nrrd 或 .mha。</translation>
    </message>
    <message>
        <source>volumes are written as .nii, .nii.gz, .nrrd or .mha. Change the extension.</source>
        <comment>volume.extension</comment>
        <translation>体数据写为 .nii、.nii.gz、.nrrd 或 .mha。请更改扩展名。</translation>
    </message>
    <message>
        <source>there are no voxels to write. Load a volume first.</source>
        <comment>volume.nothing-to-write</comment>
        <translation>没有可写入的体素。请先载入体数据。</translation>
    </message>
    <message>
        <source>there is no memory left to pack the volume.</source>
        <comment>volume.no-memory-to-pack</comment>
        <translation>内存不足，无法压缩体数据。</translation>
    </message>
    <message>
        <source>this DICOM file is no segmentation. Choose a label image.</source>
        <comment>labels.no-segmentation</comment>
        <translation>该 DICOM 文件不是分割结果。请选择标签图像。</translation>
    </message>
    <message>
        <source>it has one plane: a single slice is no volume. Choose the whole segmentation.</source>
        <comment>labels.one-plane</comment>
        <translation>它只有一个平面：单个切片不是体数据。请选择完整的分割。</translation>
    </message>
    <message>
        <source>it holds %1, which is no label: labels are whole numbers from 0. Choose a label image.</source>
        <comment>labels.no-whole-number</comment>
        <translation>含 %1，不是标签：标签为从 0 起的整数。请选择标签图像。</translation>
    </message>
    <message>
        <source>nothing is marked in it: every voxel is background. Choose another segmentation.</source>
        <comment>labels.nothing-marked</comment>
        <translation>其中没有标记：所有体素均为背景。请选择其他分割。</translation>
    </message>
    <message>
        <source>it has no label %1 but %2. Choose one of these.</source>
        <comment>labels.no-such-number</comment>
        <translation>它没有标签 %1，只有 %2。请从中选择。</translation>
    </message>
    <message>
        <source>it has no label &quot;%1&quot; but %2. Choose one of these.</source>
        <comment>labels.no-such-name</comment>
        <translation>它没有标签“%1”，只有 %2。请从中选择。</translation>
    </message>
    <message>
        <source>none at all</source>
        <comment>labels.none</comment>
        <translation>完全没有标签</translation>
    </message>
    <message>
        <source>Labels traced: %1.</source>
        <comment>labels.traced</comment>
        <translation>已追踪的标签：%1。</translation>
    </message>
    <message>
        <source>Labels left out, by their names: %1.</source>
        <comment>labels.left-out</comment>
        <translation>按名称略去的标签：%1。</translation>
    </message>
    <message>
        <source>The volume holds labels: its vessels are taken as they are marked.</source>
        <comment>labels.volume-holds-labels</comment>
        <translation>体数据为标签：血管按标记采用。</translation>
    </message>
    <message>
        <source>A length at the vessels needs their depth: open the vessels, or measure at the detector or in pixels.</source>
        <comment>measure.needs-vessels</comment>
        <translation>血管处的长度需要其深度：请打开血管，或在探测器处或以像素测量。</translation>
    </message>
    <message>
        <source>The vessels lie behind the source: nothing can be measured at them. Correct the pose, or measure in pixels.</source>
        <comment>measure.behind-source</comment>
        <translation>血管位于射线源后方：无法在该处测量。请修正位姿，或以像素测量。</translation>
    </message>
    <message>
        <source>The pixel spacing of the detector is not known. Type it in the geometry, or measure in pixels.</source>
        <comment>measure.needs-spacing</comment>
        <translation>探测器的像素间距未知。请在几何中输入，或以像素测量。</translation>
    </message>
    <message>
        <source>A measurement of this kind has %1 points at least; this one has %2. Draw it again.</source>
        <comment>measure.points</comment>
        <translation>此类测量至少有 %1 个点；此处为 %2 个。请重新绘制。</translation>
    </message>
    <message>
        <source>A point of the measurement is not a number. Draw it again.</source>
        <comment>measure.not-finite</comment>
        <translation>测量的某个点不是数字。请重新绘制。</translation>
    </message>
    <message>
        <source>The angle has a leg without length. Move its points apart.</source>
        <comment>measure.angle-open</comment>
        <translation>该角有一条边长度为零。请移开各点。</translation>
    </message>
    <message>
        <source>The outline crosses itself: its area means nothing. Move its points.</source>
        <comment>measure.crossed</comment>
        <translation>轮廓自相交：面积没有意义。请移动各点。</translation>
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
        <translation>%1（比例为假定）</translation>
    </message>
    <message>
        <source>At the depth of the vessels&apos; centroid, %1 from the source, a pixel is %2. What runs towards the source or away from it is longer than it looks.</source>
        <comment>measure.basis-vessels</comment>
        <translation>在血管质心的深度（距射线源 %1），一个像素为 %2。朝向或背离射线源的走行比看起来更长。</translation>
    </message>
    <message>
        <source>On the detector a pixel is %1; in the patient everything is smaller, by the magnification.</source>
        <comment>measure.basis-detector</comment>
        <translation>在探测器上一个像素为 %1；在患者体内一切更小，相差放大倍数。</translation>
    </message>
    <message>
        <source>In pixels of the image: nothing is said of the patient.</source>
        <comment>measure.basis-pixels</comment>
        <translation>以图像像素计：不涉及患者体内尺寸。</translation>
    </message>
    <message>
        <source>As projected: in space the angle is another one.</source>
        <comment>measure.basis-angle</comment>
        <translation>为投影角：空间中的角度不同。</translation>
    </message>
    <message>
        <source>Pixels are taken to be square.</source>
        <comment>measure.square-pixels</comment>
        <translation>像素视为正方形。</translation>
    </message>
    <message>
        <source>The geometry behind this scale is assumed, not measured: the number may be wrong by the same share.</source>
        <comment>measure.scale-assumed</comment>
        <translation>此比例所依据的几何是假定的，而非测得：数值可能有相同比例的误差。</translation>
    </message>
    <message>
        <source>The geometry behind this scale was typed.</source>
        <comment>measure.scale-typed</comment>
        <translation>此比例所依据的几何为手动输入。</translation>
    </message>
    <message>
        <source>No registration found this pose: how deep the vessels lie is as it was set.</source>
        <comment>measure.depth-unchecked</comment>
        <translation>此位姿并非由配准得到：血管深度为设定值。</translation>
    </message>
    <message>
        <source>The registration behind this pose is not trustworthy: nor is the depth of the vessels.</source>
        <comment>measure.pose-doubtful</comment>
        <translation>此位姿背后的配准不可信：血管深度亦然。</translation>
    </message>
    <message>
        <source>Their depth is known to ±%1 (1-σ): ±%2 of the length.</source>
        <comment>measure.depth-spread</comment>
        <translation>其深度的不确定度为 ±%1（1-σ）：长度的 ±%2。</translation>
    </message>
    <message>
        <source>a measurement of this kind has %1 points at least, not %2. Add them or remove the measurement.</source>
        <comment>case.measurement-points</comment>
        <translation>此类测量至少有 %1 个点，而非 %2 个。请补充或移除该测量。</translation>
    </message>
    <message>
        <source>Branch %1 has no length that could be measured along. Trace it again.</source>
        <comment>measure.branch-no-length</comment>
        <translation>分支 %1 没有可测量的长度。请重新提取。</translation>
    </message>
    <message>
        <source>This branch has no radii: its diameter is not known. Trace a scan, or open a tree with radii.</source>
        <comment>measure.branch-no-radii</comment>
        <translation>此分支没有半径：直径未知。请提取扫描，或打开带半径的血管树。</translation>
    </message>
    <message>
        <source>No part of this branch is even enough to be a reference: no narrowing is given.</source>
        <comment>measure.branch-no-reference</comment>
        <translation>此分支没有足够均匀的部分可作参考：不给出狭窄。</translation>
    </message>
    <message>
        <source>No scale was typed for this image. Type what a pixel measures, or measure in pixels.</source>
        <comment>measure.needs-typed-scale</comment>
        <translation>此图像未输入比例。请输入一个像素的长度，或以像素测量。</translation>
    </message>
    <message>
        <source>%1 by the typed scale</source>
        <comment>measure.by-typed</comment>
        <translation>按输入比例 %1</translation>
    </message>
    <message>
        <source>A pixel is %1, as typed for this image. It holds where that was measured, at its depth alone.</source>
        <comment>measure.basis-typed</comment>
        <translation>按为此图像输入的值，一个像素为 %1。仅在其测得处的深度成立。</translation>
    </message>
    <message>
        <source>Not pointed at in this frame: choose Seen here, and click where it is seen.</source>
        <comment>check.not-seen</comment>
        <translation>在此帧中未指出：选择“见于此处”，然后点击所见位置。</translation>
    </message>
    <message>
        <source>Pointed at in frame %1; the pose is of frame %2. Show that frame, or point at it here.</source>
        <comment>check.other-frame</comment>
        <translation>在第 %1 帧指出；位姿属于第 %2 帧。请显示该帧，或在此处指出。</translation>
    </message>
    <message>
        <source>It lies behind the source at this pose. Correct the pose.</source>
        <comment>check.behind-source</comment>
        <translation>在此位姿下它位于射线源之后。请修正位姿。</translation>
    </message>
    <message>
        <source>In the image plane at its depth (%1 from the source): %2, %3. A pixel is %4 there: no click is finer.</source>
        <comment>check.image-error</comment>
        <translation>在其深度的图像平面内（距射线源 %1）：%2，%3。该处一个像素为 %4：点击不会更精细。</translation>
    </message>
    <message>
        <source>The pose&apos;s own covariance expects %1 there (1-σ).</source>
        <comment>check.claimed</comment>
        <translation>位姿自身的协方差预期该处为 %1（1-σ）。</translation>
    </message>
    <message>
        <source>No registration found this pose: nothing is claimed of it.</source>
        <comment>check.nothing-claimed</comment>
        <translation>此位姿并非由配准得到：对其没有任何声称。</translation>
    </message>
    <message>
        <source>With the vessels bent: %1.</source>
        <comment>check.bent</comment>
        <translation>血管弯曲后：%1。</translation>
    </message>
    <message>
        <source>In space, where the rays of views %1 meet (%2 between them): %3. The rays pass each other by %4.</source>
        <comment>check.space-error</comment>
        <translation>在空间中，视图 %1 的射线相交处（夹角 %2）：%3。射线彼此错开 %4。</translation>
    </message>
    <message>
        <source>An error in space needs the point seen in two views: only one tells of it so far.</source>
        <comment>check.needs-two-views</comment>
        <translation>空间误差需要在两个视图中看到该点：目前至多一个。</translation>
    </message>
    <message>
        <source>The views look at it from nearly the same side (%1 between the rays): its depth cannot be told.</source>
        <comment>check.rays-alike</comment>
        <translation>各视图几乎从同一侧观察它（射线夹角 %1）：无法确定其深度。</translation>
    </message>
    <message>
        <source>%1 off</source>
        <comment>check.label</comment>
        <translation>偏差 %1</translation>
    </message>
    <message>
        <source>%1 off, %2 claimed</source>
        <comment>check.label-claimed</comment>
        <translation>偏差 %1，声称 %2</translation>
    </message>
    <message>
        <source>⌀ %1</source>
        <comment>check.ring-width</comment>
        <translation>⌀ %1</translation>
    </message>
    <message>
        <source>This branch has no radius here: a ring would have no size. Set a check point instead.</source>
        <comment>check.ring-needs-radius</comment>
        <translation>该分支在此处没有半径：环将没有大小。请改设检查点。</translation>
    </message>
    <message>
        <source>Click on the vessels: a check point or a ring lies on them.</source>
        <comment>check.needs-vessels</comment>
        <translation>请点击血管：检查点或环位于血管上。</translation>
    </message>
    <message>
        <source>At x %1, y %2, z %3 of the patient.</source>
        <comment>check.place</comment>
        <translation>位于患者坐标 x %1，y %2，z %3。</translation>
    </message>
    <message>
        <source>two marks have the number %1. Give each its own.</source>
        <comment>case.mark-twice</comment>
        <translation>两个标记的编号均为 %1。请为每个指定不同编号。</translation>
    </message>
    <message>
        <source>a ring needs a radius above 0 and a direction. Add them or remove it.</source>
        <comment>case.ring-open</comment>
        <translation>环需要大于 0 的半径和方向。请补充或移除。</translation>
    </message>
    <message>
        <source>an arrow has two points, a text one. Mend the points or remove it.</source>
        <comment>case.annotation-points</comment>
        <translation>箭头有两个点，文字有一个。请修正这些点或移除。</translation>
    </message>
    <message>
        <source>Scan voxels of %1 × %2 × %3.</source>
        <comment>measure.basis-scan</comment>
        <translation>扫描体素 %1 × %2 × %3。</translation>
    </message>
    <message>
        <source>Scan voxels; the scan is not open, so that their size is not known here.</source>
        <comment>measure.basis-scan-away</comment>
        <translation>扫描体素；扫描未打开，此处不知其大小。</translation>
    </message>
    <message>
        <source>In the plane of the slice: legs that leave it make another angle in space.</source>
        <comment>measure.basis-scan-angle</comment>
        <translation>位于切片平面内：离开该平面的边在空间中形成的角度不同。</translation>
    </message>
    <message>
        <source>it is a report, not an image.</source>
        <comment>study.report</comment>
        <translation>这是报告，不是图像。</translation>
    </message>
    <message>
        <source>it only says how other images are shown.</source>
        <comment>study.presentation</comment>
        <translation>它只说明其他图像如何显示。</translation>
    </message>
    <message>
        <source>it holds no image (%1).</source>
        <comment>study.no-image</comment>
        <translation>其中没有图像（%1）。</translation>
    </message>
    <message>
        <source>it is a scout, which planned the scan: neither a volume nor an angiogram.</source>
        <comment>study.scout</comment>
        <translation>这是用于计划扫描的定位像：既非容积也非造影图像。</translation>
    </message>
    <message>
        <source>its frames are packed as a video, which is not read. Export it in another way.</source>
        <comment>study.video</comment>
        <translation>其帧以视频方式压缩，无法读取。请以其他方式导出。</translation>
    </message>
    <message>
        <source>in images of modality %1 no vessels are traced.</source>
        <comment>study.modality</comment>
        <translation>不在 %1 模态的图像中提取血管。</translation>
    </message>
    <message>
        <source>the DICOMDIR lists it, but its files are not there.</source>
        <comment>study.missing</comment>
        <translation>DICOMDIR 列出了它，但文件不存在。</translation>
    </message>
    <message>
        <source>it has no list of files</source>
        <comment>directory.no-records</comment>
        <translation>其中没有文件列表</translation>
    </message>
    <message>
        <source>its records do not lead to each other</source>
        <comment>directory.torn</comment>
        <translation>其记录未能相互连接</translation>
    </message>
    <message>
        <source>it ends in the middle of a record</source>
        <comment>directory.unfinished</comment>
        <translation>它在记录中间结束</translation>
    </message>
    <message>
        <source>movies are written as .mp4 or .gif. Choose one of these.</source>
        <comment>movie.kind</comment>
        <translation>影片以 .mp4 或 .gif 格式写出。请选择其一。</translation>
    </message>
    <message>
        <source>a movie has %1 pixels on a side at least. Choose a larger size.</source>
        <comment>movie.too-small</comment>
        <translation>影片每边至少 %1 像素。请选择更大的尺寸。</translation>
    </message>
    <message>
        <source>MP4 holds no pictures of %1 × %2 pixels: 9,437,184 at most (4096 × 2304), and 8688 on a side. Choose a smaller size, or GIF.</source>
        <comment>movie.too-large</comment>
        <translation>MP4 不能容纳 %1 × %2 像素的图片：最多 9,437,184 像素（4096 × 2304），每边最多 8688。请选择更小的尺寸或 GIF。</translation>
    </message>
    <message>
        <source>a GIF of %1 × %2 pixels is not written: %3 on a side at most. Choose a smaller size.</source>
        <comment>movie.gif-too-large</comment>
        <translation>不写出 %1 × %2 像素的 GIF：每边最多 %3。请选择更小的尺寸。</translation>
    </message>
    <message>
        <source>the pictures of a movie must be equally large.</source>
        <comment>movie.sizes-differ</comment>
        <translation>影片的图片大小必须相同。</translation>
    </message>
    <message>
        <source>the movie could not be encoded. Choose another size, or GIF.</source>
        <comment>movie.encoder-failed</comment>
        <translation>影片无法编码。请选择其他尺寸或 GIF。</translation>
    </message>
    <message>
        <source>the movie would be larger than 1 GB. Choose fewer frames or a smaller size.</source>
        <comment>movie.too-long</comment>
        <translation>影片将超过 1 GB。请选择更少的帧或更小的尺寸。</translation>
    </message>
    <message>
        <source>the movie could not be written. Choose another size or format.</source>
        <comment>movie.not-made</comment>
        <translation>影片无法写出。请选择其他尺寸或格式。</translation>
    </message>
    <message>
        <source>The report template %1 cannot be read: it is a text in UTF-8 of at most 1 MB. Choose another one, or the built-in one.</source>
        <comment>report.template-unreadable</comment>
        <translation>无法读取报告模板 %1：模板是不超过 1 MB 的 UTF-8 文本。请选择其他模板或内置模板。</translation>
    </message>
    <message>
        <source>The report template lacks %1. Without it a report could keep back what must be read with the result: add it.</source>
        <comment>report.template-lacks</comment>
        <translation>报告模板缺少 %1。没有它，报告可能隐瞒必须与结果一并阅读的内容：请补上。</translation>
    </message>
    <message>
        <source>The report template has %1, which nothing fills in. Known are %2.</source>
        <comment>report.template-unknown</comment>
        <translation>报告模板含有 %1，没有内容可填入。已知的有 %2。</translation>
    </message>
    <message>
        <source>The report template has “%1”, by which a report could fetch or run something. Take it out.</source>
        <comment>report.template-fetches</comment>
        <translation>报告模板含有“%1”，报告可能借此加载或运行其他内容。请将其删除。</translation>
    </message>
    <message>
        <source>The picture %1 of the report template cannot be read. Put it beside the template, as PNG or JPEG of at most 16 MB and 8192 pixels a side.</source>
        <comment>report.template-picture</comment>
        <translation>无法读取报告模板的图片 %1。请将其放在模板旁边，格式为 PNG 或 JPEG，不超过 16 MB，每边不超过 8192 像素。</translation>
    </message>
    <message>
        <source>the pictures together are more than a DICOM object may hold. Choose a smaller width or fewer frames.</source>
        <comment>object.too-large</comment>
        <translation>这些图片的总量超过一个 DICOM 对象所能容纳的大小。请选择较小的宽度或较少的帧。</translation>
    </message>
    <message>
        <source>this is not a PDF. Export the report as PDF first.</source>
        <comment>object.no-pdf</comment>
        <translation>这不是 PDF。请先将报告导出为 PDF。</translation>
    </message>
    <message>
        <source>a presentation state refers to a DICOM image, and the angiogram is none that can be referred to. Open it as DICOM, or leave the presentation state out.</source>
        <comment>object.no-reference</comment>
        <translation>显示状态须引用一幅 DICOM 图像，而此血管造影不是可引用的图像。请以 DICOM 打开，或不导出显示状态。</translation>
    </message>
    <message>
        <source>no vessels lie on the image. Move them there first, or leave the presentation state out.</source>
        <comment>object.no-lines</comment>
        <translation>图像上没有血管。请先将血管移到图像上，或不导出显示状态。</translation>
    </message>
    <message>
        <source>the pose is not a rigid motion of finite numbers. Reset the pose first.</source>
        <comment>object.pose-not-rigid</comment>
        <translation>该位姿不是由有限数值构成的刚性运动。请先重置位姿。</translation>
    </message>
    <message>
        <source>no vessel lies in the scan. Check that scan and vessels are of one patient, or leave the segmentation out.</source>
        <comment>object.no-voxels</comment>
        <translation>扫描中没有血管。请检查扫描与血管是否属于同一患者，或不导出分割。</translation>
    </message>
    <message>
        <source>nothing was measured and nothing registered. Do one of these first, or leave the measurements out.</source>
        <comment>object.nothing-measured</comment>
        <translation>既没有测量，也没有配准。请先完成其中之一，或不导出测量。</translation>
    </message>
    <message>
        <source>this DICOM file holds no registration of one frame of reference to another. Choose a spatial registration.</source>
        <comment>pose.no-registration</comment>
        <translation>此 DICOM 文件不含一个参考坐标系到另一个的配准。请选择空间配准。</translation>
    </message>
    <message>
        <source>a segmentation needs the scan or the mask that the vessels come from. Open it first, or leave the segmentation out.</source>
        <comment>dicom-export.no-scan</comment>
        <translation>分割需要血管所来自的扫描或掩模。请先打开，或不导出分割。</translation>
    </message>
    <message>
        <source>reports are written by the program angiopose, which is not at &apos;%1&apos;. Install the window&apos;s program beside angiopose-cli, or build its target angiopose.</source>
        <comment>report.program-missing</comment>
        <translation>报告由程序 angiopose 写出，但“%1”处没有它。请将窗口程序安装在 angiopose-cli 旁，或构建其目标 angiopose。</translation>
    </message>
    <message>
        <source>The program angiopose was ended by signal %1; no report was written. angiopose-cli support-bundle gathers what tells why.</source>
        <comment>report.program-fault</comment>
        <translation>程序 angiopose 被信号 %1 终止；未写出报告。angiopose-cli support-bundle 可收集说明原因的信息。</translation>
    </message>
    <message>
        <source>the report is written. It says that this pose is not trustworthy, and why.</source>
        <comment>report.distrusted</comment>
        <translation>报告已写出。其中说明此位姿不可信及其原因。</translation>
    </message>
    <message>
        <source>stopped; no report was written.</source>
        <comment>report.stopped</comment>
        <translation>已停止；未写出报告。</translation>
    </message>
    <message>
        <source>a report is made by angiopose-cli report, or by the window. Give its PDF by --report, or leave it out.</source>
        <comment>dicom-export.no-report</comment>
        <translation>报告由 angiopose-cli report 或窗口生成。请用 --report 给出其 PDF，或不导出。</translation>
    </message>
    <message>
        <source>Left out: %1: %2</source>
        <comment>dicom-export.left-out</comment>
        <translation>未导出：%1：%2</translation>
    </message>
    <message>
        <source>The angiogram is no DICOM image: its objects begin a study of their own, without a patient.</source>
        <comment>dicom-export.new-study</comment>
        <translation>此血管造影不是 DICOM 图像：其对象自成一个检查，不含患者。</translation>
    </message>
    <message>
        <source>The scan is no DICOM series: its segmentation refers to none and has a frame of reference of its own.</source>
        <comment>dicom-export.no-scan-study</comment>
        <translation>此扫描不是 DICOM 序列：其分割不引用任何序列，并有自己的参考坐标系。</translation>
    </message>
    <message>
        <source>A spatial registration is a rigid matrix alone: it cannot hold the perspective camera, without which it gives no overlay. That stands in its private elements and in camera.json beside it.</source>
        <comment>dicom-export.rigid-only</comment>
        <translation>空间配准只是一个刚性矩阵：它无法保存透视相机，而没有相机就得不到叠加图。相机保存在其私有元素和旁边的 camera.json 中。</translation>
    </message>
    <message>
        <source>The presentation state shows the image as it is stored, not subtracted: its grey values are others than here.</source>
        <comment>dicom-export.treated</comment>
        <translation>显示状态按存储的样子显示图像，未经减影：其灰度值与此处不同。</translation>
    </message>
    <message>
        <source>this case allows none of the objects. Open vessels and an angiogram first.</source>
        <comment>dicom-export.nothing</comment>
        <translation>此病例无法导出任何对象。请先打开血管和血管造影。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is unknown. Use %2.</source>
        <comment>dicom-export.kind-unknown</comment>
        <translation>“%1”未知。请使用 %2。</translation>
    </message>
    <message>
        <source>stopped; nothing was written.</source>
        <comment>dicom-export.stopped</comment>
        <translation>已停止；未写出任何内容。</translation>
    </message>
    <message>
        <source>Vessels of a registered 3-D tree drawn over the image, window and size as chosen</source>
        <comment>dicom-export.derivation</comment>
        <translation>在图像上绘制已配准三维血管树的血管，窗宽窗位和大小按所选</translation>
    </message>
    <message>
        <source>No registration is known that led to this pose. Register first.</source>
        <comment>movie.no-history</comment>
        <translation>没有得出此位姿的配准记录。请先配准。</translation>
    </message>
    <message>
        <source>stopped before the movie was whole. Nothing was written.</source>
        <comment>movie.stopped</comment>
        <translation>影片尚未完成即已停止。未写出任何内容。</translation>
    </message>
    <message>
        <source>pose of frame %1</source>
        <comment>movie.pose-of-frame</comment>
        <translation>第 %1 帧的位姿</translation>
    </message>
    <message>
        <source>pose followed to this frame</source>
        <comment>movie.followed</comment>
        <translation>跟踪到此帧的位姿</translation>
    </message>
    <message>
        <source>pose followed to this frame · not trustworthy</source>
        <comment>movie.followed-distrusted</comment>
        <translation>跟踪到此帧的位姿 · 不可信</translation>
    </message>
    <message>
        <source>step %1 of %2 · median %3</source>
        <comment>movie.step</comment>
        <translation>第 %1 步，共 %2 步 · 中位数 %3</translation>
    </message>
    <message>
        <source>step %1 of %2 · median %3 · its result is not trustworthy</source>
        <comment>movie.step-distrusted</comment>
        <translation>第 %1 步，共 %2 步 · 中位数 %3 · 其结果不可信</translation>
    </message>
    <message>
        <source>seen from the front, turned by %1</source>
        <comment>movie.turned</comment>
        <translation>从前方观察，旋转 %1</translation>
    </message>
    <message>
        <source>it cannot be written: it would be larger than files may be here, by a limit of the system (ulimit -f) or of the drive. Raise the limit or choose another folder.</source>
        <comment>file.beyond-limit</comment>
        <translation>无法写入：它会超过此处文件允许的大小，这是系统（ulimit -f）或驱动器的限制。请提高限制，或选择另一个文件夹。</translation>
    </message>
    <message>
        <source>it was changed elsewhere since it was opened here. Save under another name, or open it again.</source>
        <comment>case.changed-elsewhere</comment>
        <translation>自在此处打开以来，它已在别处被更改。请以另一名称保存，或重新打开。</translation>
    </message>
    <message>
        <source>it is open elsewhere too: process %1 on %2. Save under another name, or close it there.</source>
        <comment>case.open-elsewhere</comment>
        <translation>它也在别处打开：%2 上的进程 %1。请以另一名称保存，或在那里将其关闭。</translation>
    </message>
    <message>
        <source>it lists no cases. Begin it with a header row that has the column case, and one of reference and pairs; a row for each case.</source>
        <comment>own.no-header</comment>
        <translation>未列出任何病例。请以表头行开始，包含 case 列以及 reference 或 pairs 列；每个病例一行。</translation>
    </message>
    <message>
        <source>line %1 names no case. Write the path of a case file into the column case.</source>
        <comment>own.no-case</comment>
        <translation>第 %1 行没有指定病例。请在 case 列写入病例文件的路径。</translation>
    </message>
    <message>
        <source>line %1 has no truth. Name a pose in the column reference, or a table of pairs of points in pairs.</source>
        <comment>own.no-truth</comment>
        <translation>第 %1 行没有真值。请在 reference 列指定位姿，或在 pairs 列指定点对表。</translation>
    </message>
    <message>
        <source>line %1 says in the column bent where the vessels lay. That needs a pose in reference to see them with, and leaves no landmarks, for these would have to bend, too.</source>
        <comment>own.bent-alone</comment>
        <translation>第 %1 行在 bent 列给出了血管的真实位置。这需要 reference 列中的位姿来观察它们，且不能同时给出标志点，因为标志点也必须随之弯曲。</translation>
    </message>
    <message>
        <source>its branches are not those of the case&apos;s vessels, with as many points each. Bent vessels are judged point by point: move the points of the case&apos;s own vessel file.</source>
        <comment>own.bent-other</comment>
        <translation>其分支与病例血管的分支及各分支的点数不一致。弯曲的血管逐点评判：请移动病例自身血管文件的点。</translation>
    </message>
    <message>
        <source>line %1: &apos;%2&apos; cannot be a condition&apos;s name, for files are called by it. Use letters, digits, dots, dashes and underscores.</source>
        <comment>own.condition-name</comment>
        <translation>第 %1 行：&apos;%2&apos; 不能作为条件名称，因为文件以其命名。请使用字母、数字、点、连字符和下划线。</translation>
    </message>
    <message>
        <source>a column is called pose. without a name after the dot. Name what found these poses.</source>
        <comment>own.pose-without-name</comment>
        <translation>有一列名为 pose. 但点后没有名称。请写明这些位姿由什么得到。</translation>
    </message>
    <message>
        <source>it has no column %1. Landmarks need x, y, z (mm, LPS), pairs of points u and v (px) besides.</source>
        <comment>own.point-column-missing</comment>
        <translation>缺少列 %1。标志点需要 x、y、z（mm，LPS），点对还需要 u 和 v（px）。</translation>
    </message>
    <message>
        <source>it holds no points.</source>
        <comment>own.no-points</comment>
        <translation>其中没有点。</translation>
    </message>
    <message>
        <source>it has no column %1: it is no log of blind trials, or one of an earlier version that did not keep the centroid. Such logs are written by Registration, Blind trial.</source>
        <comment>observers.column-missing</comment>
        <translation>缺少列 %1：这不是盲法试验日志，或来自未保存质心的早期版本。此类日志由 配准 → 盲法试验 写出。</translation>
    </message>
    <message>
        <source>The logs hold no two finished trials of one image, so nothing can be compared. Let an observer repeat a trial, or another one do it.</source>
        <comment>observers.too-few</comment>
        <translation>日志中没有同一图像的两次已完成试验，因此无法比较。请让观察者重复试验，或由另一人进行。</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no key of %2. It knows: %3.</source>
        <comment>study.unknown-key</comment>
        <translation>&apos;%1&apos; 不是 %2 的键。已知的键：%3。</translation>
    </message>
    <message>
        <source>%1 lacks &apos;%2&apos;.</source>
        <comment>study.missing-key</comment>
        <translation>%1 缺少 &apos;%2&apos;。</translation>
    </message>
    <message>
        <source>&apos;%1&apos; of %2 cannot be this: %3.</source>
        <comment>study.wrong-value</comment>
        <translation>%2 的 &apos;%1&apos; 不能是：%3。</translation>
    </message>
    <message>
        <source>it is no study. Begin it with &quot;format&quot;: &quot;angiopose-study&quot;, &quot;version&quot;: 1.</source>
        <comment>study.no-study</comment>
        <translation>这不是研究文件。请以 &quot;format&quot;: &quot;angiopose-study&quot;, &quot;version&quot;: 1 开头。</translation>
    </message>
    <message>
        <source>two settings are called &apos;%1&apos;. Give each a name of its own: folders are called by it.</source>
        <comment>study.name-twice</comment>
        <translation>有两个设置都名为 &apos;%1&apos;。请为每个设置取不同名称：文件夹以其命名。</translation>
    </message>
    <message>
        <source>&apos;%1&apos; of %2 must lie between %3 and %4.</source>
        <comment>study.out-of-range</comment>
        <translation>%2 的 &apos;%1&apos; 必须在 %3 与 %4 之间。</translation>
    </message>
    <message>
        <source>`evaluate own` needs one table of cases and what is known of them: angiopose-cli evaluate own CASES.csv --output FOLDER.</source>
        <comment>evaluate.no-manifest</comment>
        <translation>`evaluate own` 需要一张病例及其已知信息的表：angiopose-cli evaluate own CASES.csv --output FOLDER。</translation>
    </message>
    <message>
        <source>`evaluate observers` needs a log of blind trials: angiopose-cli evaluate observers TRIALS.csv --output FOLDER.</source>
        <comment>evaluate.no-log</comment>
        <translation>`evaluate observers` 需要盲法试验日志：angiopose-cli evaluate observers TRIALS.csv --output FOLDER。</translation>
    </message>
    <message>
        <source>The experiment &apos;%1&apos; makes its own trials. Leave &apos;%2&apos; out, or write `evaluate own %2`.</source>
        <comment>evaluate.input-of-experiment</comment>
        <translation>实验 &apos;%1&apos; 自行生成试验。请去掉 &apos;%2&apos;，或写 `evaluate own %2`。</translation>
    </message>
    <message>
        <source>`simulate` needs --seed for one case or --study for many.</source>
        <comment>simulate.what</comment>
        <translation>`simulate` 需要 --seed（单个病例）或 --study（多个病例）。</translation>
    </message>
    <message>
        <source>%1 voxels lie far beyond all others (between %2 and %3); they are taken as the lowest or highest of those.</source>
        <comment>volume.stray-values</comment>
        <translation>%1 个体素远离其他所有体素（介于 %2 和 %3 之间）；按其余体素的最低值或最高值处理。</translation>
    </message>
    <message>
        <source>what was printed did not all arrive: the drive or pipe behind the standard output is full or closed. Make room, or send it elsewhere.</source>
        <comment>run.output-not-written</comment>
        <translation>输出未完整送达：标准输出所连的驱动器或管道已满或已关闭。请腾出空间，或将其发送到别处。</translation>
    </message>
    <message>
        <source>the audit file cannot be written (%1), so that what was done is not in it. Make room, or allow writing to it.</source>
        <comment>audit.not-written</comment>
        <translation>无法写入审计文件（%1），因此所做的操作未被记录。请腾出空间，或允许写入该文件。</translation>
    </message>
    <message>
        <source>No header tells where the table stood: where the vessels lie in this view is found from its image, only the turn from angles.</source>
        <comment>geometry.table-unknown</comment>
        <translation>文件头未说明检查床的位置：血管在此视图中的位置由其图像求得，只有旋转取自角度。</translation>
    </message>
    <message>
        <source>Only (0018,1111) tells a distance, and it differs between the views (%1, %2): it is no isocenter. The shift between the views is not used; type the distance source to isocenter (SOD) of both.</source>
        <comment>geometry.isocenter-unknown</comment>
        <translation>只有 (0018,1111) 给出距离，且在各视图间不同（%1、%2）：它不是等中心。视图间的位移不予使用；请为两者输入射线源到等中心的距离 (SOD)。</translation>
    </message>
    <message>
        <source>The table moved during one of the runs: the shift between the views counts as unknown (50 mm).</source>
        <comment>geometry.table-moved-in-view</comment>
        <translation>检查床在其中一次采集期间移动：视图间的位移视为未知（50 mm）。</translation>
    </message>
    <message>
        <source>Little was traced here but lines that stand still through the run, as shutter edges, leads and bones do: the frame shows no contrast agent to track.</source>
        <comment>follow.stands-still</comment>
        <translation>此帧几乎只提取到在整个序列中静止不动的线条，如遮光器边缘、导线和骨骼：没有可跟踪的造影剂。</translation>
    </message>
    <message>
        <source>Frame %1 does not exist: the image has frames 1 to %2.</source>
        <comment>frame.missing</comment>
        <translation>第 %1 帧不存在：图像有第 1 到 %2 帧。</translation>
    </message>
    <message>
        <source>Mask frame %1 does not exist, counted from 1. The run has frames 1 to %2.</source>
        <comment>subtraction.mask-frame-missing</comment>
        <translation>蒙片帧 %1 不存在（从 1 开始计数）。序列有第 1 到 %2 帧。</translation>
    </message>
    <message>
        <source>A wide vessel that was not traced runs beside the traced ones for %1, at %2: possibly the false lumen of a dissection. Place a seed in each lumen to trace both.</source>
        <comment>tracing.other-lumen-beside</comment>
        <translation>一条未提取的粗血管与已提取血管并行 %1，位于 %2：可能是夹层的假腔。请在每个腔内放置种子点以提取两者。</translation>
    </message>
    <message>
        <source>%1 does not exist: counted from 0, as in case files, the image has frames 0 to %2.</source>
        <comment>case.frame-missing</comment>
        <translation>%1 不存在：按病例文件从 0 开始计数，图像有第 0 到 %2 帧。</translation>
    </message>
    <message>
        <source>The image is shown as its orientation tag (%1) states, turned or mirrored from how its pixels are stored.</source>
        <comment>image.turned</comment>
        <translation>图像按其方向标记（%1）显示，相对于存储的像素已旋转或镜像。</translation>
    </message>
    <message>
        <source>page %1 has %2 x %3 pixels, the first has %4 x %5. Export the frames of one run, all equally large.</source>
        <comment>image.pages-differ</comment>
        <translation>第 %1 页为 %2 x %3 像素，第一页为 %4 x %5。请导出同一序列中大小一致的各帧。</translation>
    </message>
    <message>
        <source>it has %1 pages. Export the mask as one image.</source>
        <comment>centreline.mask-pages</comment>
        <translation>它有 %1 页。请将掩模导出为单幅图像。</translation>
    </message>
    <message>
        <source>Frames in the header: %1, in the file: %2. Those in the file are loaded. Copy or export it again where some are missing.</source>
        <comment>dicom.frames-other</comment>
        <translation>文件头中的帧数：%1，文件中：%2。已载入文件中的帧。如有缺失，请重新复制或导出。</translation>
    </message>
    <message>
        <source>The header contradicts itself about the time between frames: Frame Time %1, Frame Time Vector %2. %3 is used.</source>
        <comment>dicom.frame-times</comment>
        <translation>文件头中的帧间隔互相矛盾：Frame Time %1，Frame Time Vector %2。采用 %3。</translation>
    </message>
    <message>
        <source>a volume made of projections (modality %1)</source>
        <comment>dicom.reconstruction</comment>
        <translation>由投影重建的体数据（模态 %1）</translation>
    </message>
    <message>
        <source>The header&apos;s %1 shutter (0018,1600) leaves nothing of the image (%2): it is ignored. Check that no shutter edge is traced as a vessel.</source>
        <comment>dicom.shutter-unusable</comment>
        <translation>文件头中的 %1 遮光器 (0018,1600) 未留下任何图像区域（%2）：已忽略。请检查遮光器边缘是否被当作血管提取。</translation>
    </message>
    <message>
        <source>The image is taken as turned clockwise by %1, after %2. Check that head and left are where they belong.</source>
        <comment>dicom.image-turned</comment>
        <translation>图像按%2视为顺时针旋转了%1。请检查头侧和左侧的位置是否正确。</translation>
    </message>
    <message>
        <source>Patient Orientation (0020,0020) says %1, which no image at these angles can be: check the angles, and whether the image is mirrored or turned.</source>
        <comment>dicom.orientation-unlike-angles</comment>
        <translation>Patient Orientation (0020,0020) 为 %1，在这些角度下没有图像会如此：请检查角度，以及图像是否被镜像或旋转。</translation>
    </message>
    <message>
        <source>The header has the object at %1 from the source, the isocenter at %2: the vessels start at the first, the gantry turns about the second.</source>
        <comment>dicom.object-off-isocenter</comment>
        <translation>文件头中物体距射线源 %1，等中心距射线源 %2：血管从前者开始配准，C 形臂绕后者旋转。</translation>
    </message>
    <message>
        <source>The file states its unit (&quot;%1&quot;): one unit is read as %2. Give the unit if that is wrong.</source>
        <comment>vessels.unit-stated</comment>
        <translation>文件注明了单位（“%1”）：一个单位按 %2 读取。如有误，请指定单位。</translation>
    </message>
    <message>
        <source>The file states its unit (&quot;%1&quot;, which is %2), but one unit is read as %3, as was asked for. Check the size.</source>
        <comment>vessels.unit-overruled</comment>
        <translation>文件注明了单位（“%1”，即 %2），但按要求一个单位按 %3 读取。请检查大小。</translation>
    </message>
    <message>
        <source>The file states two units (&quot;%1&quot; and &quot;%2&quot;). Check the size, and give the unit if it is wrong.</source>
        <comment>vessels.units-contradict</comment>
        <translation>文件注明了两种单位（“%1”和“%2”）。请检查大小，如有误请指定单位。</translation>
    </message>
    <message>
        <source>its axes are %1, not LPS or RAS. Export it in patient coordinates (LPS).</source>
        <comment>vessels.axes-other</comment>
        <translation>其坐标轴为 %1，既不是 LPS 也不是 RAS。请以患者坐标（LPS）导出。</translation>
    </message>
    <message>
        <source>Lines whose first points stood at the end, moved back to the beginning: %1. Check the vessels.</source>
        <comment>tree.turned-round</comment>
        <translation>起始点位于末尾、已移回开头的线：%1。请检查血管。</translation>
    </message>
    <message>
        <source>The lines leap %1 times, by up to %2, over many usual steps: they were cut there. Check the order of the points.</source>
        <comment>tree.leaps</comment>
        <translation>线条跳跃 %1 次，最大 %2，远超通常点距：已在该处断开。请检查点的顺序。</translation>
    </message>
    <message>
        <source>%1 points of the curves are not placed and were left out.</source>
        <comment>tree.markups-not-placed</comment>
        <translation>曲线中有 %1 个点未放置，已忽略。</translation>
    </message>
    <message>
        <source>its header declares %1 triangles, but the file holds %2. Copy or export it again.</source>
        <comment>surface.stl-too-few</comment>
        <translation>文件头声明 %1 个三角形，但文件中只有 %2 个。请重新复制或导出。</translation>
    </message>
    <message>
        <source>The header declares %1 triangles, but the file has room for %2: what is behind those declared was not read. Check that nothing is missing.</source>
        <comment>surface.stl-too-many</comment>
        <translation>文件头声明 %1 个三角形，但文件大小可容纳 %2 个：声明之后的内容未读取。请检查是否有缺失。</translation>
    </message>
    <message>
        <source>The text ends after %1 triangles without &quot;endsolid&quot;: it may be cut short. Check that nothing is missing.</source>
        <comment>surface.stl-without-end</comment>
        <translation>文本在 %1 个三角形后结束且没有“endsolid”：文件可能被截断。请检查是否有缺失。</translation>
    </message>
    <message>
        <source>its coordinates are in &quot;%1&quot;, which is no unit of length known here. Export them in mm.</source>
        <comment>tree.markups-unit</comment>
        <translation>其坐标单位为“%1”，不是此处已知的长度单位。请以 mm 导出。</translation>
    </message>
    <message>
        <source>The header contradicts itself: slices %1 apart (Spacing Between Slices), %2 by their positions. The positions are used.</source>
        <comment>series.step</comment>
        <translation>文件头互相矛盾：层间距为 %1（Spacing Between Slices），而按位置为 %2。采用位置。</translation>
    </message>
    <message>
        <source>part %1 of %2 (acquisition %3)</source>
        <comment>series.acquisition</comment>
        <translation>第 %1 部分，共 %2 部分（采集 %3）</translation>
    </message>
    <message>
        <source>%1 of %2 images of the series share a SOP Instance UID although they differ: all of them are read. Export the series again before you archive it.</source>
        <comment>series.same-uid</comment>
        <translation>该序列 %2 幅图像中有 %1 幅共用 SOP Instance UID，但内容不同：全部读取。归档前请重新导出该序列。</translation>
    </message>
    <message>
        <source>%1 patients or studies share the UID of this series; each is listed by itself.</source>
        <comment>series.of-several</comment>
        <translation>%1 个患者或检查共用该序列的 UID；已分别列出。</translation>
    </message>
    <message>
        <source>The header gives lengths in &quot;%1&quot;, which is not a known unit: millimeters are assumed. Check the voxel size.</source>
        <comment>volume.unit-unknown</comment>
        <translation>文件头的长度单位“%1”未知：按毫米处理。请检查体素大小。</translation>
    </message>
    <message>
        <source>Its two placements (qform and sform) differ by up to %1; the qform, in the scanner&apos;s coordinates, is used.</source>
        <comment>volume.nifti-qform-used</comment>
        <translation>两种定位（qform 与 sform）相差最多 %1；采用扫描仪坐标的 qform。</translation>
    </message>
    <message>
        <source>Its two placements (qform and sform) differ by up to %1; the sform is used.</source>
        <comment>volume.nifti-sform-used</comment>
        <translation>两种定位（qform 与 sform）相差最多 %1；采用 sform。</translation>
    </message>
    <message>
        <source>The header contradicts itself about the voxel size: %1 (pixdim), %2 by its placement. The placement is used. Check which is right.</source>
        <comment>volume.nifti-sizes</comment>
        <translation>文件头中的体素大小互相矛盾：%1（pixdim），而按定位为 %2。采用定位中的值。请确认哪个正确。</translation>
    </message>
    <message>
        <source>The header contradicts itself about the voxel type: %1 bits (bitpix), but %2 bits by its datatype (%3), which is used.</source>
        <comment>volume.nifti-bits</comment>
        <translation>文件头中的体素类型互相矛盾：%1 位（bitpix），而按数据类型（%3）为 %2 位；采用数据类型。</translation>
    </message>
    <message>
        <source>The header says that the voxels begin at byte %1, which is inside the header: they are read from byte %2.</source>
        <comment>volume.nifti-start-within-header</comment>
        <translation>文件头称体素从第 %1 字节开始，但该处位于文件头内：改从第 %2 字节读取。</translation>
    </message>
    <message>
        <source>a voxel size of %1 mm cannot be written. Correct the spacing, origin and directions of the volume.</source>
        <comment>volume.no-size-to-write</comment>
        <translation>无法写入 %1 mm 的体素大小。请更正体数据的间距、原点和方向。</translation>
    </message>
    <message>
        <source>frame %1 does not exist, counted from 1. It has frames 1 to %2.</source>
        <comment>command.frame-beyond-run</comment>
        <translation>第 %1 帧不存在（从 1 开始计数）。共有第 1 到 %2 帧。</translation>
    </message>
    <message>
        <source>NOT RELIABLE</source>
        <comment>fit.not-reliable</comment>
        <translation>不可靠</translation>
    </message>
    <message>
        <source>These distances are over the %1 of the tree judged opacified. Whole tree: median %2, 95th percentile %3.</source>
        <comment>fit.over-opacified</comment>
        <translation>这些距离仅针对判为显影的 %1 血管树。整棵树：中位数 %2，第 95 百分位数 %3。</translation>
    </message>
    <message>
        <source>Excluded branches: %1 (medians). With them: median %2, 95th percentile %3.</source>
        <comment>fit.without-excluded</comment>
        <translation>排除的分支：%1（中位数）。包括它们：中位数 %2，第 95 百分位数 %3。</translation>
    </message>
    <message>
        <source>Auxiliary branches: %1 (medians).</source>
        <comment>fit.auxiliary</comment>
        <translation>辅助分支：%1（中位数）。</translation>
    </message>
    <message>
        <source>at this pose all vessels lie at or behind the X-ray source, where nothing projects. Check the pose and its direction: camera from patient.</source>
        <comment>pose.all-behind-source</comment>
        <translation>此位姿下所有血管位于 X 射线源处或其后，无法投影。请检查位姿及其方向：由患者到相机。</translation>
    </message>
    <message>
        <source>At this pose no vessel lies inside the image. Check the pose.</source>
        <comment>pose.all-outside-image</comment>
        <translation>此位姿下图像内没有血管。请检查位姿。</translation>
    </message>
    <message>
        <source>frame %1 of %2</source>
        <comment>picture.frame</comment>
        <translation>第 %1 帧，共 %2 帧</translation>
    </message>
    <message>
        <source>There are no frames %1 to %2 in that order: the run has frames 1 to %3. Choose others.</source>
        <comment>movie.frames-beyond</comment>
        <translation>没有按此顺序的第 %1 到 %2 帧：序列有第 1 到 %3 帧。请另选。</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Finds the pose of a 3-D vessel tree in a 2-D angiogram. Not for clinical use.</source>
        <translation>求三维血管树在二维造影图像中的位姿。不得用于临床。</translation>
    </message>
    <message>
        <source>A case, or a centreline and an angiogram.</source>
        <translation>一个病例，或一条中心线和一幅造影图像。</translation>
    </message>
    <message>
        <source>Who draws the angiogram: vtk (OpenGL), painter (the processor), or auto: vtk where a graphics card does OpenGL.</source>
        <translation>由谁绘制血管造影：vtk（OpenGL）、painter（处理器），或 auto：有显卡加速 OpenGL 时用 vtk。</translation>
    </message>
    <message>
        <source>No renderer is called “%1”: auto, vtk or painter.</source>
        <translation>没有名为“%1”的渲染器：可用 auto、vtk 或 painter。</translation>
    </message>
    <message>
        <source>There is no display to show the window on. angiopose-cli does the same work without one.</source>
        <translation>没有可显示窗口的显示器。angiopose-cli 无需显示器即可完成同样的工作。</translation>
    </message>
    <message>
        <source>Write the report of a case, .pdf or .html, and end; needs no display.</source>
        <translation>写出病例的报告（.pdf 或 .html）后结束；不需要显示器。</translation>
    </message>
    <message>
        <source>Beside --report: register the case first.</source>
        <translation>与 --report 一起：先配准病例。</translation>
    </message>
    <message>
        <source>Beside --report: the page to fill in, in place of the built-in one.</source>
        <translation>与 --report 一起：要填写的页面，代替内置页面。</translation>
    </message>
    <message>
        <source>Beside --report: who makes it, in place of the account&apos;s name.</source>
        <translation>与 --report 一起：报告的作者，代替账户名。</translation>
    </message>
    <message>
        <source>Beside --report: name the patient, which is left out else.</source>
        <translation>与 --report 一起：写出患者姓名，否则不写。</translation>
    </message>
    <message>
        <source>Beside --report: its language, in place of the window&apos;s.</source>
        <translation>与 --report 一起：报告的语言，代替窗口的语言。</translation>
    </message>
    <message>
        <source>A report is written in %1, not in “%2”.</source>
        <translation>报告的语言可以是 %1，不能是“%2”。</translation>
    </message>
    <message>
        <source>--register, --template, --author, --identity and --language go beside --report FILE alone.</source>
        <translation>--register、--template、--author、--identity 和 --language 只能与 --report FILE 一起使用。</translation>
    </message>
    <message>
        <source>A report is written as .pdf or .html, not as “%1”.</source>
        <translation>报告以 .pdf 或 .html 写出，而非“%1”。</translation>
    </message>
    <message>
        <source>A report is of one case: angiopose --report FILE CASE</source>
        <translation>一份报告对应一个病例：angiopose --report FILE CASE</translation>
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
        <source>%1 frames before each</source>
        <translation>每帧之前 %1 帧</translation>
    </message>
    <message>
        <source>none found: mark them below</source>
        <translation>未找到：请在下方标记</translation>
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
        <source>Whole run in one picture</source>
        <translation>整个序列合成一幅</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Choose the frames before the contrast medium arrives</source>
        <translation>选择对比剂到达前的帧</translation>
    </message>
    <message>
        <source>Find the shift of each frame</source>
        <translation>求每帧的位移</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>手动</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>默认值</translation>
    </message>
    <message>
        <source>Trace as the program would by itself</source>
        <translation>按程序默认方式提取</translation>
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
        <source>One frame at a time</source>
        <translation>逐帧显示</translation>
    </message>
    <message>
        <source>Choose mask frames automatically</source>
        <translation>自动选择蒙片帧</translation>
    </message>
    <message>
        <source>Find the mask&apos;s shift</source>
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
        <source>How far the mask moves to the right, px</source>
        <translation>蒙片向右移动量，px</translation>
    </message>
    <message>
        <source>How far the mask moves down, px</source>
        <translation>蒙片向下移动量，px</translation>
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
        <source>Move the mask</source>
        <translation>移动蒙片</translation>
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
        <source>How stored values relate to the X-ray intensity (0028,1040)</source>
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
        <source>Whether contrast medium is darker or brighter than the background</source>
        <translation>对比剂比背景暗还是亮</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>血管</translation>
    </message>
    <message>
        <source>Change the meaning of pixel values</source>
        <translation>更改像素值含义</translation>
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
        <source>shortest vessel</source>
        <translation>最短血管</translation>
    </message>
    <message>
        <source>Isolated pieces shorter than this are left out; spurs shorter than a third of it too</source>
        <translation>短于此的孤立段略去；短于其三分之一的毛刺亦然</translation>
    </message>
    <message>
        <source>sensitivity</source>
        <translation>灵敏度</translation>
    </message>
    <message>
        <source>Above 1: fainter vessels are traced as well</source>
        <translation>大于 1：也提取较淡的血管</translation>
    </message>
    <message>
        <source>widest radius</source>
        <translation>最大半径</translation>
    </message>
    <message>
        <source>Radius of the widest vessel looked for</source>
        <translation>所寻最粗血管的半径</translation>
    </message>
    <message>
        <source>Default tracing</source>
        <translation>默认提取</translation>
    </message>
    <message>
        <source>Tracing</source>
        <translation>提取</translation>
    </message>
    <message>
        <source>subtracting …</source>
        <translation>减影中……</translation>
    </message>
    <message>
        <source>subtracted</source>
        <translation>已减影</translation>
    </message>
    <message>
        <source>composite</source>
        <translation>合成</translation>
    </message>
    <message>
        <source>native</source>
        <translation>原始</translation>
    </message>
    <message>
        <source>Move the mask with arrows or the mouse</source>
        <translation>用方向键或鼠标移动蒙片</translation>
    </message>
    <message>
        <source>Take away what the mask frames show as well: bones and organs</source>
        <translation>去除蒙片帧中同样可见的骨骼和器官</translation>
    </message>
    <message>
        <source>Every frame shows the darkest value of each pixel over the run</source>
        <translation>每帧显示各像素在序列中的最暗值</translation>
    </message>
    <message>
        <source>Edit vessels</source>
        <translation>编辑血管</translation>
    </message>
    <message>
        <source>Leave out, erase, draw and cut traced curves</source>
        <translation>排除、擦除、绘制和切断提取的曲线</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窗宽</translation>
    </message>
    <message>
        <source>Window W: how many grey values lie between black and white</source>
        <translation>窗宽 W：黑与白之间的灰度值个数</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>窗位</translation>
    </message>
    <message>
        <source>Level L: the grey value in the middle of them</source>
        <translation>窗位 L：位于其中央的灰度值</translation>
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
        <translation>叠加投影血管树的造影图像</translation>
    </message>
    <message>
        <source>Mirrored image, mirrored back by the view</source>
        <translation>镜像图像，视图已还原</translation>
    </message>
    <message>
        <source>Seen from the source: the view is mirrored</source>
        <translation>从源方向看：视图镜像</translation>
    </message>
    <message>
        <source>Mirrored image: as seen from the source</source>
        <translation>镜像图像：如从源方向看</translation>
    </message>
    <message>
        <source>flicker %1 · swipe %2 · hide H · outline %3</source>
        <translation>闪烁 %1 · 卷帘 %2 · 隐藏 H · 轮廓 %3</translation>
    </message>
    <message>
        <source>No angiogram yet: drop one here, or open it (%1).</source>
        <translation>尚无造影图像：拖放到此处，或打开（%1）。</translation>
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
        <source>Its search alternates between the chosen branches and the whole tree.</source>
        <translation>其搜索在所选分支与整棵树之间交替。</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Up to generation</source>
        <translation>至第几级</translation>
    </message>
    <message>
        <source>Generation 0 begins at the root of the tree.</source>
        <translation>第 0 级从血管树根部开始。</translation>
    </message>
    <message>
        <source>At least this wide</source>
        <translation>至少这么粗</translation>
    </message>
    <message>
        <source>By the median radius of a branch.</source>
        <translation>按分支半径中位数。</translation>
    </message>
    <message>
        <source>Choose these</source>
        <translation>选择这些</translation>
    </message>
    <message>
        <source>Makes the suggested branches the auxiliary ones.</source>
        <translation>将建议的分支设为辅助分支。</translation>
    </message>
    <message>
        <source>Auxiliary branches</source>
        <translation>辅助分支</translation>
    </message>
    <message>
        <source>The alternating methods solve for these branches first, so choose what is filled, still and told apart well. One image tells a branch only across its course: which ones pin which step of the pose is computed here for the pose as it is.</source>
        <translation>交替类方法先求解这些分支，请选充盈、静止且易分辨的。单幅图像只能确定分支垂直于走向的位置：此处按当前位姿计算各分支约束哪个自由度。</translation>
    </message>
    <message>
        <source>step</source>
        <translation>自由度</translation>
    </message>
    <message>
        <source>all branches</source>
        <translation>全部分支</translation>
    </message>
    <message>
        <source>the chosen</source>
        <translation>所选</translation>
    </message>
    <message>
        <source>pinned best by</source>
        <translation>最佳约束分支</translation>
    </message>
    <message>
        <source>± is one standard deviation expected of traced vessels with usual noise.</source>
        <translation>± 为通常噪声下预期的一个标准差。</translation>
    </message>
    <message>
        <source>Last generation</source>
        <translation>最后一级</translation>
    </message>
    <message>
        <source>Smallest radius</source>
        <translation>最小半径</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Without chosen branches the nodes of the tree are used.</source>
        <translation>未选分支时使用血管树的节点。</translation>
    </message>
    <message>
        <source>Vessels, camera and pose are needed for a suggestion.</source>
        <translation>建议需要血管、相机和位姿。</translation>
    </message>
    <message>
        <source>Suggested: %1. They tell nearly as much as all together.</source>
        <translation>建议：%1。其信息量几乎等于全部分支。</translation>
    </message>
    <message>
        <source>This tree knows no generations.</source>
        <translation>此血管树没有分级信息。</translation>
    </message>
    <message>
        <source>This tree knows no radii.</source>
        <translation>此血管树没有半径信息。</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>套索</translation>
    </message>
    <message>
        <source>Draw around the branches on the image.</source>
        <translation>在图像上圈选分支。</translation>
    </message>
    <message>
        <source>In view</source>
        <translation>视野内</translation>
    </message>
    <message>
        <source>The branches that lie wholly in the view.</source>
        <translation>完全位于视野内的分支。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::BlindTrialDialog</name>
    <message>
        <source>Seed</source>
        <translation>种子</translation>
    </message>
    <message>
        <source>Start shifted by up to</source>
        <translation>初始平移上限</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Start turned by up to</source>
        <translation>初始旋转上限</translation>
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
        <source>The vessels start at random around the pose as it is. Until Done all numbers, residual colours and earlier poses are out of sight; time and final pose go to the log, and the case stays as it is.</source>
        <translation>血管从当前位姿附近的随机位置开始。完成前隐藏所有数值、残差颜色和先前位姿；时间和最终位姿写入记录，病例不变。</translation>
    </message>
    <message>
        <source>Observer</source>
        <translation>观察者</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>选择……</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Log of the trials</source>
        <translation>试验记录</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Observer and log are needed.</source>
        <translation>需要观察者和记录。</translation>
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
        <source>out</source>
        <translation>排除</translation>
    </message>
    <message>
        <source>g%1</source>
        <translation>%1级</translation>
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
        <source>in the auxiliary set</source>
        <translation>属于辅助集</translation>
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
        <source>Only these auxiliary</source>
        <translation>仅这些为辅助</translation>
    </message>
    <message>
        <source>No auxiliary branches (use the nodes)</source>
        <translation>无辅助分支（使用节点）</translation>
    </message>
    <message>
        <source>as in the tree</source>
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
        <source>Order of the branches</source>
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
        <source>Selects both branches and moves the cross-hair to the gap.</source>
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
        <source>No vessels yet. Open a CT scan, a mask of vessels or a centreline.</source>
        <translation>尚无血管。请打开 CT、血管掩膜或中心线。</translation>
    </message>
    <message>
        <source>Closes the gap; undo opens it again.</source>
        <translation>闭合间隙；可撤销。</translation>
    </message>
    <message>
        <source>%1 auxiliary · %2 exclude</source>
        <translation>%1 辅助 · %2 排除</translation>
    </message>
    <message>
        <source>Auxiliary on or off</source>
        <translation>辅助分支开或关</translation>
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
        <source>Pack case for others …</source>
        <translation>打包病例给他人…</translation>
    </message>
    <message>
        <source>Export DICOM objects …</source>
        <translation>导出 DICOM 对象……</translation>
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
        <source>Play from this frame on</source>
        <translation>从此帧开始播放</translation>
    </message>
    <message>
        <source>Play up to this frame</source>
        <translation>播放到此帧为止</translation>
    </message>
    <message>
        <source>Play the whole run</source>
        <translation>播放整个序列</translation>
    </message>
    <message>
        <source>Views side by side</source>
        <translation>并排显示视图</translation>
    </message>
    <message>
        <source>Cross-hair through views side by side</source>
        <translation>并排视图间的联动十字线</translation>
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
        <source>Open …</source>
        <translation>打开……</translation>
    </message>
    <message>
        <source>Open folder or disc …</source>
        <translation>打开文件夹或光盘……</translation>
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
        <source>Save as …</source>
        <translation>另存为……</translation>
    </message>
    <message>
        <source>Export overlay …</source>
        <translation>导出叠加图……</translation>
    </message>
    <message>
        <source>Export result …</source>
        <translation>导出结果……</translation>
    </message>
    <message>
        <source>Export pose …</source>
        <translation>导出位姿……</translation>
    </message>
    <message>
        <source>Export traced vessels …</source>
        <translation>导出提取的血管……</translation>
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
        <source>Back to start pose</source>
        <translation>回到初始位姿</translation>
    </message>
    <message>
        <source>Copy pose as matrix</source>
        <translation>以矩阵复制位姿</translation>
    </message>
    <message>
        <source>Selected branches auxiliary on or off</source>
        <translation>所选分支辅助开/关</translation>
    </message>
    <message>
        <source>Auxiliary: the branches in view</source>
        <translation>辅助：视野内的分支</translation>
    </message>
    <message>
        <source>Auxiliary: the wider half</source>
        <translation>辅助：较粗的一半</translation>
    </message>
    <message>
        <source>Exclude or include selected branches</source>
        <translation>排除或恢复所选分支</translation>
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
        <source>Fit the image to the window</source>
        <translation>图像适合窗口</translation>
    </message>
    <message>
        <source>Automatic brightness</source>
        <translation>自动窗宽窗位</translation>
    </message>
    <message>
        <source>Invert grey values</source>
        <translation>灰度反转</translation>
    </message>
    <message>
        <source>Brightness: every grey value</source>
        <translation>窗宽：全部灰度</translation>
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
        <source>Near vessels bright, far ones dim</source>
        <translation>近处血管亮、远处血管暗</translation>
    </message>
    <message>
        <source>Swipe, lens, off</source>
        <translation>卷帘、透镜、关闭</translation>
    </message>
    <message>
        <source>Zoom to the worst branch, the next</source>
        <translation>放大最差分支，再下一个</translation>
    </message>
    <message>
        <source>Show traced vessels</source>
        <translation>显示提取的血管</translation>
    </message>
    <message>
        <source>Flicker start pose and pose</source>
        <translation>初始与当前位姿闪烁对比</translation>
    </message>
    <message>
        <source>Colours: how far bent vessels moved</source>
        <translation>颜色：弯曲血管的位移</translation>
    </message>
    <message>
        <source>Vessels bent, where that is known, or rigid</source>
        <translation>血管：弯曲（若已知）或刚性</translation>
    </message>
    <message>
        <source>Replay the last run</source>
        <translation>回放上次配准</translation>
    </message>
    <message>
        <source>Swing along what the image cannot tell</source>
        <translation>沿图像无法确定的方向摆动</translation>
    </message>
    <message>
        <source>Show the run&apos;s other solutions</source>
        <translation>显示其他解</translation>
    </message>
    <message>
        <source>Take the solution shown</source>
        <translation>采用所示解</translation>
    </message>
    <message>
        <source>Overlay fainter</source>
        <translation>叠加图变淡</translation>
    </message>
    <message>
        <source>Overlay stronger</source>
        <translation>叠加图变浓</translation>
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
        <source>As the desktop</source>
        <translation>跟随桌面</translation>
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
        <source>Language of the desktop</source>
        <translation>桌面语言</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Save picture of the window …</source>
        <translation>保存窗口图片……</translation>
    </message>
    <message>
        <source>Copy picture of the window</source>
        <translation>复制窗口图片</translation>
    </message>
    <message>
        <source>Radiology: left drag windows</source>
        <translation>放射科：左键拖动调窗</translation>
    </message>
    <message>
        <source>3D Slicer: left only picks</source>
        <translation>3D Slicer：左键仅选择</translation>
    </message>
    <message>
        <source>Scroll: left drag runs the frames</source>
        <translation>滚动：左键拖动换帧</translation>
    </message>
    <message>
        <source>Help on what the mouse points at</source>
        <translation>鼠标所指内容的帮助</translation>
    </message>
    <message>
        <source>Short tour</source>
        <translation>简短导览</translation>
    </message>
    <message>
        <source>What a good fit looks like</source>
        <translation>好的配准是什么样</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>快捷键与鼠标</translation>
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
        <source>Subtract mask, native</source>
        <translation>减影、原始</translation>
    </message>
    <message>
        <source>Move the mask by hand</source>
        <translation>手动移动蒙片</translation>
    </message>
    <message>
        <source>This frame is the mask</source>
        <translation>以此帧为蒙片</translation>
    </message>
    <message>
        <source>Whole run in one picture</source>
        <translation>整个序列合成一幅</translation>
    </message>
    <message>
        <source>Click pairs of landmarks</source>
        <translation>点选标志点对</translation>
    </message>
    <message>
        <source>Place vessels by landmarks</source>
        <translation>按标志点放置血管</translation>
    </message>
    <message>
        <source>Auxiliary: draw a lasso</source>
        <translation>辅助：套索圈选</translation>
    </message>
    <message>
        <source>Auxiliary: which branches …</source>
        <translation>辅助：选择哪些分支……</translation>
    </message>
    <message>
        <source>C-arm angles for the branch …</source>
        <translation>显示该分支的 C 臂角度……</translation>
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
        <source>Cut branch at the cross-hair</source>
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
        <source>Root at the branch&apos;s end near the cross-hair</source>
        <translation>以十字线附近分支端为根</translation>
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
        <source>Delete branches and what leaves them</source>
        <translation>删除分支及其分出部分</translation>
    </message>
    <message>
        <source>Prune short or thin branches …</source>
        <translation>修剪短或细的分支……</translation>
    </message>
    <message>
        <source>Join the pieces at the next gap</source>
        <translation>在下一间隙处连接</translation>
    </message>
    <message>
        <source>Keep this pose</source>
        <translation>保留此位姿</translation>
    </message>
    <message>
        <source>Switch between poses A and B</source>
        <translation>在位姿 A 与 B 间切换</translation>
    </message>
    <message>
        <source>Compare poses and methods …</source>
        <translation>比较位姿和方法……</translation>
    </message>
    <message>
        <source>Blind observer trial …</source>
        <translation>观察者盲法试验……</translation>
    </message>
    <message>
        <source>Trial done</source>
        <translation>试验完成</translation>
    </message>
    <message>
        <source>Seen from the source (mirrored)</source>
        <translation>从源方向看（镜像）</translation>
    </message>
    <message>
        <source>Opacification over time</source>
        <translation>充盈随时间变化</translation>
    </message>
    <message>
        <source>3-D, axial, coronal, sagittal below the branches</source>
        <translation>分支下方：三维、轴位、冠状、矢状</translation>
    </message>
    <message>
        <source>Slices instead of the angiogram</source>
        <translation>以断层代替造影图像</translation>
    </message>
    <message>
        <source>Image alone, without the columns</source>
        <translation>仅图像，不显示侧栏</translation>
    </message>
    <message>
        <source>Ve&amp;ssels</source>
        <translation>血管(&amp;G)</translation>
    </message>
    <message>
        <source>Start pose from the angles</source>
        <translation>由角度得初始位姿</translation>
    </message>
    <message>
        <source>This pose is the start pose</source>
        <translation>以此位姿为初始位姿</translation>
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
        <source>3-D and slices alone</source>
        <translation>仅显示三维和切片</translation>
    </message>
    <message>
        <source>Angiogram in a window of its own</source>
        <translation>血管造影用独立窗口</translation>
    </message>
    <message>
        <source>3-D and slices in a window of their own</source>
        <translation>三维和切片用独立窗口</translation>
    </message>
    <message>
        <source>All slices in a window of their own</source>
        <translation>全部切片用独立窗口</translation>
    </message>
    <message>
        <source>Views alone and in windows</source>
        <translation>视图独占与独立窗口</translation>
    </message>
    <message>
        <source>Export followed poses …</source>
        <translation>导出跟踪位姿……</translation>
    </message>
    <message>
        <source>Add a view …</source>
        <translation>添加视图……</translation>
    </message>
    <message>
        <source>Show the next view</source>
        <translation>显示下一视图</translation>
    </message>
    <message>
        <source>Follow the vessels through the run</source>
        <translation>在整个序列中跟踪血管</translation>
    </message>
    <message>
        <source>Vessels: centreline, outline, tube, radiograph</source>
        <translation>血管：中心线、轮廓、管状、X 射线像</translation>
    </message>
    <message>
        <source>Brightness: the vessels alone</source>
        <translation>亮度：仅血管</translation>
    </message>
    <message>
        <source>Brightness: soft, with bone and catheter</source>
        <translation>亮度：柔和，含骨骼与导管</translation>
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
        <source>Brightness alone</source>
        <translation>仅亮度</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>亮度</translation>
    </message>
    <message>
        <source>Colours of vessels and residuals</source>
        <translation>血管与残差的颜色</translation>
    </message>
    <message>
        <source>Choose the labels that are vessels</source>
        <translation>选择属于血管的标签</translation>
    </message>
    <message>
        <source>Pick the point to turn about</source>
        <translation>选取旋转中心</translation>
    </message>
    <message>
        <source>Turn about the centroid again</source>
        <translation>恢复围绕质心转动</translation>
    </message>
    <message>
        <source>3-D view: everything, the vessels alone</source>
        <translation>三维视图：全部、仅血管</translation>
    </message>
    <message>
        <source>Export vessel tree …</source>
        <translation>导出血管树……</translation>
    </message>
    <message>
        <source>Export bent vessels …</source>
        <translation>导出弯曲血管……</translation>
    </message>
    <message>
        <source>Export report …</source>
        <translation>导出报告……</translation>
    </message>
    <message>
        <source>Export measurements …</source>
        <translation>导出测量……</translation>
    </message>
    <message>
        <source>Measure a length</source>
        <translation>测量长度</translation>
    </message>
    <message>
        <source>Measure an angle</source>
        <translation>测量角度</translation>
    </message>
    <message>
        <source>Measure an area</source>
        <translation>测量面积</translation>
    </message>
    <message>
        <source>Export measures of the branches …</source>
        <translation>导出各分支的测量……</translation>
    </message>
    <message>
        <source>Set a check point</source>
        <translation>设置检查点</translation>
    </message>
    <message>
        <source>Set the ring of an ostium</source>
        <translation>设置开口环</translation>
    </message>
    <message>
        <source>Say where a check point is seen</source>
        <translation>指出检查点所见位置</translation>
    </message>
    <message>
        <source>Draw an arrow</source>
        <translation>绘制箭头</translation>
    </message>
    <message>
        <source>Write a text on the image</source>
        <translation>在图像上写文字</translation>
    </message>
    <message>
        <source>Export check points …</source>
        <translation>导出检查点……</translation>
    </message>
    <message>
        <source>Export lumen mask …</source>
        <translation>导出管腔掩膜……</translation>
    </message>
    <message>
        <source>Trace one vessel between two places</source>
        <translation>提取两点之间的一条血管</translation>
    </message>
    <message>
        <source>Paint into the lumen mask</source>
        <translation>在管腔掩膜中绘制</translation>
    </message>
    <message>
        <source>Erase from the lumen mask</source>
        <translation>从管腔掩膜中擦除</translation>
    </message>
    <message>
        <source>Cut the lumen mask by a lasso</source>
        <translation>用套索裁剪管腔掩膜</translation>
    </message>
    <message>
        <source>Trace the edited mask</source>
        <translation>提取编辑后的掩膜</translation>
    </message>
    <message>
        <source>Scan in the 3-D view</source>
        <translation>三维视图中显示扫描</translation>
    </message>
    <message>
        <source>Scan in 3-D: vessels, vessels and bone</source>
        <translation>三维扫描：血管、血管和骨骼</translation>
    </message>
    <message>
        <source>Scan in 3-D: only around the vessels</source>
        <translation>三维扫描：仅血管周围</translation>
    </message>
    <message>
        <source>Radiograph of the scan on the detector</source>
        <translation>探测器上显示扫描的 X 光片</translation>
    </message>
    <message>
        <source>Fold the left column</source>
        <translation>折叠左栏</translation>
    </message>
    <message>
        <source>Fold the right column</source>
        <translation>折叠右栏</translation>
    </message>
    <message>
        <source>The layout follows the step</source>
        <translation>布局随步骤变化</translation>
    </message>
    <message>
        <source>Layout of this step as it came</source>
        <translation>恢复本步骤的默认布局</translation>
    </message>
    <message>
        <source>Export movie …</source>
        <translation>导出影片……</translation>
    </message>
    <message>
        <source>Open from archive …</source>
        <translation>从归档打开……</translation>
    </message>
    <message>
        <source>Send to archive …</source>
        <translation>发送到归档……</translation>
    </message>
    <message>
        <source>De-identify files …</source>
        <translation>文件去标识……</translation>
    </message>
    <message>
        <source>Private mode</source>
        <translation>隐私模式</translation>
    </message>
    <message>
        <source>Keep an audit file …</source>
        <translation>保留审计文件……</translation>
    </message>
    <message>
        <source>Save support bundle …</source>
        <translation>保存支持包……</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ConvergencePlot</name>
    <message>
        <source>Convergence</source>
        <translation>收敛</translation>
    </message>
    <message>
        <source>shown after a run</source>
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
        <source>shift of the vessels in one step</source>
        <translation>血管每步的移动</translation>
    </message>
    <message>
        <source>Above: half of the vessel points lie nearer than this to the traced vessels.
Below: how far a step moved the vessels, root of the mean square over all points; the bottom line is no shift.</source>
        <translation>上：一半血管点到所追踪血管的距离小于此值。
下：一步使血管移动的距离，为所有点的均方根；最底线表示没有移动。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::CornerViews</name>
    <message>
        <source>3-D</source>
        <translation>三维</translation>
    </message>
    <message>
        <source>All slices, large</source>
        <translation>所有断层，放大</translation>
    </message>
    <message>
        <source>Only this view in the window, and back</source>
        <translation>窗口内仅此视图，再次恢复</translation>
    </message>
    <message>
        <source>In a window of its own, and back</source>
        <translation>独立窗口，再次移回</translation>
    </message>
    <message>
        <source>Double click: only this view in the window, and back</source>
        <translation>双击：窗口内仅此视图，再次恢复</translation>
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
        <source>Click a curve to leave it out</source>
        <translation>单击曲线以排除</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>擦除</translation>
    </message>
    <message>
        <source>Brush over parts of curves</source>
        <translation>涂抹曲线部分</translation>
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
        <source>Click where a curve is to fall in two</source>
        <translation>单击曲线断开处</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>Leave out what lies in a box; Ctrl: keep it alone</source>
        <translation>排除框内部分；Ctrl：仅保留框内</translation>
    </message>
    <message>
        <source>Lasso</source>
        <translation>套索</translation>
    </message>
    <message>
        <source>Leave out what lies in a lasso; Ctrl: keep it alone</source>
        <translation>排除套索内部分；Ctrl：仅保留套索内</translation>
    </message>
    <message>
        <source>Trace again</source>
        <translation>重新提取</translation>
    </message>
    <message>
        <source>Forget the edits of this frame and trace it automatically; undo brings them back</source>
        <translation>放弃此帧编辑并自动提取；可撤销</translation>
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
        <source>Click a catheter or wire to keep it apart: it is no vessel, but can be followed</source>
        <translation>单击导管或导丝将其分开：它不是血管，但可以追踪</translation>
    </message>
    <message>
        <source>Follow the wire</source>
        <translation>追踪导丝</translation>
    </message>
    <message>
        <source>Find the way of the tree that the catheter or wire takes (method Wire or catheter)</source>
        <translation>找出导管或导丝在血管树中所走的路径（方法：导丝或导管）</translation>
    </message>
    <message>
        <source>%1, %2 apart</source>
        <translation>%1，%2 条分开</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::EditCurvesTool</name>
    <message>
        <source>Mark as not a vessel</source>
        <translation>标为非血管</translation>
    </message>
    <message>
        <source>Edit vessels: tracing this frame …</source>
        <translation>编辑血管：正在提取此帧……</translation>
    </message>
    <message>
        <source>Erase: brush over curves, [ ] size of the brush, Esc ends</source>
        <translation>擦除：涂抹曲线，[ ] 笔刷大小，Esc 结束</translation>
    </message>
    <message>
        <source>Draw: click along the vessel, Enter ends, Backspace takes a point back, Shift straight</source>
        <translation>绘制：沿血管单击，回车结束，退格撤一点，Shift 直线</translation>
    </message>
    <message>
        <source>Cut: click where a curve is to fall in two, Esc ends</source>
        <translation>切断：单击曲线断开处，Esc 结束</translation>
    </message>
    <message>
        <source>Not a vessel: click a curve to leave it out, Esc ends</source>
        <translation>非血管：单击曲线以排除，Esc 结束</translation>
    </message>
    <message>
        <source>Box: drag around what is no vessel; Ctrl keeps the inside alone, Esc ends</source>
        <translation>框选：框住非血管部分；Ctrl 仅保留框内，Esc 结束</translation>
    </message>
    <message>
        <source>Lasso: draw around what is no vessel; Ctrl keeps the inside alone, Esc ends</source>
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
        <source>Leave out a region</source>
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
        <source>Perhaps a catheter: A vessel, W catheter or wire, Delete leaves it out, S next</source>
        <translation>可能是导管：A 血管，W 导管或导丝，Delete 排除，S 下一条</translation>
    </message>
    <message>
        <source>Catheter or wire: click a curve to keep it apart, or to take it back, Esc ends</source>
        <translation>导管或导丝：单击曲线将其分开或恢复，Esc 结束</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ExportDialog</name>
    <message>
        <source>Picture</source>
        <translation>图像</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>In print</source>
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
        <source>The image alone</source>
        <translation>仅图像</translation>
    </message>
    <message>
        <source>Grey values of the image, 16 bit</source>
        <translation>图像灰度值，16 位</translation>
    </message>
    <message>
        <source>PNG, pixels</source>
        <translation>PNG，像素</translation>
    </message>
    <message>
        <source>SVG, lines and texts</source>
        <translation>SVG，线条与文字</translation>
    </message>
    <message>
        <source>PDF, lines and texts</source>
        <translation>PDF，线条与文字</translation>
    </message>
    <message>
        <source>as large as the frame</source>
        <translation>与帧同大</translation>
    </message>
    <message>
        <source>%1 × %2 px, %3 × %4 cm</source>
        <translation>%1 × %2 px，%3 × %4 cm</translation>
    </message>
    <message>
        <source>The picture says “Not for clinical use” (grey values of 16 bit in their text fields alone) and carries inputs, method and pose.</source>
        <translation>图像注明“不得用于临床”（16 位灰度值仅写在文本字段中），并附输入、方法与位姿。</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Residual colours with their scale</source>
        <translation>残差颜色及色标</translation>
    </message>
    <message>
        <source>Patient identity in the picture</source>
        <translation>图中显示患者信息</translation>
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
        <source>Export …</source>
        <translation>导出……</translation>
    </message>
    <message>
        <source>Texts in English</source>
        <translation>文字用英文</translation>
    </message>
    <message>
        <source>Swipe or lens as in the window</source>
        <translation>与窗口中相同的卷帘或透镜</translation>
    </message>
    <message>
        <source>Start pose beside it: before and after</source>
        <translation>并排显示初始位姿：前后对比</translation>
    </message>
    <message>
        <source>twice %1</source>
        <translation>两幅 %1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::FrameBars</name>
    <message>
        <source>R wave</source>
        <translation>R 波</translation>
    </message>
    <message>
        <source>Drag the ends to play a part of the run, double click for all of it</source>
        <translation>拖动两端以播放序列的一部分，双击播放全部</translation>
    </message>
    <message>
        <source>Frames by opacification</source>
        <translation>各帧充盈度</translation>
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
        <source>the fullest</source>
        <translation>最充盈</translation>
    </message>
    <message>
        <source>mask</source>
        <translation>蒙片</translation>
    </message>
    <message>
        <source>Shift+drag marks mask frames, double click shows the curve</source>
        <translation>Shift+拖动标记蒙片帧，双击显示曲线</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::GeometryPanel</name>
    <message>
        <source>type it</source>
        <translation>请输入</translation>
    </message>
    <message>
        <source>SID</source>
        <translation>SID</translation>
    </message>
    <message>
        <source>Source to detector distance</source>
        <translation>源到探测器距离</translation>
    </message>
    <message>
        <source>SOD</source>
        <translation>SOD</translation>
    </message>
    <message>
        <source>Source to isocentre distance</source>
        <translation>源到等中心距离</translation>
    </message>
    <message>
        <source>pixel</source>
        <translation>像素</translation>
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
        <translation>次角度：头位为正，足位为负</translation>
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
        <source>typed</source>
        <translation>手工输入</translation>
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
        <source>Assume usual values</source>
        <translation>采用常用值</translation>
    </message>
    <message>
        <source>Use distances and spacing instead</source>
        <translation>改用距离和像素间距</translation>
    </message>
    <message>
        <source>SID 1000 mm, SOD 750 mm, pixel 0.3 mm, angles 0°: only for what is missing.</source>
        <translation>SID 1000 mm、SOD 750 mm、像素 0.3 mm、角度 0°：仅用于缺失项。</translation>
    </message>
    <message>
        <source>Camera from the case file: f %1 px, centre %2, %3 px, %4.</source>
        <translation>病例文件中的相机：f %1 px，中心 %2，%3 px，%4。</translation>
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
        <source>Roll, centre, isocentre</source>
        <translation>滚转、中心、等中心</translation>
    </message>
    <message>
        <source>What the header says</source>
        <translation>文件头内容</translation>
    </message>
    <message>
        <source>as from the detector</source>
        <translation>如从探测器看</translation>
    </message>
    <message>
        <source>Side that the image is shown from</source>
        <translation>图像的观察侧</translation>
    </message>
    <message>
        <source>Angiograms are shown as seen from the detector. A mirrored export shows left and right exchanged: the projection is mirrored with it, the vessels never are.</source>
        <translation>造影图像按从探测器方向显示。镜像导出左右互换：投影随之镜像，血管绝不镜像。</translation>
    </message>
    <message>
        <source>side of the image</source>
        <translation>图像侧</translation>
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
        <source>The header gives no pixel spacing; this one is derived. Press Enter in it to confirm, or type it.</source>
        <translation>文件头无像素间距；此值为推算。在框内按回车确认，或输入。</translation>
    </message>
    <message>
        <source>The image is taken as mirrored (%1): check that left and right are where they belong.</source>
        <translation>图像视为镜像（%1）：请核对左右。</translation>
    </message>
    <message>
        <source>The gantry turns during this run: at this frame by %1° LAO/RAO and %2° CRA/CAU since the first.</source>
        <translation>采集中机架旋转：此帧相对第一帧 LAO/RAO %1°、CRA/CAU %2°。</translation>
    </message>
    <message>
        <source>Pixel pitch on the detector. Enter confirms a derived one.</source>
        <translation>探测器像素间距。回车确认推算值。</translation>
    </message>
    <message>
        <source>field width</source>
        <translation>视野宽度</translation>
    </message>
    <message>
        <source>Width of the image on the detector: gives the pixel pitch</source>
        <translation>图像在探测器上的宽度：由此得出像素间距</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>滚转</translation>
    </message>
    <message>
        <source>The image is turned clockwise by this</source>
        <translation>图像顺时针旋转的角度</translation>
    </message>
    <message>
        <source>centre right</source>
        <translation>中心右</translation>
    </message>
    <message>
        <source>Column that the beam axis meets; 0 is the middle of the first</source>
        <translation>中心射线所在列；0 为第一列中心</translation>
    </message>
    <message>
        <source>centre down</source>
        <translation>中心下</translation>
    </message>
    <message>
        <source>Row that the beam axis meets; 0 is the middle of the first</source>
        <translation>中心射线所在行；0 为第一行中心</translation>
    </message>
    <message>
        <source>isocentre L</source>
        <translation>等中心 L</translation>
    </message>
    <message>
        <source>What the gantry turns about, in the vessels&apos; coordinates: left</source>
        <translation>机架旋转中心（血管坐标）：左</translation>
    </message>
    <message>
        <source>isocentre P</source>
        <translation>等中心 P</translation>
    </message>
    <message>
        <source>What the gantry turns about, in the vessels&apos; coordinates: posterior</source>
        <translation>机架旋转中心（血管坐标）：后</translation>
    </message>
    <message>
        <source>isocentre H</source>
        <translation>等中心 H</translation>
    </message>
    <message>
        <source>What the gantry turns about, in the vessels&apos; coordinates: head</source>
        <translation>机架旋转中心（血管坐标）：头</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::GoodFit</name>
    <message>
        <source>Good: vessels have moved</source>
        <translation>好：血管有移动</translation>
    </message>
    <message>
        <source>Bad: shifted</source>
        <translation>坏：平移</translation>
    </message>
    <message>
        <source>Bad: turned</source>
        <translation>坏：旋转</translation>
    </message>
    <message>
        <source>Bad: wrong view angle</source>
        <translation>坏：投照角度错误</translation>
    </message>
    <message>
        <source>Lines run in the middle of their vessels, blue all along, into the side branches too.</source>
        <translation>线条位于血管中央，全程蓝色，侧支亦然。</translation>
    </message>
    <message>
        <source>Amber only where this frame shows no contrast; every filled vessel is blue.</source>
        <translation>仅此帧无对比剂处为琥珀色；充盈血管均为蓝色。</translation>
    </message>
    <message>
        <source>Small differences to both sides: beating and breathing. No rigid pose does better.</source>
        <translation>两侧均有小偏差：心跳与呼吸。没有更好的刚性位姿。</translation>
    </message>
    <message>
        <source>All lines miss to the same side. Register again, or nudge with the arrows.</source>
        <translation>所有线条偏向同一侧。请重新配准或用方向键微调。</translation>
    </message>
    <message>
        <source>Fits in the middle and misses more and more outwards: turned in the image plane.</source>
        <translation>中间吻合而向外偏差渐大：在图像平面内旋转。</translation>
    </message>
    <message>
        <source>The trunk fits, side branches point elsewhere: LAO/RAO or CRA/CAU are off.</source>
        <translation>主干吻合而侧支指向别处：LAO/RAO 或 CRA/CAU 有偏差。</translation>
    </message>
    <message>
        <source>What a good fit looks like</source>
        <translation>好的配准是什么样</translation>
    </message>
    <message>
        <source>Simulated vessels. Blue lies on a vessel, amber 2 mm off or more.</source>
        <translation>模拟血管。蓝色在血管上，琥珀色偏 2 mm 或以上。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>drawing …</source>
        <translation>绘制中……</translation>
    </message>
    <message>
        <source>Good: everything fits</source>
        <translation>好：全部吻合</translation>
    </message>
    <message>
        <source>Good: branches unfilled</source>
        <translation>好：部分分支未充盈</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::HeaderBar</name>
    <message>
        <source>Not for clinical use</source>
        <translation>不得用于临床</translation>
    </message>
    <message>
        <source>AngioPose is a research program, not a medical device.</source>
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
        <source>move away from or to the source</source>
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
        <source>turn LAO/RAO and CRA/CAU by 1°</source>
        <translation>转动 LAO/RAO 和 CRA/CAU 1°</translation>
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
        <source>pick a branch (Ctrl adds)</source>
        <translation>选择分支（Ctrl 追加）</translation>
    </message>
    <message>
        <source>In nudge mode</source>
        <translation>微调模式下</translation>
    </message>
    <message>
        <source>On the angiogram</source>
        <translation>在造影图像上</translation>
    </message>
    <message>
        <source>move; on the ring roll; Esc takes it back, then ends the mode</source>
        <translation>平移；在圆环上旋转；Esc 取消，再按结束模式</translation>
    </message>
    <message>
        <source>Ctrl+wheel</source>
        <translation>Ctrl+滚轮</translation>
    </message>
    <message>
        <source>right click</source>
        <translation>右键单击</translation>
    </message>
    <message>
        <source>menu of what can be done here</source>
        <translation>此处可用操作的菜单</translation>
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
        <source>double click</source>
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
        <source>On the 3-D view</source>
        <translation>在三维视图上</translation>
    </message>
    <message>
        <source>in 3-D or a slice, then in the image: one pair</source>
        <translation>先在三维或断层，再在图像：一对</translation>
    </message>
    <message>
        <source>a node of the vessels to its place, or a cross elsewhere</source>
        <translation>将血管节点拖到其位置，或移动十字</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>回车</translation>
    </message>
    <message>
        <source>place the vessels by the pairs</source>
        <translation>按点对放置血管</translation>
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
        <source>click curves that are no vessels</source>
        <translation>单击非血管曲线</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>erase with a brush; [ ] its size</source>
        <translation>用笔刷擦除；[ ] 大小</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>draw: Enter ends, Backspace takes a point back, Shift straight</source>
        <translation>绘制：回车结束，退格撤一点，Shift 直线</translation>
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
        <source>box or lasso around what is no vessel; Ctrl: keep the inside alone</source>
        <translation>框选或套索非血管部分；Ctrl：仅保留内部</translation>
    </message>
    <message>
        <source>✓ ✗</source>
        <translation>✓ ✗</translation>
    </message>
    <message>
        <source>dashed curves may be a catheter: keep or leave out</source>
        <translation>虚线可能为导管：保留或排除</translation>
    </message>
    <message>
        <source>click, left drag, Ctrl+arrows</source>
        <translation>单击、左键拖动、Ctrl+方向键</translation>
    </message>
    <message>
        <source>cross-hair, linked with all views</source>
        <translation>十字线，与所有视图联动</translation>
    </message>
    <message>
        <source>picks the point at the cross-hair, as a click does</source>
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
        <source>window and level; a right click opens the menu</source>
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
        <source>all slices large, and back</source>
        <translation>所有断层放大，再返回</translation>
    </message>
    <message>
        <source>While clicking landmarks</source>
        <translation>点选标志点时</translation>
    </message>
    <message>
        <source>While editing vessels</source>
        <translation>编辑血管时</translation>
    </message>
    <message>
        <source>On a slice</source>
        <translation>在断层上</translation>
    </message>
    <message>
        <source>this view alone, and back</source>
        <translation>仅显示此视图，再次恢复</translation>
    </message>
    <message>
        <source>S, then A or Del</source>
        <translation>S，再按 A 或 Del</translation>
    </message>
    <message>
        <source>the next of the dashed curves: keep or leave out</source>
        <translation>下一条虚线曲线：保留或排除</translation>
    </message>
    <message>
        <source>While picking the pivot</source>
        <translation>选取旋转中心时</translation>
    </message>
    <message>
        <source>a place on the vessels, in the image, in 3-D or in a slice</source>
        <translation>血管上的位置：图像、三维视图或切片中</translation>
    </message>
    <message>
        <source>← →</source>
        <translation>← →</translation>
    </message>
    <message>
        <source>the next bifurcation or end</source>
        <translation>下一个分叉或末端</translation>
    </message>
    <message>
        <source>takes the place shown</source>
        <translation>采用所示位置</translation>
    </message>
    <message>
        <source>back to the centroid</source>
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
        <source>set a point, or move one that is there</source>
        <translation>放置点，或移动已有的点</translation>
    </message>
    <message>
        <source>Enter, double click</source>
        <translation>回车、双击</translation>
    </message>
    <message>
        <source>closes an area</source>
        <translation>闭合区域</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>退格</translation>
    </message>
    <message>
        <source>takes a point back</source>
        <translation>撤回一个点</translation>
    </message>
    <message>
        <source>removes the chosen measurement, or the last</source>
        <translation>移除所选测量，或最后一个</translation>
    </message>
    <message>
        <source>While marking</source>
        <translation>标记时</translation>
    </message>
    <message>
        <source>sets a check point or ring on the vessels, here, in 3-D or in a slice</source>
        <translation>在血管上设置检查点或环：此处、三维或切片中</translation>
    </message>
    <message>
        <source>draws an arrow, or moves what is there</source>
        <translation>绘制箭头，或移动已有的</translation>
    </message>
    <message>
        <source>ends a text; Esc drops it</source>
        <translation>结束文字；Esc 放弃</translation>
    </message>
    <message>
        <source>removes the chosen mark, or the last</source>
        <translation>移除所选标记，或最后一个</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::KeySheet</name>
    <message>
        <source>Keys</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>Search keys and what they do</source>
        <translation>搜索快捷键及其作用</translation>
    </message>
    <message>
        <source>Search keys</source>
        <translation>搜索快捷键</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>No key for “%1”.</source>
        <translation>没有“%1”的快捷键。</translation>
    </message>
    <message>
        <source>Keys and what they do</source>
        <translation>快捷键及其作用</translation>
    </message>
    <message>
        <source>Reset all keys</source>
        <translation>重置所有快捷键</translation>
    </message>
    <message>
        <source>Enter or double-click on a line takes a new key for it.</source>
        <translation>在某行按回车或双击可设置新快捷键。</translation>
    </message>
    <message>
        <source>This key is fixed.</source>
        <translation>此快捷键固定。</translation>
    </message>
    <message>
        <source>Press the new key for “%1”. Esc keeps the old one, Delete leaves none.</source>
        <translation>请按“%1”的新快捷键。Esc 保留原键，Delete 清除。</translation>
    </message>
    <message>
        <source>The old key stays.</source>
        <translation>保留原快捷键。</translation>
    </message>
    <message>
        <source>“%1” is needed elsewhere. Press another key.</source>
        <translation>“%1”另有用途。请按其他键。</translation>
    </message>
    <message>
        <source>“%1” belongs to “%2”. Press it again to take it from there, or press another key.</source>
        <translation>“%1”属于“%2”。再按一次可改用，或按其他键。</translation>
    </message>
    <message>
        <source>No key any more.</source>
        <translation>已清除快捷键。</translation>
    </message>
    <message>
        <source>The key is “%1” now.</source>
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
        <source>Ticks every label of the list</source>
        <translation>勾选列表中的所有标签</translation>
    </message>
    <message>
        <source>None</source>
        <translation>全不选</translation>
    </message>
    <message>
        <source>Unticks every label of the list</source>
        <translation>取消勾选列表中的所有标签</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>血管</translation>
    </message>
    <message>
        <source>Ticks those that are vessels by their names</source>
        <translation>勾选名称表明是血管的标签</translation>
    </message>
    <message>
        <source>Find a label</source>
        <translation>查找标签</translation>
    </message>
    <message>
        <source>Labels that are vessels</source>
        <translation>属于血管的标签</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Reading the labels …</source>
        <translation>正在读取标签……</translation>
    </message>
    <message>
        <source>%1 of %2 ticked, %3</source>
        <translation>已勾选 %1 / %2，%3</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::LandmarkPanel</name>
    <message>
        <source>Landmarks</source>
        <translation>标志点</translation>
    </message>
    <message>
        <source>Place vessels</source>
        <translation>放置血管</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Landmarks and how far each is off</source>
        <translation>标志点及其偏差</translation>
    </message>
    <message>
        <source>Find the start pose from the pairs: Enter while clicking. Undo brings the old one back.</source>
        <translation>由点对求初始位姿：点选时按回车。可撤销。</translation>
    </message>
    <message>
        <source>Remove the chosen pairs: Delete</source>
        <translation>移除所选点对：Delete</translation>
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
        <source>Click pairs</source>
        <translation>点选成对</translation>
    </message>
    <message>
        <source>A place on the vessels in 3-D (or a slice), then the same place in the image.</source>
        <translation>先在三维（或断层）血管上，再在图像同一处点选。</translation>
    </message>
    <message>
        <source>%1: click pairs, then place</source>
        <translation>%1：点击成对点，然后放置</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::LandmarkTool</name>
    <message>
        <source>Landmarks: now click the same place in the image</source>
        <translation>标志点：请在图像中单击同一位置</translation>
    </message>
    <message>
        <source>Landmarks: now click the same place on the vessels in 3-D</source>
        <translation>标志点：请在三维血管上单击同一位置</translation>
    </message>
    <message>
        <source>Landmarks: click in 3-D and here, or drag a node · Enter places</source>
        <translation>标志点：在三维和此处单击，或拖动节点 · 回车放置</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::LassoTool</name>
    <message>
        <source>Lasso: draw around the auxiliary branches, Shift adds, Ctrl removes, Esc ends</source>
        <translation>套索：圈选辅助分支，Shift 追加，Ctrl 移除，Esc 结束</translation>
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
        <translation>AngioPose：三维和切片</translation>
    </message>
    <message>
        <source>AngioPose: slices</source>
        <translation>AngioPose：切片</translation>
    </message>
    <message>
        <source>Branches, 3-D and slices</source>
        <translation>分支、三维和切片</translation>
    </message>
    <message>
        <source>Pose, registration, result</source>
        <translation>位姿、配准、结果</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MaskShiftTool</name>
    <message>
        <source>Mask: arrows or drag move it, Shift 1 px, Ctrl 0.05 px, Esc ends · right %1, down %2 px</source>
        <translation>蒙片：方向键或拖动，Shift 1 px，Ctrl 0.05 px，Esc 结束 · 右 %1，下 %2 px</translation>
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
        <source>Where are the inputs?</source>
        <translation>输入文件在哪里？</translation>
    </message>
    <message>
        <source>“%1” refers to files that are not where they were, and a search beside it and among recent cases did not find them. The case itself is unharmed.</source>
        <translation>“%1”引用的文件已不在原处，在其旁和最近病例中也未找到。病例本身完好。</translation>
    </message>
    <message>
        <source>was in %1</source>
        <translation>原在 %1</translation>
    </message>
    <message>
        <source>Locate …</source>
        <translation>查找……</translation>
    </message>
    <message>
        <source>Locate %1</source>
        <translation>查找 %1</translation>
    </message>
    <message>
        <source>Search a folder …</source>
        <translation>搜索文件夹……</translation>
    </message>
    <message>
        <source>Looks in the folder and all below it, by name and by content.</source>
        <translation>在文件夹及其子文件夹中按名称和内容查找。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>现为 %1</translation>
    </message>
    <message>
        <source>Search a folder</source>
        <translation>搜索文件夹</translation>
    </message>
    <message>
        <source>Open without</source>
        <translation>不含缺失项打开</translation>
    </message>
    <message>
        <source>What is missing is a scan beside the vessels, or another view: the rest opens.</source>
        <translation>缺少的是血管旁的扫描或另一视图：其余可打开。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MotionPlot</name>
    <message>
        <source>Motion of the vessels by frame</source>
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
        <source>frame %1: %2 mm across, %3 mm in depth, %4°</source>
        <translation>第 %1 帧：横向 %2 mm，深度 %3 mm，%4°</translation>
    </message>
    <message>
        <source>%1 (not explained by the vessels)</source>
        <translation>%1（血管无法解释）</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::NudgeTool</name>
    <message>
        <source>Nudge: drag shifts, ring rolls, arcs turn, slide is depth, Ctrl is fine, Esc takes back</source>
        <translation>微调：拖动平移，圆环滚转，弧线转动，左侧箭头调深度，Ctrl 精细，Esc 撤回</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::OpacificationPlot</name>
    <message>
        <source>Opacification over the frames</source>
        <translation>各帧充盈曲线</translation>
    </message>
    <message>
        <source>%1 · %2 s</source>
        <translation>%1 · %2 s</translation>
    </message>
    <message>
        <source>Only runs of several frames have a curve</source>
        <translation>只有多帧序列才有曲线</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PivotMark</name>
    <message>
        <source>pivot</source>
        <translation>旋转中心</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PivotTool</name>
    <message>
        <source>Pivot: click the vessels, here or in 3-D · ← → and Enter: bifurcations · Del: centroid</source>
        <translation>旋转中心：在此处或三维视图中点击血管 · ← → 和回车：分叉 · Delete：质心</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PortDialog</name>
    <message>
        <source>Encrypted (TLS)</source>
        <translation>加密（TLS）</translation>
    </message>
    <message>
        <source>Our certificate (PEM)</source>
        <translation>我方证书（PEM）</translation>
    </message>
    <message>
        <source>Key of our certificate (PEM)</source>
        <translation>我方证书的密钥（PEM）</translation>
    </message>
    <message>
        <source>Certificates trusted (PEM)</source>
        <translation>受信任的证书（PEM）</translation>
    </message>
    <message>
        <source>Security of the receiving port</source>
        <translation>接收端口的安全设置</translation>
    </message>
    <message>
        <source>With TLS, callers must show a certificate that checks, and so do we.</source>
        <translation>使用 TLS 时，呼叫方必须出示有效证书，我方亦然。</translation>
    </message>
    <message>
        <source>anyone</source>
        <translation>任何人</translation>
    </message>
    <message>
        <source>AE titles that may call</source>
        <translation>允许呼叫的 AE 标题</translation>
    </message>
    <message>
        <source>With commas between them; empty: any</source>
        <translation>以逗号分隔；留空：任何</translation>
    </message>
    <message>
        <source>Addresses that may call</source>
        <translation>允许呼叫的地址</translation>
    </message>
    <message>
        <source>IP addresses with commas between them, as 10.0.0.7; empty: any</source>
        <translation>以逗号分隔的 IP 地址，如 10.0.0.7；留空：任何</translation>
    </message>
    <message>
        <source>Our certificate</source>
        <translation>我方证书</translation>
    </message>
    <message>
        <source>PEM file that callers see</source>
        <translation>呼叫方可见的 PEM 文件</translation>
    </message>
    <message>
        <source>Its key</source>
        <translation>其密钥</translation>
    </message>
    <message>
        <source>PEM file; only its path is stored</source>
        <translation>PEM 文件；仅保存其路径</translation>
    </message>
    <message>
        <source>Certificates trusted</source>
        <translation>受信任的证书</translation>
    </message>
    <message>
        <source>PEM file by which those of callers are checked; empty: those that the system trusts</source>
        <translation>用于核对呼叫方证书的 PEM 文件；留空：系统信任的证书</translation>
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
        <source>along ray</source>
        <translation>沿射线</translation>
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
        <source>As if the C-arm went to LAO (+) or RAO (−). Nudge: Alt+← Alt+→</source>
        <translation>相当于 C 形臂转向 LAO (+) 或 RAO (−)。微调：Alt+← Alt+→</translation>
    </message>
    <message>
        <source>As if the C-arm went cranial (+) or caudal (−). Nudge: Alt+↑ Alt+↓</source>
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
        <source>Back to start pose</source>
        <translation>回到初始位姿</translation>
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
        <source>Keep this value: nudging, dragging, typing and Register leave it as it is.</source>
        <translation>保持此值：微调、拖动、输入和配准均不改变。</translation>
    </message>
    <message>
        <source>Undo brings the pose back.</source>
        <translation>撤销可恢复位姿。</translation>
    </message>
    <message>
        <source>nudging · arrows · %1 ends</source>
        <translation>微调中 · 方向键 · %1 结束</translation>
    </message>
    <message>
        <source>nudge %1 · fine Ctrl · coarse Shift</source>
        <translation>微调 %1 · 精细 Ctrl · 粗调 Shift</translation>
    </message>
    <message>
        <source>Turns about the picked pivot, and shifts are those of it. %1 goes back to the centroid.</source>
        <translation>围绕所选旋转中心转动，位移亦指该点。%1 恢复为质心。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PoseTable</name>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Runs the ticked methods one after the other from the pose as it is.</source>
        <translation>从当前位姿依次运行所勾选的方法。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stops the running method and skips the rest; what is finished stays.</source>
        <translation>停止当前方法并跳过其余；已完成的保留。</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Moves the vessels there; undo takes it back.</source>
        <translation>将血管移到该处；可撤销。</translation>
    </message>
    <message>
        <source>Use as reference</source>
        <translation>作为参考</translation>
    </message>
    <message>
        <source>Differences are told from this pose.</source>
        <translation>以此位姿计算差值。</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Removes the snapshots; undo brings them back.</source>
        <translation>移除快照；可撤销。</translation>
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
        <source>median mm</source>
        <translation>中位数 mm</translation>
    </message>
    <message>
        <source>95 % mm</source>
        <translation>95 % mm</translation>
    </message>
    <message>
        <source>covered %</source>
        <translation>覆盖 %</translation>
    </message>
    <message>
        <source>Δ in plane mm</source>
        <translation>Δ 平面内 mm</translation>
    </message>
    <message>
        <source>Δ depth mm</source>
        <translation>Δ 深度 mm</translation>
    </message>
    <message>
        <source>Δ turn °</source>
        <translation>Δ 旋转 °</translation>
    </message>
    <message>
        <source>run ms</source>
        <translation>用时 ms</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>作者</translation>
    </message>
    <message>
        <source>When</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Export CSV …</source>
        <translation>导出 CSV……</translation>
    </message>
    <message>
        <source>Writes the table with poses as matrices.</source>
        <translation>导出表格，位姿为矩阵。</translation>
    </message>
    <message>
        <source>Run several methods</source>
        <translation>运行多种方法</translation>
    </message>
    <message>
        <source>each leaves its pose in the table; the case keeps its own</source>
        <translation>各方法位姿留在表中；病例保持原位姿</translation>
    </message>
    <message>
        <source>The pose as it is</source>
        <translation>当前位姿</translation>
    </message>
    <message>
        <source>This fit was not trustworthy.</source>
        <translation>此配准不可信。</translation>
    </message>
    <message>
        <source>Differences are told from “%1”, about the centre of the tree. Amber: not trustworthy.</source>
        <translation>差值相对“%1”，绕血管树中心。琥珀色：不可信。</translation>
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
        <source>Remove end branches that are</source>
        <translation>移除末端分支，条件为</translation>
    </message>
    <message>
        <source>shorter than</source>
        <translation>短于</translation>
    </message>
    <message>
        <source>on average thinner than (radius)</source>
        <translation>平均细于（半径）</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Nothing would be left. Lower the limits.</source>
        <translation>将一无所剩。请降低限值。</translation>
    </message>
    <message>
        <source>No branch goes.</source>
        <translation>不移除分支。</translation>
    </message>
    <message>
        <source>1 branch goes.</source>
        <translation>移除 1 个分支。</translation>
    </message>
    <message>
        <source>%1 branches go.</source>
        <translation>移除 %1 个分支。</translation>
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
        <source>AngioPose ended unexpectedly. These cases had changes that were not saved; recovering opens the copy and leaves the saved case as it is.</source>
        <translation>AngioPose 意外退出。这些病例有未保存的更改；恢复会打开副本，已保存的病例不变。</translation>
    </message>
    <message>
        <source>Decide later</source>
        <translation>以后再定</translation>
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
        <source>Ends the run and keeps the best pose so far.</source>
        <translation>结束并保留目前最佳位姿。</translation>
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
        <source>What this method minimises, when it fails, and its source.</source>
        <translation>此方法的目标函数、失效情形及出处。</translation>
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
        <source>Registering …</source>
        <translation>配准中……</translation>
    </message>
    <message>
        <source>Register keeps the locked degree of freedom.</source>
        <translation>配准保持锁定的自由度。</translation>
    </message>
    <message>
        <source>Register keeps the %1 locked degrees of freedom.</source>
        <translation>配准保持 %1 个锁定的自由度。</translation>
    </message>
    <message>
        <source>All %1 views together</source>
        <translation>%1 个视图一起配准</translation>
    </message>
    <message>
        <source>Finds the pose that lays the vessels onto the angiogram.</source>
        <translation>求使血管与造影图像重合的位姿。</translation>
    </message>
    <message>
        <source>One pose for all views: moving by hand moves the vessels in all of them, and Register fits all by AngioPose&apos;s own method, for depth in one view is a shift in another. Without the tick only the shown view is meant.</source>
        <translation>所有视图共用一个位姿：手动移动时各视图中的血管一起移动，配准时用 AngioPose 自己的方法同时拟合所有视图，因为一个视图中的深度就是另一个视图中的平移。不勾选时只针对显示的视图。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ResultPanel</name>
    <message>
        <source>%1 · of an earlier run</source>
        <translation>%1 · 来自较早的运行</translation>
    </message>
    <message>
        <source>What this pose was fitted to has changed since the run that found it. R registers again.</source>
        <translation>自找到此位姿的运行以来，其拟合的对象已改变。按 R 重新配准。</translation>
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
        <translation>%1 · 手动移动</translation>
    </message>
    <message>
        <source>%1 · start pose</source>
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
        <source>95 %, mm</source>
        <translation>95 %，mm</translation>
    </message>
    <message>
        <source>covered</source>
        <translation>覆盖率</translation>
    </message>
    <message>
        <source>Share of the traced vessels that the tree explains within 3 px.</source>
        <translation>3 px 内被血管树解释的提取血管比例。</translation>
    </message>
    <message>
        <source>± is one standard deviation.</source>
        <translation>± 为一个标准差。</translation>
    </message>
    <message>
        <source>nothing to judge yet</source>
        <translation>尚无可评估内容</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>This is the start pose: nothing is fitted yet. R registers, N nudges.</source>
        <translation>这是初始位姿：尚未配准。R 配准，N 微调。</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>mm across, by frame</source>
        <translation>横向 mm，逐帧</translation>
    </message>
    <message>
        <source>%1 · followed</source>
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
        <source>median %1 mm over %2 % judged opacified, whole tree %3 mm</source>
        <translation>中位数 %1 mm（判为显影的 %2 %），整棵树 %3 mm</translation>
    </message>
    <message>
        <source>median %1 mm</source>
        <translation>中位数 %1 mm</translation>
    </message>
    <message>
        <source>Moved by hand, not registered</source>
        <translation>手动移动，未配准</translation>
    </message>
    <message>
        <source>Inputs changed since this registration</source>
        <translation>此次配准后输入已改变</translation>
    </message>
    <message>
        <source>Start pose, not registered</source>
        <translation>初始位姿，未配准</translation>
    </message>
    <message>
        <source>NOT RELIABLE · %1</source>
        <translation>不可靠 · %1</translation>
    </message>
    <message>
        <source>No check speaks against it · %1</source>
        <translation>没有检查反对 · %1</translation>
    </message>
    <message>
        <source>Half of the vessel points judged opacified lie nearer than this.</source>
        <translation>判为显影的血管点中一半小于此距离。</translation>
    </message>
    <message>
        <source>95 of 100 vessel points judged opacified lie nearer than this.</source>
        <translation>判为显影的血管点中 95% 小于此距离。</translation>
    </message>
    <message>
        <source>mm, points judged opacified</source>
        <translation>mm，判为显影的点</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ResultSentences</name>
    <message>
        <source>%1 of %2 branches agree within %3 mm.</source>
        <translation>%2 个分支中有 %1 个在 %3 mm 内吻合。</translation>
    </message>
    <message>
        <source>Depth ±%1 mm: one view cannot tell it.</source>
        <translation>深度 ±%1 mm：单一投影无法确定。</translation>
    </message>
    <message>
        <source>Within 2 mm of the vessels with a probability of %1 %.</source>
        <translation>位于血管 2 mm 以内的概率为 %1 %。</translation>
    </message>
    <message>
        <source>Depth is the least certain: ±%1 mm.</source>
        <translation>深度最不确定：±%1 mm。</translation>
    </message>
    <message>
        <source>%1 is %2 mm off: perhaps unfilled in this frame, or moved.</source>
        <translation>%1 偏离 %2 mm：此帧可能未充盈，或已移位。</translation>
    </message>
    <message>
        <source>%1 branches are up to %2 mm off: unfilled in this frame, or the pose is wrong.</source>
        <translation>%1 个分支最多偏离 %2 mm：此帧未充盈，或位姿有误。</translation>
    </message>
    <message>
        <source>%1 and %2 are up to %3 mm off: perhaps unfilled in this frame, or moved.</source>
        <translation>%1 和 %2 最多偏离 %3 mm：此帧可能未充盈，或已移位。</translation>
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
        <source>With the errors of the geometry: depth ±%1 mm, sideways ±%2 mm.</source>
        <translation>含几何误差：深度 ±%1 mm，横向 ±%2 mm。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::Section</name>
    <message>
        <source>Fold %1</source>
        <translation>折叠 %1</translation>
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
        <source>%1 holds %n series.</source>
        <translation>
            <numerusform>%1 含 %n 个序列。</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Series of the folder</source>
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
        <source>Spacing in mm</source>
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
        <source>by hand</source>
        <translation>手动</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SnapshotPanel</name>
    <message>
        <source>median %1 mm, 95 % %2 mm, covered %3 %</source>
        <translation>中位数 %1 mm，95 % %2 mm，覆盖 %3 %</translation>
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
        <source>Compare …</source>
        <translation>比较……</translation>
    </message>
    <message>
        <source>Kept poses</source>
        <translation>保留的位姿</translation>
    </message>
    <message>
        <source>Runs (%1)</source>
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
        <source>%1 keeps the pose; %2 goes between two. Every run leaves its pose here.</source>
        <translation>%1 保留位姿；%2 在两者间切换。每次配准的位姿都留在此处。</translation>
    </message>
    <message>
        <source>Keep pose</source>
        <translation>保留位姿</translation>
    </message>
    <message>
        <source>Keeps this pose with its numbers under a name.</source>
        <translation>以名称保留此位姿及其数值。</translation>
    </message>
    <message>
        <source>Poses and methods side by side, as a table.</source>
        <translation>位姿和方法并列成表。</translation>
    </message>
    <message>
        <source>median mm · %1: A ⇄ B</source>
        <translation>中位数 mm · %1：A ⇄ B</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SolutionStrip</name>
    <message>
        <source>Solutions</source>
        <translation>解</translation>
    </message>
    <message>
        <source>Solutions of the run</source>
        <translation>本次配准的解</translation>
    </message>
    <message>
        <source>%1 shows the next · %2 takes it</source>
        <translation>%1 下一个 · %2 采用</translation>
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
        <source>Start pose</source>
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
        <source>needs a look</source>
        <translation>需查看</translation>
    </message>
    <message>
        <source>open</source>
        <translation>未完成</translation>
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
        <source>Then click vessels in a slice: only what is connected to a seed is traced.</source>
        <translation>然后在断层上单击血管：只提取与种子点相连的部分。</translation>
    </message>
    <message>
        <source>Avoid</source>
        <translation>避开</translation>
    </message>
    <message>
        <source>Then click heart, veins or bone in a slice: what is reached from there on wider ways is left out.</source>
        <translation>然后单击心脏、静脉或骨骼：从该处经较宽通路可达的部分略去。</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Seeds and places to avoid</source>
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
        <source>Show in the slices what is above</source>
        <translation>在断层中显示高于阈值的部分</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>阈值</translation>
    </message>
    <message>
        <source>The vessels begin at this value of the scan.</source>
        <translation>血管从此扫描值开始。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::TracingPanel</name>
    <message>
        <source>Thin vessels only, from the seeds</source>
        <translation>仅细血管，从种子点开始</translation>
    </message>
    <message>
        <source>For coronary arteries beside filled chambers, hepatic arteries beside the portal vein: what is wider than a centimetre ends the vessels. Needs seeds.</source>
        <translation>用于充盈心腔旁的冠状动脉、门静脉旁的肝动脉：宽于一厘米的结构会终止血管。需要种子点。</translation>
    </message>
    <message>
        <source>One vessel by two clicks</source>
        <translation>两次单击提取一条血管</translation>
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
        <source>Shortest branch</source>
        <translation>最短分支</translation>
    </message>
    <message>
        <source>Branches that leave their parent&apos;s wall by less are removed.</source>
        <translation>超出母血管壁不足此值的分支移除。</translation>
    </message>
    <message>
        <source>Thinnest branch</source>
        <translation>最细分支</translation>
    </message>
    <message>
        <source>Branches whose mean radius is smaller are removed.</source>
        <translation>平均半径更小的分支移除。</translation>
    </message>
    <message>
        <source>Keep loops</source>
        <translation>保留环</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>部分</translation>
    </message>
    <message>
        <source>Without seeds. As usual: all pieces of a mask, of a scan the great vessel&apos;s. All of a scan: those of every great vessel.</source>
        <translation>无种子点时。常规：掩膜的所有部分；扫描中为大血管所在部分。扫描的全部：每条大血管所在部分。</translation>
    </message>
    <message>
        <source>As usual</source>
        <translation>常规</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>The largest</source>
        <translation>最大的一段</translation>
    </message>
    <message>
        <source>Vessels that run in a circle stay closed, else each is opened where it is thinnest.</source>
        <translation>环状血管保持闭合；否则在最细处断开。</translation>
    </message>
    <message>
        <source>Ends the tracing; the vessels stay as they were.</source>
        <translation>结束提取；血管保持原样。</translation>
    </message>
    <message>
        <source>Tracing …</source>
        <translation>提取中……</translation>
    </message>
    <message>
        <source>Click in a slice to place a point; Esc ends.</source>
        <translation>在断层上单击放点；Esc 结束。</translation>
    </message>
    <message>
        <source>The traced vessels replace the tree; undo brings it back.</source>
        <translation>提取的血管替换血管树；可撤销。</translation>
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
        <source>Moves the slices to the vessel that was not traced.</source>
        <translation>将切面移到未提取的血管。</translation>
    </message>
    <message>
        <source>Places a seed in this vessel, and one in the traced vessel beside it.</source>
        <translation>在此血管及其旁的已提取血管内各放置一个种子点。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::TreeView</name>
    <message>
        <source>No vessels yet: drop some here, open them (%1), or trace a scan in its slices (%2).</source>
        <translation>尚无血管：拖放到此处，打开（%1），或在切片中追踪扫描（%2）。</translation>
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
        <source>Ends the trial; the log says that it was abandoned.</source>
        <translation>结束试验；记录为放弃。</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Blind trial of %1: lay the vessels onto the image. Numbers come back when you are done.</source>
        <translation>%1 的盲法试验：将血管对准图像。完成后恢复数值。</translation>
    </message>
    <message>
        <source>Logs time and pose, and brings the numbers back.</source>
        <translation>记录时间和位姿，并恢复数值显示。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ViewFrame</name>
    <message>
        <source>In a window of its own</source>
        <translation>在独立窗口中</translation>
    </message>
    <message>
        <source>Bring it back</source>
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
        <source>All views beside each other, or the shown one alone</source>
        <translation>并排显示所有视图，或只显示当前视图</translation>
    </message>
    <message>
        <source>Cross-hair</source>
        <translation>十字线</translation>
    </message>
    <message>
        <source>What is under the pointer in one view is a line in the others, and a point on the vessels</source>
        <translation>一个视图中指针所指之处，在其他视图中显示为一条线，在血管上显示为一个点</translation>
    </message>
    <message>
        <source>Views of the case</source>
        <translation>病例的视图</translation>
    </message>
    <message>
        <source>Add a view</source>
        <translation>添加视图</translation>
    </message>
    <message>
        <source>Another angiogram of the same vessels (Ctrl+Shift+V)</source>
        <translation>同一血管的另一血管造影（Ctrl+Shift+V）</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::VtkView</name>
    <message>
        <source>The 3-D view needs OpenGL 3.2, which this display does not offer. Everything else works. Try LIBGL_ALWAYS_SOFTWARE=1, or install libgl1-mesa-dri.</source>
        <translation>三维视图需要 OpenGL 3.2，此显示环境不支持。其他功能正常。可尝试 LIBGL_ALWAYS_SOFTWARE=1，或安装 libgl1-mesa-dri。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::WelcomePage</name>
    <message>
        <source>Lay a vessel tree onto its angiogram</source>
        <translation>将血管树对准造影图像</translation>
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
        <source>Vessels: CT as DICOM folder, NIfTI, NRRD or MetaImage, masks, centrelines (VTP, VTK, CSV, SWC).  Angiograms: DICOM XA, PNG, TIFF.</source>
        <translation>血管：CT（DICOM 文件夹、NIfTI、NRRD 或 MetaImage）、掩膜、中心线（VTP、VTK、CSV、SWC）。造影图像：DICOM XA、PNG、TIFF。</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>打开……</translation>
    </message>
    <message>
        <source>Open folder or disc …</source>
        <translation>打开文件夹或光盘……</translation>
    </message>
    <message>
        <source>Lists the patients, studies and series of a folder, a CD or a DICOMDIR.</source>
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
        <source>In the whole window</source>
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
        <source>Own window</source>
        <translation>独立窗口</translation>
    </message>
    <message>
        <source>Back to the angiogram</source>
        <translation>返回造影图像</translation>
    </message>
    <message>
        <source>The slices in a window of their own, and back (F9)</source>
        <translation>切片用独立窗口，再次移回（F9）</translation>
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
        <source>From the values of this scan; right drag in a slice changes it by hand.</source>
        <translation>取自此扫描的数值；在断层上右键拖动可手动调整。</translation>
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
        <source>Nothing has been told yet.</source>
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
        <source>Move point of measurement</source>
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
        <source>Type scale of the image</source>
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
        <source>Table …</source>
        <translation>表格……</translation>
    </message>
    <message>
        <source>Where it is measured</source>
        <translation>测量位置</translation>
    </message>
    <message>
        <source>Lengths at the depth of the vessels, on the detector, or in pixels.</source>
        <translation>长度取血管深度处、探测器上或像素。</translation>
    </message>
    <message>
        <source>Remove the chosen measurements: Delete</source>
        <translation>移除所选测量：Delete</translation>
    </message>
    <message>
        <source>Writes all measurements with their basis as a CSV table.</source>
        <translation>将所有测量及其依据写为 CSV 表格。</translation>
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
        <source>by a typed scale</source>
        <translation>按输入比例</translation>
    </message>
    <message>
        <source> mm per pixel</source>
        <translation> mm/像素</translation>
    </message>
    <message>
        <source>scale not typed</source>
        <translation>未输入比例</translation>
    </message>
    <message>
        <source>Scale of the image</source>
        <translation>图像比例</translation>
    </message>
    <message>
        <source>What a pixel measures in the patient, where it is known from elsewhere.</source>
        <translation>一个像素在患者体内的长度（若另有来源已知）。</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Measurements in image and slices</source>
        <translation>图像和断层中的测量</translation>
    </message>
    <message>
        <source>%1 measured</source>
        <translation>已测 %1 项</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MeasureTool</name>
    <message>
        <source>Length: drag, or click both ends · points can be moved</source>
        <translation>长度：拖动，或单击两端 · 点可移动</translation>
    </message>
    <message>
        <source>Angle: click an end, the vertex, the other end · points can be moved</source>
        <translation>角度：单击一端、顶点、另一端 · 点可移动</translation>
    </message>
    <message>
        <source>Area: click around it; double click or Enter closes · points can be moved</source>
        <translation>面积：沿边界单击；双击或回车闭合 · 点可移动</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ProfileController</name>
    <message>
        <source>Choose one branch, in the list or in a view.</source>
        <translation>在列表或视图中选择一个分支。</translation>
    </message>
    <message>
        <source>Open the vessels first.</source>
        <translation>请先打开血管。</translation>
    </message>
    <message>
        <source>Export measures of the branches</source>
        <translation>导出各分支的测量</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Export profile</source>
        <translation>导出轮廓</translation>
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
        <source>All branches …</source>
        <translation>所有分支……</translation>
    </message>
    <message>
        <source>Profile …</source>
        <translation>轮廓……</translation>
    </message>
    <message>
        <source>Writes length, diameters, narrowing and bends of all branches as a CSV table.</source>
        <translation>将所有分支的长度、直径、狭窄和弯曲写为 CSV 表格。</translation>
    </message>
    <message>
        <source>Writes diameter and curvature along this branch as a CSV table.</source>
        <translation>将沿此分支的直径和曲率写为 CSV 表格。</translation>
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
        <source>Least diameter</source>
        <translation>最小直径</translation>
    </message>
    <message>
        <source>Narrowest place</source>
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
        <source>Diameters are twice the radii of the tree; the narrowest place is told against the rest of the branch.</source>
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
        <source>bend %1/mm</source>
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
        <source>Stops at the frame that is shown. Esc goes back to the one before.</source>
        <translation>停在当前显示的帧。Esc 返回播放前的帧。</translation>
    </message>
    <message>
        <source>Plays the run</source>
        <translation>播放序列</translation>
    </message>
    <message>
        <source>At the end from the start again</source>
        <translation>播到末尾后从头开始</translation>
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
        <source>%1 · %2/s</source>
        <translation>%1 · %2/s</translation>
    </message>
    <message>
        <source>The header does not say how fast the run was taken: 1× takes %1 frames a second</source>
        <translation>文件头未说明采集速度：1× 按每秒 %1 帧</translation>
    </message>
    <message>
        <source>1×: as fast as the run was taken, %1 frames a second</source>
        <translation>1×：与采集速度相同，每秒 %1 帧</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MarkPanel</name>
    <message>
        <source>Check point</source>
        <translation>检查点</translation>
    </message>
    <message>
        <source>Ostium ring</source>
        <translation>开口环</translation>
    </message>
    <message>
        <source>Seen here</source>
        <translation>见于此处</translation>
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
        <source>Check points and marks</source>
        <translation>检查点与标记</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Table …</source>
        <translation>表格……</translation>
    </message>
    <message>
        <source>Remove the chosen marks: Delete</source>
        <translation>移除所选标记：Delete</translation>
    </message>
    <message>
        <source>Writes all check points and rings with their errors as a CSV table.</source>
        <translation>将所有检查点和环及其误差写入 CSV 表格。</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>标记</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MarkTool</name>
    <message>
        <source>Check point: click the vessels, here, in 3-D or in a slice · points can be moved</source>
        <translation>检查点：点击血管（此处、三维或切片） · 点可移动</translation>
    </message>
    <message>
        <source>Ostium ring: click the vessels, here, in 3-D or in a slice · rings can be moved</source>
        <translation>开口环：点击血管（此处、三维或切片） · 环可移动</translation>
    </message>
    <message>
        <source>Seen here: click where the chosen check point is seen, or drag it there</source>
        <translation>见于此处：点击所选检查点的所见位置，或将其拖到该处</translation>
    </message>
    <message>
        <source>Arrow: drag from its tail to its tip, then type · ends can be moved</source>
        <translation>箭头：从尾拖到尖，然后输入 · 端点可移动</translation>
    </message>
    <message>
        <source>Text: click where it begins, then type · texts can be moved</source>
        <translation>文字：点击起点，然后输入 · 文字可移动</translation>
    </message>
    <message>
        <source>Text on the image</source>
        <translation>图像上的文字</translation>
    </message>
    <message>
        <source>Text, then Enter</source>
        <translation>输入文字后按 Enter</translation>
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
        <source>Set check point</source>
        <translation>设置检查点</translation>
    </message>
    <message>
        <source>Set ostium ring</source>
        <translation>设置开口环</translation>
    </message>
    <message>
        <source>Set a check point on the vessels first.</source>
        <translation>请先在血管上设置检查点。</translation>
    </message>
    <message>
        <source>Say where a check point is seen</source>
        <translation>指出检查点所见位置</translation>
    </message>
    <message>
        <source>Draw arrow</source>
        <translation>绘制箭头</translation>
    </message>
    <message>
        <source>Write text</source>
        <translation>写文字</translation>
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
        <source>Places on the vessels with a name, and how far the pose puts them beside where they are seen; arrows and texts for pictures.</source>
        <translation>血管上的命名位置，以及位姿使其偏离所见位置的距离；用于图片的箭头和文字。</translation>
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
        <source>On frame %1 of this view, in every picture of it.</source>
        <translation>在此视图的第 %1 帧上，出现在其每张图片中。</translation>
    </message>
    <message>
        <source>Ostium %1</source>
        <translation>开口 %1</translation>
    </message>
    <message>
        <source>Check point %1</source>
        <translation>检查点 %1</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PathController</name>
    <message>
        <source>Trace one vessel</source>
        <translation>提取一条血管</translation>
    </message>
    <message>
        <source>Traced: one vessel of %1 mm.</source>
        <translation>已提取：一条 %1 mm 的血管。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PathTool</name>
    <message>
        <source>One vessel: click where it ends · Esc begins anew</source>
        <translation>一条血管：单击其终点 · Esc 重新开始</translation>
    </message>
    <message>
        <source>One vessel: click where it begins, then where it ends</source>
        <translation>一条血管：单击其起点，再单击终点</translation>
    </message>
</context>
<context>
    <name>angiopose::app::MaskController</name>
    <message>
        <source>Stopped: the vessels are as they were</source>
        <translation>已停止：血管保持原样</translation>
    </message>
    <message>
        <source>Tracing the mask … %1 %</source>
        <translation>正在提取掩膜…… %1 %</translation>
    </message>
    <message>
        <source>Open a scan or a label image first.</source>
        <translation>请先打开扫描或标签图像。</translation>
    </message>
    <message>
        <source>A registration is running. Stop it to edit.</source>
        <translation>配准正在运行。请停止后再编辑。</translation>
    </message>
    <message>
        <source>Paint into the mask</source>
        <translation>在掩膜中绘制</translation>
    </message>
    <message>
        <source>Erase from the mask</source>
        <translation>从掩膜中擦除</translation>
    </message>
    <message>
        <source>Nothing of the mask lies there.</source>
        <translation>该处没有掩膜。</translation>
    </message>
    <message>
        <source>Cut the mask</source>
        <translation>裁剪掩膜</translation>
    </message>
    <message>
        <source>Tracing the mask …</source>
        <translation>正在提取掩膜……</translation>
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
        <source>Saved without the latest changes of the mask: trace the mask, then save again.</source>
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
        <source>Shift+wheel, + and − change the brush</source>
        <translation>Shift+滚轮、+ 和 − 改变画笔</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::MaskCutTool</name>
    <message>
        <source>Scissors: draw around what goes · Shift keeps what lies inside</source>
        <translation>剪刀：圈出要去除的部分 · Shift 保留圈内部分</translation>
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
        <source>Ball, through the slices beside</source>
        <translation>球形，穿过相邻层面</translation>
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
        <source>Save mask …</source>
        <translation>保存掩膜……</translation>
    </message>
    <message>
        <source>Lumen mask</source>
        <translation>管腔掩膜</translation>
    </message>
    <message>
        <source>Makes the vessels anew from the mask as it is.</source>
        <translation>由当前掩膜重新生成血管。</translation>
    </message>
    <message>
        <source>Writes the mask as a label image.</source>
        <translation>将掩膜写为标签图像。</translation>
    </message>
    <message>
        <source>this slice alone</source>
        <translation>仅本层</translation>
    </message>
    <message>
        <source>slices beside it</source>
        <translation>相邻层面</translation>
    </message>
    <message>
        <source>whole depth</source>
        <translation>整个深度</translation>
    </message>
    <message>
        <source>Mask over the slices</source>
        <translation>断层上的掩膜</translation>
    </message>
    <message>
        <source>How strong the mask is shown over the slices.</source>
        <translation>掩膜在断层上显示的浓淡。</translation>
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
        <source>How deep scissors cut</source>
        <translation>剪刀裁剪深度</translation>
    </message>
    <message>
        <source>Depth on both sides of the slice</source>
        <translation>层面两侧的深度</translation>
    </message>
    <message>
        <source>Tracing the mask …</source>
        <translation>正在提取掩膜……</translation>
    </message>
    <message>
        <source>1 change of the mask is not in the vessels yet: trace the mask.</source>
        <translation>掩膜有 1 处更改尚未反映到血管：请提取掩膜。</translation>
    </message>
    <message>
        <source>%1 changes of the mask are not in the vessels yet: trace the mask.</source>
        <translation>掩膜有 %1 处更改尚未反映到血管：请提取掩膜。</translation>
    </message>
    <message>
        <source>The vessels come from a mask edited by hand.</source>
        <translation>血管来自手工编辑的掩膜。</translation>
    </message>
    <message>
        <source>Paint and cut, then trace the mask. Each stroke can be undone.</source>
        <translation>绘制和裁剪，然后提取掩膜。每一笔均可撤销。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SliceMeasureTool</name>
    <message>
        <source>Length: drag, or click both ends · points can be moved</source>
        <translation>长度：拖动，或单击两端 · 点可移动</translation>
    </message>
    <message>
        <source>Angle: click an end, the vertex, the other end · points can be moved</source>
        <translation>角度：单击一端、顶点、另一端 · 点可移动</translation>
    </message>
    <message>
        <source>Area: click around it; double click or Enter closes · points can be moved</source>
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
        <source>Unfold the column: %1</source>
        <translation>展开栏：%1</translation>
    </message>
    <message>
        <source>Unfold: %1</source>
        <translation>展开：%1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::FoldButton</name>
    <message>
        <source>Fold the column: %1</source>
        <translation>折叠栏：%1</translation>
    </message>
    <message>
        <source>Fold: %1</source>
        <translation>折叠：%1</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ScanBar</name>
    <message>
        <source>How the scan is shown behind the vessels</source>
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
        <source>Clear the list</source>
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
        <source>Could not open the folder</source>
        <translation>无法打开文件夹</translation>
    </message>
    <message>
        <source>Looking through %1 …</source>
        <translation>正在查看 %1……</translation>
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
        <source>The folder holds more than could be listed: choose the folder of one study.</source>
        <translation>文件夹内容过多，无法全部列出：请选择单个检查的文件夹。</translation>
    </message>
    <message>
        <source>The DICOMDIR is of no use (%1): the files themselves were read.</source>
        <translation>DICOMDIR 无法使用（%1）：已直接读取文件。</translation>
    </message>
    <message>
        <source>Files that the DICOMDIR lists and that are missing: %1.</source>
        <translation>DICOMDIR 列出但缺失的文件：%1。</translation>
    </message>
    <message>
        <source>The DICOMDIR lists %1 series; 1 more file lies beside it.</source>
        <translation>DICOMDIR 列出 %1 个序列；旁边另有 1 个文件。</translation>
    </message>
    <message>
        <source>The DICOMDIR lists %1 series; %2 more files lie beside it.</source>
        <translation>DICOMDIR 列出 %1 个序列；旁边另有 %2 个文件。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::StudyRows</name>
    <message>
        <source>Patient %1 (identity hidden)</source>
        <translation>患者 %1（身份已隐藏）</translation>
    </message>
    <message>
        <source>Without name</source>
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
        <source>Files that the DICOMDIR lists and that are missing: %1.</source>
        <translation>DICOMDIR 列出但缺失的文件：%1。</translation>
    </message>
    <message>
        <source>Not all files were read: which part of the series this is is known then.</source>
        <translation>并非所有文件都已读取：读完后才知道这是序列的哪一部分。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::RecentList</name>
    <message>
        <source>No recent case has this in its name or folder.</source>
        <translation>最近病例的名称或文件夹中没有此内容。</translation>
    </message>
    <message>
        <source>Small pictures</source>
        <translation>小图</translation>
    </message>
    <message>
        <source>Clear the list</source>
        <translation>清空列表</translation>
    </message>
    <message>
        <source>Search recent cases</source>
        <translation>搜索最近病例</translation>
    </message>
    <message>
        <source>Keeps a small picture of each recent case in the program&apos;s cache folder.</source>
        <translation>在程序缓存文件夹中为每个最近病例保留小图。</translation>
    </message>
    <message>
        <source>Forgets these cases and removes their pictures, pinned ones stay; so do the files.</source>
        <translation>忘记这些病例并删除其小图；固定的病例和文件均保留。</translation>
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
        <source>Remove from the list; the file stays</source>
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
        <source>Read them too</source>
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
        <source>Tick the scan with the vessels and the runs, or double-click one.</source>
        <translation>勾选含血管的扫描和造影序列，或双击其中一项。</translation>
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
        <source>Slices or rate</source>
        <translation>层距或帧率</translation>
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
        <source>Written: %1</source>
        <translation>已写入：%1</translation>
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
        <translation>请先打开血管和血管造影。</translation>
    </message>
    <message>
        <source>Something else is under way. Let it end first.</source>
        <translation>其他任务正在进行，请等待其结束。</translation>
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
        <source>Writing the movie …</source>
        <translation>正在写影片……</translation>
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
        <source>the pose of this frame in all of them</source>
        <translation>全部使用当前帧的位姿</translation>
    </message>
    <message>
        <source>each with its followed pose</source>
        <translation>每帧使用其跟踪位姿</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ReportController</name>
    <message>
        <source>There is nothing to report yet. Open vessels and an angiogram first.</source>
        <translation>尚无可报告内容。请先打开血管和造影图像。</translation>
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
        <source>pictures a second</source>
        <translation>张/秒</translation>
    </message>
    <message>
        <source>Residual colours with their scale</source>
        <translation>残差颜色及色标</translation>
    </message>
    <message>
        <source>Patient identity in the pictures</source>
        <translation>图片中包含患者身份</translation>
    </message>
    <message>
        <source>Texts in English</source>
        <translation>文字用英文</translation>
    </message>
    <message>
        <source>Export …</source>
        <translation>导出……</translation>
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
        <source>GIF, for pages; starts again by itself</source>
        <translation>GIF，用于网页；自动循环播放</translation>
    </message>
    <message>
        <source>Every picture says “Not for clinical use”, whose pose it shows, and whether that is trusted.</source>
        <translation>每张图片都注明“不得用于临床”、所示位姿的来源及其是否可信。</translation>
    </message>
    <message>
        <source>The overlay through the run</source>
        <translation>整个序列的叠加图</translation>
    </message>
    <message>
        <source>How the registration converged</source>
        <translation>配准的收敛过程</translation>
    </message>
    <message>
        <source>The vessels alone, turning once</source>
        <translation>仅血管，旋转一周</translation>
    </message>
    <message>
        <source>Movie</source>
        <translation>影片</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
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
        <source>%1 pictures, %2 s, %3 × %4 px</source>
        <translation>%1 张图片，%2 s，%3 × %4 px</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ReportDialog</name>
    <message>
        <source>Built-in one</source>
        <translation>内置模板</translation>
    </message>
    <message>
        <source>Patient identity on the report</source>
        <translation>报告中显示患者身份</translation>
    </message>
    <message>
        <source>Export report</source>
        <translation>导出报告</translation>
    </message>
    <message>
        <source>Reports are passed on. Without identity they name nobody.</source>
        <translation>报告会被转交。不含身份时不会指明任何人。</translation>
    </message>
    <message>
        <source>A template is a page of HTML with your letterhead and logo. Save the built-in one and change the copy: it tells how.</source>
        <translation>模板是带有您的信头和标志的 HTML 页面。保存内置模板并修改副本：其中有说明。</translation>
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
        <source>Choose …</source>
        <translation>选择……</translation>
    </message>
    <message>
        <source>Save a copy …</source>
        <translation>保存副本……</translation>
    </message>
    <message>
        <source>The built-in template, to be changed</source>
        <translation>内置模板，供修改</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Export …</source>
        <translation>导出……</translation>
    </message>
    <message>
        <source>built in</source>
        <translation>内置</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::DicomDialog</name>
    <message>
        <source>Picture of the overlay (Secondary Capture)</source>
        <translation>叠加图的图片（二次捕获）</translation>
    </message>
    <message>
        <source>Pictures of the run (Secondary Capture)</source>
        <translation>序列的图片（二次捕获）</translation>
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
        <source>Patient identity in pictures and report</source>
        <translation>图片和报告中的患者身份</translation>
    </message>
    <message>
        <source>Export …</source>
        <translation>导出……</translation>
    </message>
    <message>
        <source>Export DICOM objects</source>
        <translation>导出 DICOM 对象</translation>
    </message>
    <message>
        <source>A Spatial Registration is a rigid matrix: it cannot hold the perspective camera, which is written beside it as camera.json.</source>
        <translation>空间配准是一个刚性矩阵：它无法保存透视相机，相机以 camera.json 写在旁边。</translation>
    </message>
    <message>
        <source>Every object names the patient in its header, as its image does, whatever its pictures show. Each is a new instance in the study of its image.</source>
        <translation>无论图片显示什么，每个对象都像其图像一样在头信息中注明患者。每个对象都是其图像所属检查中的新实例。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Choose archive …</source>
        <translation>选择归档……</translation>
    </message>
    <message>
        <source>Send to archive</source>
        <translation>发送到归档</translation>
    </message>
    <message>
        <source>A Spatial Registration is a rigid matrix: it cannot hold the perspective camera, which stands in its private elements. The file camera.json is not sent.</source>
        <translation>Spatial Registration 是刚性矩阵，无法包含透视相机，后者存放在其私有元素中。文件 camera.json 不会发送。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::DicomController</name>
    <message>
        <source>There is nothing to export yet. Open a vessel tree and an angiogram first.</source>
        <translation>尚无可导出的内容。请先打开血管树和血管造影。</translation>
    </message>
    <message>
        <source>Folder for the DICOM objects</source>
        <translation>DICOM 对象的文件夹</translation>
    </message>
    <message>
        <source>There is nothing to send yet. Open a vessel tree and an angiogram first.</source>
        <translation>尚无可发送的内容。请先打开血管树和造影。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PackController</name>
    <message>
        <source>There is nothing to pack yet. Open a vessel tree and an angiogram first.</source>
        <translation>尚无可打包的内容。请先打开血管树和造影图像。</translation>
    </message>
    <message>
        <source>Pack case for others</source>
        <translation>打包病例给他人</translation>
    </message>
    <message>
        <source>Archives (*.zip)</source>
        <translation>归档 (*.zip)</translation>
    </message>
    <message>
        <source>A case is being packed already. Let that end, or stop it.</source>
        <translation>已在打包一个病例。请等待其结束，或将其停止。</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>Packing …</source>
        <translation>正在打包……</translation>
    </message>
    <message>
        <source>Packing: %1 %</source>
        <translation>正在打包：%1 %</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::PackDialog</name>
    <message>
        <source>Without identity</source>
        <translation>去除身份</translation>
    </message>
    <message>
        <source>Dates shifted instead of removed</source>
        <translation>日期平移而非删除</translation>
    </message>
    <message>
        <source>Black out letters in the pictures</source>
        <translation>涂黑图像中的文字</translation>
    </message>
    <message>
        <source>Pack case for others</source>
        <translation>打包病例给他人</translation>
    </message>
    <message>
        <source>made up</source>
        <translation>自动生成</translation>
    </message>
    <message>
        <source>Name instead</source>
        <translation>替代姓名</translation>
    </message>
    <message>
        <source>One archive with the case, its inputs and its results. Without identity: no names, IDs, dates, private elements and notes; UIDs are replaced. Names of branches stay. Look at every picture before you hand it on.</source>
        <translation>一个归档，包含病例、其输入和结果。去除身份：不含姓名、编号、日期、私有元素和备注；UID 被替换。分支名称保留。交出之前请查看每幅图像。</translation>
    </message>
    <message>
        <source>Pack …</source>
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
        <source>The cache is empty. Objects dropped: %1.</source>
        <translation>缓存已清空。已删除对象：%1。</translation>
    </message>
    <message>
        <source>Keep less than is there?</source>
        <translation>保留的比现有的更少？</translation>
    </message>
    <message>
        <source>The cache holds %1. What was not used for the longest time is dropped until %2 are left.</source>
        <translation>缓存现有 %1。将删除最久未用的内容，直到剩余 %2。</translation>
    </message>
    <message>
        <source>Drop</source>
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
        <source>All that was retrieved is dropped. Cases whose images lie there ask for them when they are opened; “Pack case for others” keeps case and images together.</source>
        <translation>所有获取的内容都将删除。图像存放于此的病例在打开时会询问图像位置；“打包病例给他人”可将病例与图像保存在一起。</translation>
    </message>
    <message>
        <source>Empty</source>
        <translation>清空</translation>
    </message>
    <message>
        <source>Emptying the cache …</source>
        <translation>正在清空缓存……</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveController</name>
    <message>
        <source>what arrived on port %1</source>
        <translation>端口 %1 收到的内容</translation>
    </message>
    <message>
        <source>Objects that arrived: %1</source>
        <translation>已收到对象：%1</translation>
    </message>
    <message>
        <source>Nothing arrived yet</source>
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
        <source>Asking %1 …</source>
        <translation>正在询问 %1……</translation>
    </message>
    <message>
        <source>%1 answers, and lets this program in.</source>
        <translation>%1 有应答，并允许本程序访问。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveFinder</name>
    <message>
        <source>Stopped.</source>
        <translation>已停止。</translation>
    </message>
    <message>
        <source>Search, choose studies or series, then retrieve them.</source>
        <translation>先搜索，选择检查或序列，然后获取。</translation>
    </message>
    <message>
        <source>“%1” is no date. Write year, month and day: 2024-01-31.</source>
        <translation>“%1”不是日期。请写年、月、日：2024-01-31。</translation>
    </message>
    <message>
        <source>Searching in %1 …</source>
        <translation>正在 %1 中搜索……</translation>
    </message>
    <message>
        <source>%1 holds no such study. Ask for less: a shorter name, more days, any modality.</source>
        <translation>%1 中没有这样的检查。请放宽条件：更短的姓名、更多天数、任意模态。</translation>
    </message>
    <message>
        <source>Search to see what %1 holds.</source>
        <translation>请搜索以查看 %1 中的内容。</translation>
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
        <source>Choose studies, or unfold one for its series; several with Ctrl.</source>
        <translation>请选择检查，或展开检查以选择序列；按 Ctrl 可多选。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveNodes</name>
    <message>
        <source>There is an archive of this name already. Choose another name.</source>
        <translation>已有同名的归档。请换一个名称。</translation>
    </message>
    <message>
        <source>Remove %1 from the list?</source>
        <translation>从列表中移除 %1？</translation>
    </message>
    <message>
        <source>The archive itself and what was retrieved from it stay.</source>
        <translation>归档本身及已从中获取的内容都会保留。</translation>
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
        <source>Asking %1 …</source>
        <translation>正在询问 %1……</translation>
    </message>
    <message>
        <source>Stopping …</source>
        <translation>正在停止……</translation>
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
        <source>%1 of %2 objects are here.</source>
        <translation>%2 个对象中已有 %1 个在本机。</translation>
    </message>
    <message>
        <source>Retrieve again to get the others.</source>
        <translation>再次获取即可取回其余的。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveSender</name>
    <message>
        <source>Stopping …</source>
        <translation>正在停止……</translation>
    </message>
    <message>
        <source>Making the objects …</source>
        <translation>正在生成对象……</translation>
    </message>
    <message>
        <source>Sent: %1 of %2 objects, %3</source>
        <translation>已发送：%1 / %2 个对象，%3</translation>
    </message>
    <message>
        <source>%1 has all objects: %2 (%3).</source>
        <translation>%1 已有全部对象：%2（%3）。</translation>
    </message>
    <message>
        <source>%1 of %2 objects arrived.</source>
        <translation>%2 个对象中已到达 %1 个。</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>已停止。</translation>
    </message>
    <message>
        <source>Send again for the others.</source>
        <translation>再次发送即可发送其余的。</translation>
    </message>
    <message>
        <source>Stopped. Nothing was sent.</source>
        <translation>已停止。未发送任何内容。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::ArchiveWords</name>
    <message>
        <source>Without name</source>
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
        <source>Faults beside this one: %1.</source>
        <translation>除此之外的错误：%1。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::ArchiveDialog</name>
    <message>
        <source>Open what came</source>
        <translation>打开已到达的内容</translation>
    </message>
    <message>
        <source>Retrieve</source>
        <translation>获取</translation>
    </message>
    <message>
        <source>Open from archive</source>
        <translation>从归档打开</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Choose from the objects that arrived</source>
        <translation>从已到达的对象中选择</translation>
    </message>
    <message>
        <source>Bring the chosen studies and series here, then choose which are vessels and which views</source>
        <translation>取回所选检查和序列，然后选择哪些是血管、哪些是视图</translation>
    </message>
    <message>
        <source>No archive is known yet. Add one: who runs it tells you host, port and AE title.</source>
        <translation>尚无已知的归档。请添加一个：管理者会告知主机、端口和 AE 标题。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::CacheLine</name>
    <message>
        <source>Empty …</source>
        <translation>清空……</translation>
    </message>
    <message>
        <source>Most that the cache keeps</source>
        <translation>缓存最多保留的大小</translation>
    </message>
    <message>
        <source>What was not used for the longest time is dropped first</source>
        <translation>最久未用的先被删除</translation>
    </message>
    <message>
        <source>Drop all that was retrieved</source>
        <translation>删除所有获取的内容</translation>
    </message>
    <message>
        <source>of at most</source>
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
        <source>Studies and series in the archive</source>
        <translation>归档中的检查和序列</translation>
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
        <source>Looking …</source>
        <translation>正在查找……</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::NodeBar</name>
    <message>
        <source>Test connection</source>
        <translation>测试连接</translation>
    </message>
    <message>
        <source>Add …</source>
        <translation>添加……</translation>
    </message>
    <message>
        <source>Edit …</source>
        <translation>编辑……</translation>
    </message>
    <message>
        <source>Remove …</source>
        <translation>移除……</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>归档</translation>
    </message>
    <message>
        <source>No archive yet</source>
        <translation>尚无归档</translation>
    </message>
    <message>
        <source>Ask whether the archive answers and lets us in</source>
        <translation>询问归档是否应答并允许访问</translation>
    </message>
    <message>
        <source>Add an archive to the list; the command line uses the same list</source>
        <translation>将归档添加到列表；命令行使用同一列表</translation>
    </message>
    <message>
        <source>Host, port, titles, security</source>
        <translation>主机、端口、标题、安全</translation>
    </message>
    <message>
        <source>Take the archive from the list</source>
        <translation>将归档从列表中移除</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::NodeDialog</name>
    <message>
        <source>File with the authorization</source>
        <translation>授权文件</translation>
    </message>
    <message>
        <source>Encrypted (TLS)</source>
        <translation>加密（TLS）</translation>
    </message>
    <message>
        <source>Certificates of authorities (PEM)</source>
        <translation>颁发机构证书（PEM）</translation>
    </message>
    <message>
        <source>Our certificate (PEM)</source>
        <translation>我方证书（PEM）</translation>
    </message>
    <message>
        <source>Key of our certificate (PEM)</source>
        <translation>我方证书的密钥（PEM）</translation>
    </message>
    <message>
        <source>Its certificate must be one of the host</source>
        <translation>其证书必须属于该主机</translation>
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
        <source>Add archive</source>
        <translation>添加归档</translation>
    </message>
    <message>
        <source>Edit archive</source>
        <translation>编辑归档</translation>
    </message>
    <message>
        <source>Ask who runs the archive for these, and have our AE title entered there.</source>
        <translation>请向归档管理者询问这些信息，并让其登记我方的 AE 标题。</translation>
    </message>
    <message>
        <source>PACS of radiology</source>
        <translation>放射科 PACS</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>What you call it</source>
        <translation>您对它的称呼</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>主机</translation>
    </message>
    <message>
        <source>Name or address of its computer; empty where it is asked by DICOMweb only</source>
        <translation>其计算机的名称或地址；仅用 DICOMweb 时留空</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>端口</translation>
    </message>
    <message>
        <source>104 or 11112 as a rule</source>
        <translation>通常为 104 或 11112</translation>
    </message>
    <message>
        <source>Its AE title</source>
        <translation>其 AE 标题</translation>
    </message>
    <message>
        <source>By which the archive wants to be called</source>
        <translation>访问归档时使用的标题</translation>
    </message>
    <message>
        <source>Our AE title</source>
        <translation>我方 AE 标题</translation>
    </message>
    <message>
        <source>By which the archive knows this program</source>
        <translation>归档识别本程序所用的标题</translation>
    </message>
    <message>
        <source>Authorities</source>
        <translation>颁发机构</translation>
    </message>
    <message>
        <source>PEM file; empty: those that the system trusts</source>
        <translation>PEM 文件；留空：系统信任的机构</translation>
    </message>
    <message>
        <source>Our certificate</source>
        <translation>我方证书</translation>
    </message>
    <message>
        <source>PEM file; empty: none</source>
        <translation>PEM 文件；留空：无</translation>
    </message>
    <message>
        <source>Its key</source>
        <translation>其密钥</translation>
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
        <source>Used where no host is given</source>
        <translation>未填写主机时使用</translation>
    </message>
    <message>
        <source>Authorization</source>
        <translation>授权</translation>
    </message>
    <message>
        <source>File whose first line is sent as the header Authorization; only its path is stored</source>
        <translation>其首行作为 Authorization 头发送的文件；仅保存其路径</translation>
    </message>
    <message>
        <source>Port for C-MOVE</source>
        <translation>C-MOVE 端口</translation>
    </message>
    <message>
        <source>Only where the archive does not offer C-GET: it sends to this port of ours. 0: not used</source>
        <translation>仅当归档不提供 C-GET 时：它发送到我方此端口。0：不使用</translation>
    </message>
    <message>
        <source>Time for an answer</source>
        <translation>应答时限</translation>
    </message>
    <message>
        <source>Afterwards the archive counts as dead</source>
        <translation>超过后视为归档无响应</translation>
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
        <source>Look at them</source>
        <translation>查看</translation>
    </message>
    <message>
        <source>Take what modalities and archives push to this computer, until switched off or the window closes</source>
        <translation>接收设备和归档推送到本机的内容，直到关闭此开关或窗口</translation>
    </message>
    <message>
        <source>Port to receive on</source>
        <translation>接收端口</translation>
    </message>
    <message>
        <source>AE title to receive as</source>
        <translation>接收用 AE 标题</translation>
    </message>
    <message>
        <source>Callers must use this AE title</source>
        <translation>呼叫方必须使用此 AE 标题</translation>
    </message>
    <message>
        <source>Choose from what came</source>
        <translation>从收到的内容中选择</translation>
    </message>
    <message>
        <source>as AE title</source>
        <translation>AE 标题</translation>
    </message>
    <message>
        <source>Security …</source>
        <translation>安全……</translation>
    </message>
    <message>
        <source>Who may call this port, and encryption (TLS)</source>
        <translation>谁可呼叫此端口，以及加密（TLS）</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SearchFields</name>
    <message>
        <source>Meier, or *mei*</source>
        <translation>Meier 或 *mei*</translation>
    </message>
    <message>
        <source>Beginning of the name; * and ? stand for any letters</source>
        <translation>姓名开头；* 和 ? 代表任意字符</translation>
    </message>
    <message>
        <source>The patient&apos;s ID; * and ? stand for any letters</source>
        <translation>患者 ID；* 和 ? 代表任意字符</translation>
    </message>
    <message>
        <source>2024-01-31</source>
        <translation>2024-01-31</translation>
    </message>
    <message>
        <source>Studies of this day and later; empty: from the beginning</source>
        <translation>该日及以后的检查；留空：从最早开始</translation>
    </message>
    <message>
        <source>Studies of this day and earlier; empty: until today</source>
        <translation>该日及以前的检查；留空：直到今天</translation>
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
        <translation>XA：造影，CT：扫描</translation>
    </message>
    <message>
        <source>List the studies of the archive to which all of this applies</source>
        <translation>列出归档中符合全部条件的检查</translation>
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
        <source>Send to archive</source>
        <translation>发送到归档</translation>
    </message>
    <message>
        <source>The objects are made once. Sending them again after a fault sends the same ones, so that none is in the archive twice.</source>
        <translation>对象只生成一次。出错后再次发送的是同样的对象，因此归档中不会重复。</translation>
    </message>
    <message>
        <source>No archive is known yet. Add one: who runs it tells you host, port and AE title.</source>
        <translation>尚无已知的归档。请添加一个：管理者会告知主机、端口和 AE 标题。</translation>
    </message>
    <message>
        <source>The objects go to %1 when you send them.</source>
        <translation>发送后，对象将传至 %1。</translation>
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
        <source>End it; what is whole is kept</source>
        <translation>结束；完整的部分予以保留</translation>
    </message>
</context>
<context>
    <name>angiopose::app::DeidentifyController</name>
    <message>
        <source>Taking identity out: %1 %</source>
        <translation>正在去标识：%1 %</translation>
    </message>
    <message>
        <source>Files are being written already. Let that end, or stop it.</source>
        <translation>已在写入文件。请等待其结束，或将其停止。</translation>
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
        <source>Folder to write to</source>
        <translation>写入的文件夹</translation>
    </message>
    <message>
        <source>Taking identity out …</source>
        <translation>正在去标识……</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>Written without identity: %1, in %2.</source>
        <translation>已去标识写入：%1 个，位于 %2。</translation>
    </message>
    <message>
        <source>%1 files were written without identity, %2 were not, for the reasons below. What was written lies in %3.</source>
        <translation>%1 个文件已去标识写入，%2 个未写入，原因如下。写入的内容位于 %3。</translation>
    </message>
</context>
<context>
    <name>angiopose::app::PrivacyController</name>
    <message>
        <source>No list and no pictures of recent cases, no names in the title, no folders remembered.</source>
        <translation>不保留最近病例的列表和图片，标题中不显示姓名，不记住文件夹。</translation>
    </message>
    <message>
        <source>Turn private mode on?</source>
        <translation>开启隐私模式？</translation>
    </message>
    <message>
        <source>The list of recent cases, pinned ones too, their pictures and the folders and names remembered so far are forgotten for good. Nothing of the kind is kept until private mode is turned off. Automatic copies of unsaved work are still made, and removed when a case is closed.</source>
        <translation>最近病例列表（包括固定的病例）、其图片以及迄今记住的文件夹和姓名将被永久清除。在关闭隐私模式之前，不会保留任何此类内容。未保存工作的自动副本仍会生成，并在关闭病例时删除。</translation>
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
        <source>One line for everything that is opened, saved and exported: when, by whom, with the SHA-256 of the files.</source>
        <translation>为每次打开、保存和导出写一行：时间、用户以及文件的 SHA-256。</translation>
    </message>
    <message>
        <source>Written to %1</source>
        <translation>写入 %1</translation>
    </message>
    <message>
        <source>Keep an audit file</source>
        <translation>保留审计文件</translation>
    </message>
    <message>
        <source>Audit files (*.jsonl)</source>
        <translation>审计文件 (*.jsonl)</translation>
    </message>
</context>
<context>
    <name>angiopose::app::SupportController</name>
    <message>
        <source>Save support bundle</source>
        <translation>保存支持包</translation>
    </message>
    <message>
        <source>Archives (*.zip)</source>
        <translation>压缩包 (*.zip)</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::FaultBar</name>
    <message>
        <source>Save support bundle …</source>
        <translation>保存支持包……</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>忽略</translation>
    </message>
    <message>
        <source>AngioPose ended by a fault last time. A note of where in the program, with nothing of the case in it, lies in %1.</source>
        <translation>AngioPose 上次因故障而结束。故障在程序中的位置记录在 %1 中，不含病例内容。</translation>
    </message>
</context>
<context>
    <name>angiopose::ui::SupportDialog</name>
    <message>
        <source>Save support bundle</source>
        <translation>保存支持包</translation>
    </message>
    <message>
        <source>These texts go into the archive, and nothing else: no image, no vessels. Names, numbers, dates and paths that are known of the cases of this session and of this computer were taken out. Read them before you hand them on.</source>
        <translation>压缩包中只包含这些文本：没有图像，没有血管。本次会话的病例和本计算机的已知姓名、编号、日期和路径均已去除。请在转交之前阅读。</translation>
    </message>
    <message>
        <source>Texts of the bundle</source>
        <translation>支持包中的文本</translation>
    </message>
    <message>
        <source>The text as it is written</source>
        <translation>将写入的文本</translation>
    </message>
    <message>
        <source>Save …</source>
        <translation>保存……</translation>
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
        <source>Dates shifted instead of removed</source>
        <translation>日期平移而非删除</translation>
    </message>
    <message>
        <source>Black out letters in the pictures</source>
        <translation>涂黑图像中的文字</translation>
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
        <source>DICOM images and objects, PNG, JPEG and TIFF are written anew without names, IDs, dates, private elements and texts; UIDs are replaced. Other files are refused, and which is said. Look at every picture before you hand it on.</source>
        <translation>DICOM 图像和对象、PNG、JPEG 和 TIFF 将重新写入，不含姓名、编号、日期、私有元素和文本；UID 会被替换。其他文件会被拒绝并列出。请在转交之前查看每一幅图像。</translation>
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
        <source>Add files …</source>
        <translation>添加文件……</translation>
    </message>
    <message>
        <source>Add folder …</source>
        <translation>添加文件夹……</translation>
    </message>
    <message>
        <source>made up</source>
        <translation>自动生成</translation>
    </message>
    <message>
        <source>a new or empty folder</source>
        <translation>新的或空的文件夹</translation>
    </message>
    <message>
        <source>Folder to write to</source>
        <translation>写入的文件夹</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>选择……</translation>
    </message>
    <message>
        <source>Name instead</source>
        <translation>替代姓名</translation>
    </message>
    <message>
        <source>Write to</source>
        <translation>写入到</translation>
    </message>
</context>
</TS>
