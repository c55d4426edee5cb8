#!/usr/bin/env python3
"""CPU-seconds of whole short renders: java -jar, and the launcher with what `setup` makes.

    python3 src/bench/scripts/start_up.py APPLICATION --java HOME [--java HOME ...] [--turns 3] [--scene FILE ...]

APPLICATION is the unpacked zip, HOME a folder of Java. Scenes are those of the application unless some are named. `setup` runs once for each
Java, with a cache of its own. Prints a table in Markdown: for each scene the median of user and system time, processes in turns.
"""
import argparse
import os
import pathlib
import resource
import statistics
import subprocess
import tempfile


def cpu_seconds(command, environment):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, env=environment, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("application", type=pathlib.Path)
    parser.add_argument("--java", action="append", required=True, type=pathlib.Path)
    parser.add_argument("--turns", type=int, default=3)
    parser.add_argument("--scene", action="append", type=pathlib.Path)
    parser.add_argument("--options", default="--size 48x24 --samples 1")
    options = parser.parse_args()
    application = options.application.resolve()
    scenes = options.scene or sorted((application / "scenes").glob("*.json"))
    launcher = str(application / "bin" / "enlightenment")
    with tempfile.TemporaryDirectory() as folder:
        ways = []
        for java in options.java:
            environment = dict(os.environ, JAVA_HOME=str(java), XDG_CACHE_HOME=folder)
            subprocess.run([launcher, "setup"], env=environment, check=True, stdout=subprocess.DEVNULL)
            jar = [str(java / "bin" / "java"), "-jar", str(application / "lib" / "enlightenment.jar")]
            ways += [(f"`java -jar`, {java.name}", jar, environment), (f"launcher, {java.name}", [launcher], environment)]
        print("| scene | " + " | ".join(name for name, _, _ in ways) + " |")
        print("|---" * (len(ways) + 1) + "|")
        for scene in scenes:
            times = [[] for _ in ways]
            for _ in range(options.turns):
                for (_, command, environment), measured in zip(ways, times):
                    arguments = ["render", str(scene), *options.options.split(), "--progress", "none"]
                    arguments += ["-o", os.path.join(folder, "picture.png")]
                    measured.append(cpu_seconds(command + arguments, environment))
            print(f"| {scene.stem} | " + " | ".join(f"{statistics.median(t):.2f}" for t in times) + " |", flush=True)


if __name__ == "__main__":
    main()
