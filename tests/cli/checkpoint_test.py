# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""Renders that are killed, run out of space or time, and are resumed."""

import fcntl
import os
import random
import resource
import shutil
import signal
import time

import support

# Takes seconds, and is written several times a second.
PASSES = 700
SLOW = ("render", "scene.obj", "-c", "my.cam:above", "--size", "200x150", "-s", str(PASSES),
        "--integrator", "preview", "-q")
# scripts/nightly kills 500 times.
KILLS = 8
OFTEN = ("--checkpoint-every", "0.05s")


class ResumedTest(support.CommandTest):
    WHOLE = {}

    def whole(self, *words, ending="exr"):
        """What these words render without an interruption; once for all tests."""
        if (words, ending) not in self.WHOLE:
            self.run_command(*words, "-o", f"whole.{ending}")
            self.WHOLE[words, ending] = (self.folder / f"whole.{ending}").read_bytes()
        return self.WHOLE[words, ending]


class Checkpoint(ResumedTest):
    def picture(self, *words):
        self.run_command(*words)
        return (self.folder / words[-1]).read_bytes()

    def wait_for(self, process, name):
        """Until the render has written a file."""
        while not (self.folder / name).exists():
            self.assertIsNone(process.poll(), "it ended early")
            time.sleep(0.002)

    def interrupted(self, *words):
        """Kills a render that has written a checkpoint."""
        process = self.start(*words)
        checkpoint = self.folder / (words[-1] + ".checkpoint")
        self.wait_for(process, checkpoint.name)
        process.kill()
        process.communicate()
        return checkpoint

    def test_killed_at_random_times_it_gives_the_same_picture(self):
        dice = random.Random(1)
        for ending in ("png", "exr"):
            whole = self.whole(*SLOW, ending=ending)
            kills = 0
            while kills < KILLS:
                process = self.start(*SLOW, *OFTEN, "--resume", "-o", f"p.{ending}")
                time.sleep(dice.uniform(0.02, 0.4))
                if process.poll() is not None:
                    process.communicate()
                    (self.folder / f"p.{ending}").unlink()
                    continue
                process.kill()
                process.communicate()
                kills += 1
                # Killed behind its end, it has left the picture, and nothing to resume.
                picture = self.folder / f"p.{ending}"
                if picture.exists() and not picture.with_name(f"{picture.name}.checkpoint").exists():
                    self.assertEqual(picture.read_bytes(), whole)
                    picture.unlink()
            facts = self.json_of(*SLOW, *OFTEN, "--resume", "-o", f"p.{ending}")
            self.assertEqual((self.folder / f"p.{ending}").read_bytes(), whole)
            self.assertEqual(facts["passes"], PASSES)
            self.assertEqual([name for name in self.files() if "checkpoint" in name], [])

    def test_goes_on_where_it_was(self):
        self.interrupted(*SLOW, *OFTEN, "-o", "p.exr")
        facts = self.json_of(*SLOW, "--resume", "-o", "p.exr")
        self.assertLess(facts["rays"], PASSES * 200 * 150)

    def test_a_region_is_resumed(self):
        region = ("--crop", "120x90+30+20")
        whole = self.whole(*SLOW, *region)
        self.interrupted(*SLOW, *region, *OFTEN, "-o", "p.exr")
        self.assertEqual(self.picture(*SLOW, *region, "--resume", "-o", "p.exr"), whole)

    def test_layers_of_some_objects_are_resumed(self):
        text = (self.folder / "my.cam").read_text() + """
picture parts {
    layer above { hide objects("*") }
    layer above { show objects("*")  blend by depth }
}
"""
        (self.folder / "my.cam").write_text(text)
        # Layers by depth take many times as long.
        other = {"my.cam:above": "my.cam:parts", str(PASSES): str(PASSES // 10)}
        words = [other.get(word, word) for word in SLOW]
        whole = self.whole(*words)
        self.interrupted(*words, *OFTEN, "-o", "p.exr")
        self.assertEqual(self.picture(*words, "--resume", "-o", "p.exr"), whole)

    def test_a_stopped_render_keeps_its_checkpoint(self):
        process = self.start(*SLOW[:-1], *OFTEN, "-o", "p.exr")
        while process.poll() is None and not (self.folder / "p.exr.checkpoint").exists():
            time.sleep(0.01)
        process.terminate()
        out, _ = process.communicate()
        self.assertEqual(process.returncode, 130)
        self.assertIn("--resume continues from p.exr.checkpoint", out.decode())
        self.assertEqual(self.picture(*SLOW, "--resume", "-o", "p.exr"),
                         self.whole(*SLOW))

    def test_one_that_is_stopped_early_has_a_checkpoint_too(self):
        process = self.start(*SLOW[:-1], "--save-every", "0.05s", "-o", "p.exr")
        self.wait_for(process, "p.exr")
        process.terminate()
        out, _ = process.communicate()
        self.assertEqual(process.returncode, 130)
        self.assertIn("--resume continues from p.exr.checkpoint", out.decode())
        facts = self.json_of(*SLOW, "--resume", "-o", "p.exr")
        self.assertLess(facts["rays"], PASSES * 200 * 150)
        self.assertEqual(facts["passes"], PASSES)
        self.assertNotIn("p.exr.checkpoint", self.files())

    def test_without_intervals_there_is_none(self):
        process = self.start(*SLOW, "--checkpoint-every", "off", "--save-every", "0.05s", "-o",
                             "p.exr")
        self.wait_for(process, "p.exr")
        process.terminate()
        process.communicate()
        self.assertEqual(process.returncode, 130)
        self.assertNotIn("p.exr.checkpoint", self.files())

    def test_a_picture_that_is_begun_anew_is_told_of(self):
        short = ("render", "scene.obj", "--size", "20", "-o", "p.exr")
        _, err = self.run_command(*short, "--resume")
        self.assertEqual(err, "")
        _, err = self.run_command(*short, "--resume")
        self.assertIn("there is no 'p.exr.checkpoint', so the render begins anew and replaces "
                      "'p.exr'", err)

    def test_a_killed_short_render_has_none(self):
        process = self.start(*SLOW, "-o", "p.exr", "-s", "100000")
        time.sleep(0.3)
        self.assertIsNone(process.poll(), "it ended early")
        process.kill()
        process.communicate()
        self.assertNotIn("p.exr.checkpoint", self.files())
        self.run_command(*SLOW, "--resume", "-o", "p.exr")

    def test_one_that_is_left_is_told_of(self):
        self.interrupted(*SLOW, *OFTEN, "-o", "p.exr")
        _, err = self.run_command("render", "scene.obj", "--size", "20", "-o", "p.exr")
        self.assertIn("'p.exr.checkpoint' is left from an interrupted render", err)
        self.assertIn("--resume", err)
        self.assertNotIn("p.exr.checkpoint", self.files())

    def test_another_render_is_refused(self):
        checkpoint = self.interrupted(*SLOW, *OFTEN, "-o", "p.exr")
        kept = checkpoint.read_bytes()
        for words, says in (
                (("--seed", "3"), "--seed was '0' and is '3'"),
                (("--filter", "box"), "--filter was 'blackman-harris' and is 'box'"),
                (("--set", "size=2"), "--set was '' and is 'size=2'"),
                (("--crop", "50x50+0+0"), "--crop was '' and is '50x50+0+0'"),
                (("-s", "900"), f"--samples was '{PASSES}' and is '900'")):
            self.refused(*SLOW, *words, "--resume", "-o", "p.exr", code=1, says=says,
                         helps="render without --resume")
        (self.folder / "my.cam").write_text(support.CAMERAS + "\n")
        self.refused(*SLOW, "--resume", "-o", "p.exr", code=1,
                     says="the file 'my.cam' has changed")
        (self.folder / "my.cam").write_text(support.CAMERAS)
        (self.folder / "scene.obj").write_text(support.OBJ.replace("2 1 -1", "2 1 -2"))
        self.refused(*SLOW, "--resume", "-o", "p.exr", code=1,
                     says="the file 'scene.obj' has changed")
        self.assertEqual(checkpoint.read_bytes(), kept)

    def test_what_the_sums_do_not_depend_on_may_differ(self):
        # Together: a refusal would name the one that matters.
        words = ("--no-dither", "--texture-memory", "64", "--fps", "30", "--exposure", "1",
                 "--view-transform", "filmic", "--layers", "none", "--denoiser", "features",
                 "--film-memory", "4GiB")
        self.interrupted(*SLOW, *OFTEN, "-o", "p.png")
        resumed = self.picture(*SLOW, *words, "--resume", "-o", "p.png")
        self.assertEqual(resumed, self.whole(*SLOW, *words, ending="png"))
        for before, now in (("black", "white"), ("0.5", "transparent")):
            self.interrupted(*SLOW, *OFTEN, "--background", before, "-o", "p.png")
            self.assertEqual(self.picture(*SLOW, "--background", now, "--resume", "-o", "p.png"),
                             self.whole(*SLOW, "--background", now, ending="png"))

    def test_layers_may_be_left_out_but_not_added(self):
        features = ("--denoiser", "features")
        self.interrupted(*SLOW, *OFTEN, *features, "--denoise", "-o", "p.png")
        self.assertEqual(self.picture(*SLOW, *features, "--resume", "-o", "p.png"),
                         self.whole(*SLOW, ending="png"))
        self.interrupted(*SLOW, *OFTEN, "-o", "p.png")
        self.refused(*SLOW, "--denoise", "--resume", "-o", "p.png", code=1,
                     says="--denoise was '' and is 'true'")
        self.interrupted(*SLOW, *OFTEN, "--layers", "none", "-o", "p.exr")
        self.refused(*SLOW, "--resume", "-o", "p.exr", code=1,
                     says="--layers was 'none' and is 'default'")

    def test_the_exposure_matters_where_there_is_a_noise_level(self):
        words = (*SLOW, "--noise", "0.0001", "--exposure", "0")
        self.interrupted(*words, *OFTEN, "-o", "p.exr")
        self.refused(*words, "--exposure", "1", "--resume", "-o", "p.exr", code=1,
                     says="--exposure was '0' and is '1'")

    def test_another_version_is_refused(self):
        checkpoint = self.interrupted(*SLOW, *OFTEN, "-o", "p.exr")
        bytes_before = checkpoint.read_bytes()
        version = self.run_command("--version")[0].split()[-1].encode()
        self.assertIn(version, bytes_before)
        checkpoint.write_bytes(bytes_before.replace(version, b"0.0.0", 1))
        self.refused(*SLOW, "--resume", "-o", "p.exr", code=1, says="another version of Balcony")

    def test_a_damaged_one_is_refused(self):
        checkpoint = self.interrupted(*SLOW, *OFTEN, "-o", "p.exr")
        whole = checkpoint.read_bytes()
        flipped = bytearray(whole)
        flipped[len(whole) // 2] ^= 1
        for bad in (b"", whole[:10], whole[:-1], whole + b"x", bytes(flipped), b"a" * len(whole)):
            checkpoint.write_bytes(bad)
            self.refused(*SLOW, "--resume", "-o", "p.exr", code=1, says="damaged")

    def test_a_full_disk_costs_the_checkpoint_only(self):
        def small_files():
            resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, 100_000))

        _, err = self.run_command(*SLOW, *OFTEN, "-o", "p.png", preexec_fn=small_files)
        self.assertEqual(err.count("the checkpoint 'p.png.checkpoint' cannot be written: "
                                   "File too large"), 1)
        self.assertEqual(self.files(), ["my.cam", "p.png", "room.glb", "scene.obj"])

    def test_a_disk_that_is_full_at_the_end_costs_no_sample(self):
        self.interrupted(*SLOW, *OFTEN, "-o", "p.exr")

        def small_files():
            resource.setrlimit(resource.RLIMIT_FSIZE, (10_000, 10_000))

        _, err = self.run_command(*SLOW, "--resume", "-o", "p.exr", code=3,
                                  preexec_fn=small_files)
        self.assertIn("cannot be written: File too large", err)
        self.assertIn("continue with --resume from 'p.exr.checkpoint'", err)
        self.assertEqual(self.picture(*SLOW, "--resume", "-o", "p.exr"),
                         self.whole(*SLOW))

    def test_a_place_that_cannot_be_written_costs_the_checkpoint_only(self):
        (self.folder / "p.exr.checkpoint.new").mkdir()
        _, err = self.run_command(*SLOW, *OFTEN, "-o", "p.exr")
        self.assertEqual(err.count("exists and is not a regular file"), 1)
        self.assertIn("p.exr", self.files())

    def test_a_folder_that_vanishes_is_told_of(self):
        (self.folder / "out").mkdir()
        process = self.start(*SLOW, *OFTEN, "-o", "out/p.exr")
        self.wait_for(process, "out/p.exr.checkpoint")
        shutil.rmtree(self.folder / "out", ignore_errors=True)
        _, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 3)
        self.assertIn("'out/p.exr.checkpoint.new' cannot be opened: No such file or directory",
                      err.decode())
        self.assertIn("No such file or directory", err.decode())

    def test_a_scene_that_changes_meanwhile_has_none(self):
        process = self.start(*SLOW, "--checkpoint-every", "1s", "--save-every", "0.1s",
                             "-o", "p.exr", "-s", "6000", "--time-limit", "2s")
        self.wait_for(process, "p.exr")
        os.utime(self.folder / "scene.obj", (1, 1))
        _, err = process.communicate(timeout=60)
        self.assertIn("has changed since it was read, so no checkpoint is written", err.decode())
        self.assertNotIn("p.exr.checkpoint", self.files())

    def test_pictures_on_the_way(self):
        process = self.start(*SLOW, "--save-every", "0.1s", "-o", "p.png")
        self.wait_for(process, "p.png")
        self.assertEqual(support.png_pixels(self.folder / "p.png")[:2], (200, 150))
        process.kill()
        process.communicate()

    def test_a_time_limit_gives_a_whole_picture(self):
        facts = self.json_of("render", "scene.obj", "-c", "my.cam:above", "--size", "400x300",
                             "-s", "100000", "--time-limit", "0.5s", "-o", "p.exr")
        self.assertFalse(facts["interrupted"])
        self.assertGreater(facts["passes"], 0)
        self.assertLess(facts["passes"], 100000)
        facts = self.json_of("render", "scene.obj", "--size", "400x300", "--time-limit", "0.000001",
                             "-o", "p.exr")
        self.assertGreaterEqual(facts["passes"], 1)

    def test_durations(self):
        for text in ("0.5s", "0.01min", "0h0.5s", "1", "off"):
            self.run_command("render", "scene.obj", "--size", "20", "--save-every", text)
        for text in ("soon", "-3s", "0s", "3 parsecs", "1..5s", "nan", "s"):
            self.refused("render", "scene.obj", f"--time-limit={text}", code=2,
                         says="--time-limit cannot be", helps="10min")


class Crop(support.CommandTest):
    WORDS = ("render", "scene.obj", "-c", "my.cam:above", "--size", "60x40", "-q", "-o")

    def rows(self, *words):
        self.run_command(*self.WORDS, "p.png", *words)
        return support.png_pixels(self.folder / "p.png")[2]

    def test_a_part_is_that_of_the_whole(self):
        whole = self.rows()
        part = [row[10:30] for row in whole[5:20]]
        self.assertEqual(self.rows("--crop", "20x15+10+5"), part)
        self.assertEqual(self.rows("--crop", "25%,25%,0.75,75%"),
                         [row[15:45] for row in whole[10:30]])
        self.assertEqual(self.rows("--crop", "0,0,1,1"), whole)

    def test_scale(self):
        half = self.rows("--scale", "50%")
        self.assertEqual((len(half), len(half[0])), (20, 30))
        self.assertEqual(self.rows("--scale", "0.5", "--crop", "20x14+10+6"),
                         [row[5:15] for row in half[3:10]])

    def test_refused(self):
        for text in ("20x15", "20x15+10", "0x15+0+0", "10,10,20,20", "0.5,0,0.5,1", "left", "1,2",
                     "20x15-3+4", "0,0,1,2"):
            self.refused(*self.WORDS, "p.png", f"--crop={text}", code=2, says="--crop cannot be",
                         helps="--crop 400x300+100+50")
        for text in ("0", "-50%", "big", "nan", "1e9"):
            self.refused(*self.WORDS, "p.png", f"--scale={text}", code=2, says="--scale cannot be")
        self.refused(*self.WORDS, "p.png", "--crop", "20x15+50+0", code=2,
                     says="not part of the picture of 60 x 40 pixels")


class Bands(ResumedTest):
    WORDS = ("render", "scene.obj", "-c", "my.cam:above", "--integrator", "preview", "-q")

    # Takes seconds, in five bands.
    LONG = ("render", "scene.obj", "-c", "my.cam:above", "--integrator", "preview", "-q",
            "--size", "200x300", "-s", "600", "--film-memory", "1MB", "--checkpoint-every", "0.05s")

    def bytes_of(self, name):
        return (self.folder / name).read_bytes()

    def test_the_file_does_not_depend_on_the_memory(self):
        for words in ((), ("--crop", "150x220+20+30"), ("--noise", "0.02", "-s", "64")):
            for memory in ("1MB", "3MB"):
                facts = self.json_of(*self.WORDS, "--size", "200x300", *words, "--film-memory",
                                     memory, "-o", f"{memory}.exr")
                if "--noise" in words:
                    self.assertGreater(facts["rays"], 1.01 * 16 * 200 * 300)
                else:
                    self.assertEqual(facts["passes"], 16)
            self.assertEqual(self.bytes_of("1MB.exr"), self.bytes_of("3MB.exr"))

    def test_killed_at_random_times_it_gives_the_same_file(self):
        dice = random.Random(2)
        kills = 0
        while kills < KILLS:
            process = self.start(*self.LONG, "--resume", "-o", "p.exr")
            time.sleep(dice.uniform(0.05, 0.5))
            if process.poll() is not None:
                process.communicate()
                self.assertEqual(self.bytes_of("p.exr"), self.whole(*self.LONG))
                (self.folder / "p.exr").unlink()
                continue
            process.kill()
            process.communicate()
            kills += 1
        self.run_command(*self.LONG, "--resume", "-o", "p.exr")
        self.assertEqual(self.bytes_of("p.exr"), self.whole(*self.LONG))
        self.assertFalse(list(self.folder.glob("p.exr.*")))

    def killed_with_checkpoint(self):
        process = self.start(*self.LONG, "-o", "p.exr")
        while not (self.folder / "p.exr.checkpoint").exists():
            self.assertIsNone(process.poll(), "it ended early")
            time.sleep(0.002)
        process.kill()
        process.communicate()

    def test_ctrl_c_loses_nothing(self):
        process = self.start(*self.LONG, "-o", "p.exr")
        while not (self.folder / "p.exr.checkpoint").exists():
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate()
        self.assertEqual(process.returncode, 130, err)
        self.assertFalse((self.folder / "p.exr").exists())
        self.run_command(*self.LONG, "--resume", "-o", "p.exr")
        self.assertEqual(self.bytes_of("p.exr"), self.whole(*self.LONG))

    def test_what_cannot_be_continued(self):
        self.killed_with_checkpoint()
        checkpoint = self.bytes_of("p.exr.checkpoint")
        words = [word.replace("600", "601") for word in self.LONG]
        self.refused(*words, "--resume", "-o", "p.exr", code=1, says="--samples was '600'")
        (self.folder / "p.exr.part").rename(self.folder / "aside")
        self.refused(*self.LONG, "--resume", "-o", "p.exr", code=1, says="is missing",
                     helps="render without --resume")
        for option, says in (("--background=white", "--background was 'auto' and is '1'"),
                             ("--layers=none", "--layers was 'default' and is 'none'")):
            self.refused(*self.LONG, option, "--resume", "-o", "p.exr", code=1, says=says)
        (self.folder / "p.exr.part").write_bytes(b"no picture")
        self.refused(*self.LONG, "--resume", "-o", "p.exr", code=1, says="is damaged")
        (self.folder / "p.exr.checkpoint").write_bytes(b"no checkpoint")
        self.refused(*self.LONG, "--resume", "-o", "p.exr", code=1, says="damaged")
        (self.folder / "aside").rename(self.folder / "p.exr.part")
        (self.folder / "p.exr.checkpoint").write_bytes(checkpoint)
        self.run_command(*self.LONG, "--resume", "-o", "p.exr")

    def test_damaged_bands_are_rendered_again(self):
        process = self.start(*self.LONG, "-o", "p.exr")
        part = self.folder / "p.exr.part"
        while not part.exists() or part.stat().st_size < 45_000:
            self.assertIsNone(process.poll(), "it ended early")
            time.sleep(0.002)
        process.send_signal(signal.SIGINT)
        process.communicate()
        damaged = bytearray(part.read_bytes())
        damaged[len(damaged) - 500] ^= 1
        part.write_bytes(damaged)
        _, err = self.run_command(*self.LONG, "--resume", "-o", "p.exr")
        self.assertRegex(err, r"warning: 'p.exr.part' is damaged from row \d+ on, so these rows "
                              "are rendered again")
        self.assertEqual(self.bytes_of("p.exr"), self.whole(*self.LONG))

    def test_a_full_disk_without_a_checkpoint_leaves_nothing(self):
        def little_room():
            resource.setrlimit(resource.RLIMIT_FSIZE, (50_000, 50_000))

        words = (*self.LONG, "--checkpoint-every", "off")
        before = self.files()
        self.run_command(*words, "-o", "p.exr", code=3, preexec_fn=little_room)
        self.assertEqual(self.files(), before)

    def test_one_process_at_a_time_writes_a_picture(self):
        process = self.start(*self.LONG, "-o", "p.exr")
        while not (self.folder / "p.exr.checkpoint").exists():
            self.assertIsNone(process.poll(), "it ended early")
            time.sleep(0.002)
        for words in ((), ("--resume",)):
            self.refused(*self.LONG, *words, "-o", "p.exr", code=2,
                         says="another process is writing 'p.exr.part'", helps="another name")
        process.communicate()
        self.assertEqual(process.returncode, 0)
        self.assertEqual(self.bytes_of("p.exr"), self.whole(*self.LONG))

    # Its checkpoint is another one the next moment, so it is not looked at.
    def test_the_checkpoint_of_a_running_process_is_not_read(self):
        self.killed_with_checkpoint()
        (self.folder / "p.exr.checkpoint").write_bytes(b"half a checkpoint")
        with open(self.folder / "p.exr.part", "r+b") as part:
            fcntl.flock(part, fcntl.LOCK_EX)
            self.refused(*self.LONG, "--resume", "-o", "p.exr", code=2,
                         says="another process is writing 'p.exr.part'", helps="another name")

    def test_a_picture_in_bands_is_not_denoised(self):
        _, err = self.run_command(*self.LONG[:-2], "-s", "1", "--denoise", "-o", "p.exr")
        self.assertIn("a picture that is rendered in bands is not denoised", err)

    def test_a_full_disk_keeps_the_checkpoint(self):
        self.killed_with_checkpoint()
        before = (self.folder / "p.exr.part").stat().st_size

        def little_room():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (before + 100, before + 100))

        _, err = self.run_command(*self.LONG, "--resume", "-o", "p.exr", code=3,
                                  preexec_fn=little_room)
        self.assertIn("p.exr.part' cannot be written", err)
        self.assertIn("continue with --resume", err)
        self.run_command(*self.LONG, "--resume", "-o", "p.exr")
        self.assertEqual(self.bytes_of("p.exr"), self.whole(*self.LONG))

    def test_what_bands_exclude(self):
        for words in (("--save-every", "10s"), ("--time-limit", "1h")):
            self.refused(*self.WORDS, "--size", "200x300", "--film-memory", "1MB", *words,
                         "-o", "p.exr", code=2, says="rendered in bands", helps="--film-memory")

    def test_too_large(self):
        self.refused(*self.WORDS, "--size", "1000000x1000000", "-o", "p.exr", code=2,
                     says="a picture of 1000000 x 1000000 pixels is too large")
        self.refused(*self.WORDS, "--size", "1000000x1000000", "-o", "p.png", code=3,
                     says="a film of 1000000 x 1000000 pixels needs", helps=".exr")
        self.refused(*self.WORDS, "--size", "0x100", "-o", "p.png", code=2, says="--size cannot be")

    def test_sizes(self):
        for text in ("500MB", "4GiB", "2G", "1e9", "auto"):
            words = (*self.WORDS, "--size", "20", "--film-memory", text, "-o", "p.exr")
            if text == "1e9":
                self.refused(*words, code=2, says="--film-memory cannot be '1e9'")
            else:
                self.run_command(*words)


if __name__ == "__main__":
    support.main()
