#!/usr/bin/python3
"""Runs every example of the manual's tutorial, of the README and of `--help`, as a reader would type it.

Usage: run_examples.py PROGRAM ROOT
PROGRAM is angiopose-cli, ROOT the project. Inputs that the examples name are made first, from a simulated case. Of an
experiment one trial is run, of capture-range one bin. What needs an archive that answers is listed and left to archive_test.
"""
import gzip
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

patience_s = 120
done_codes = {0, 4}   # 4: done, not trustworthy


def blocks(text):
    return re.findall(r"```sh\n(.*?)```", text, re.S)


def without_remark(line):
    """A line as it is typed: no comment, no words in brackets after it."""
    return re.split(r"\s{2,}[#(]|\s#\s", line)[0].strip()


def readme_examples(root):
    pages = [root / "README.md", root / "resources/manual/examples.md"]
    lines = [line for page in pages for block in blocks(page.read_text()) for line in block.splitlines()]
    return [("README", without_remark(line)) for line in lines if re.match(r"(\S*/)?angiopose-cli\s", line)]


def help_of(program, *words):
    return subprocess.run([program, *words, "--help"], capture_output=True, text=True, check=True).stdout


def help_examples(program):
    """Lines of the footers that begin with the program's name."""
    names = re.findall(r"^  ([a-z-]+)  ", help_of(program).split("Subcommands:")[1], re.M)
    found = []
    for name in names:
        footer = help_of(program, name)
        inner = re.findall(r"^  ([a-z-]+)  ", footer.split("Subcommands:")[1], re.M) if "Subcommands:" in footer else []
        for words in [(name,), *[(name, sub) for sub in inner]]:
            for line in help_of(program, *words).splitlines():
                match = re.search(r"(?:Examples?:|^\s{6,})\s*(angiopose-cli .*)", line)
                if match:
                    found.append((" ".join(words) + " --help", without_remark(match.group(1))))
    return found


def write_dicom_series(volume_path, folder):
    """The slices of a NIfTI scan (axes along the patient's) as CT images of one series."""
    import pydicom
    from pydicom.dataset import FileDataset, FileMetaDataset
    raw = gzip.decompress(volume_path.read_bytes())
    size = np.frombuffer(raw[40:56], "<i2")[1:4]
    spacing = np.frombuffer(raw[76:108], "<f4")[1:4]
    kind = {4: "<i2", 16: "<f4"}[int(np.frombuffer(raw[70:72], "<i2")[0])]
    offset = int(np.frombuffer(raw[108:112], "<f4")[0])
    rows = np.frombuffer(raw[280:328], "<f4").reshape(3, 4)
    voxels = np.frombuffer(raw[offset:], kind, int(np.prod(size))).reshape(size[::-1]).astype("<i2")
    lps = np.diag([-1.0, -1.0, 1.0])
    across, down = lps @ rows[:, 0] / spacing[0], lps @ rows[:, 1] / spacing[1]
    series, study = pydicom.uid.generate_uid(), pydicom.uid.generate_uid()
    folder.mkdir()
    for k in range(0, size[2], 2):
        meta = FileMetaDataset()
        meta.TransferSyntaxUID = pydicom.uid.ExplicitVRLittleEndian
        meta.MediaStorageSOPClassUID = "1.2.840.10008.5.1.4.1.1.2"
        meta.MediaStorageSOPInstanceUID = pydicom.uid.generate_uid()
        image = FileDataset("", {}, file_meta=meta, preamble=b"\0" * 128)
        image.is_little_endian, image.is_implicit_VR = True, False
        image.SOPClassUID, image.SOPInstanceUID = meta.MediaStorageSOPClassUID, meta.MediaStorageSOPInstanceUID
        image.StudyInstanceUID, image.SeriesInstanceUID = study, series
        image.Modality, image.PatientName, image.PatientID = "CT", "Simulated", "SIM-7"
        image.Rows, image.Columns = int(size[1]), int(size[0])
        image.PixelSpacing = [float(spacing[1]), float(spacing[0])]
        image.ImageOrientationPatient = [*map(float, across), *map(float, down)]
        image.ImagePositionPatient = [*map(float, lps @ (rows @ np.array([0, 0, k, 1.0])))]
        image.SliceThickness, image.InstanceNumber = float(2 * spacing[2]), k + 1
        image.SamplesPerPixel, image.PhotometricInterpretation = 1, "MONOCHROME2"
        image.BitsAllocated, image.BitsStored, image.HighBit, image.PixelRepresentation = 16, 16, 15, 1
        image.RescaleSlope, image.RescaleIntercept = 1, 0
        image.PixelData = voxels[k].tobytes()
        image.save_as(folder / f"{k:04}.dcm", write_like_original=False)


def write_trials(path):
    """The log of two observers who read three images each."""
    names = ["r00", "r01", "r02", "t0", "r10", "r11", "r12", "t1", "r20", "r21", "r22", "t2"]
    header = ("started_at,observer,case,image_sha256,frame,seed,range_mm,range_deg,duration_s,edits,outcome,"
              "in_plane_from_centre_mm,depth_from_centre_mm,rotation_from_centre_deg")
    for prefix in ("start", "final", "centre"):
        header += "".join(f",{prefix}_{name}" for name in names)
    rows = [header + ",pivot_x,pivot_y,pivot_z"]
    for image in range(3):
        for k, observer in enumerate(("Ada", "Bob")):
            pose = ["1,0,0,{},0,1,0,0,0,0,1,700".format(shift) for shift in (0, 0.5 * k + 0.1 * image, 0)]
            rows.append(f"2026-01-01T10:00:00Z,{observer},case,{image},0,1,10,10,30,5,done,0,0,0,"
                        + ",".join(pose) + ",0,0,0")
    path.write_text("\n".join(rows) + "\n")


def prepare(program, folder):
    """Everything that examples name."""
    def run(*words):
        subprocess.run([program, *words], cwd=folder, check=True, capture_output=True, timeout=patience_s)
    run("simulate", "--seed", "7", "--branches", "9", "--scan", "--output", ".")
    run("trace-vessel", "scan.nii.gz", "--output", "traced.vtp", "--mask", "mask.nii.gz")
    shutil.copy(folder / "angiogram.dcm", folder / "run.dcm")
    shutil.copy(folder / "angiogram.dcm", folder / "raw.dcm")
    for name in ("a.angiopose", "b.angiopose"):
        shutil.copy(folder / "case.angiopose", folder / name)
    write_dicom_series(folder / "scan.nii.gz", folder / "cta")
    shutil.copytree(folder / "cta", folder / "ct-folder")
    shutil.copytree(folder / "cta", folder / "cdrom")
    write_trials(folder / "trials.csv")
    (folder / "study.json").write_text(
        '{"format": "angiopose-study", "version": 1, "casesPerSetting": 2, "trees": [{"grown": 2, "branches": 6}],'
        ' "settings": [{"name": "rigid", "frames": 1}, {"name": "bent", "frames": 1, "deformationMm": 2}]}')
    (folder / "cases.csv").write_text("case,reference\ncase.angiopose,true-pose.json\n")
    run("register", "case.angiopose", "--output", "result")
    run("evaluate", "toy", "--shard", "1/2", "--trials", "2", "--output", "a")
    run("evaluate", "toy", "--shard", "2/2", "--trials", "2", "--output", "b")


def as_run_here(example):
    """The example with small numbers of trials, and with a folder here for the disc."""
    line = re.sub(r"^\S*angiopose-cli", "angiopose-cli", example).replace("/media/cdrom", "cdrom")
    is_experiment = re.match(r"angiopose-cli evaluate (?!own|observers)", line) and "--merge" not in line
    if is_experiment:
        line = re.sub(r"\s--trials \d+", "", line) + " --trials 1"
        line += " --condition clean-0-1" if "capture-range" in line else ""
    return line


def run_line(line, folder, environment):
    begin = time.monotonic()
    done = subprocess.run(["bash", "-c", line], cwd=folder, env=environment, capture_output=True, text=True,
                          timeout=patience_s)
    print(f"{time.monotonic() - begin:6.1f} s  {line}", flush=True)
    return None if done.returncode in done_codes else f"{line}\n  ended with {done.returncode}: {done.stderr.strip()}"


def run_tutorial(root, folder, environment):
    """The boxes one after the other, as one script: a reader types them into one shell."""
    script = "".join(blocks((root / "resources/manual/tutorial.md").read_text()))
    done = subprocess.run(["bash", "-ec", script], cwd=folder, env=environment, capture_output=True, text=True,
                          timeout=patience_s)
    print(f"tutorial: {len(re.findall('^angiopose-cli', script, re.M))} commands", flush=True)
    return [] if done.returncode == 0 else [f"tutorial ended with {done.returncode}: {done.stderr.strip()[-2000:]}"]


def main(program, root):
    examples = list(dict.fromkeys((as_run_here(line)) for _, line in readme_examples(root) + help_examples(program)))
    asks_archive = [line for line in examples if line.startswith("angiopose-cli archive")]
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        environment = {**os.environ, "HOME": place, "PATH": f"{Path(program).parent}:{os.environ['PATH']}"}
        (folder / "tutorial").mkdir()
        failures = run_tutorial(root, folder / "tutorial", environment)
        prepare(program, folder)
        for line in examples:
            if line not in asks_archive:
                failures.append(run_line(line, folder, environment))
    failures = [failure for failure in failures if failure]
    print(f"{len(examples) - len(asks_archive)} examples run, {len(asks_archive)} need an archive (archive_test), "
          f"{len(failures)} failed")
    for failure in failures:
        print("FAILED " + failure)
    return 1 if failures or len(examples) < 40 else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(str(Path(sys.argv[1]).resolve()), Path(sys.argv[2]).resolve()))
