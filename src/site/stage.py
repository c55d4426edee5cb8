"""Collects what the site is made of: stage.py FOLDER JAVADOC. Run in the root of the repository.

FOLDER/pages gets the pages, as the generator's Markdown needs them, and FOLDER/mkdocs.yml its settings with the order of the pages.
"""

import json
import re
import shutil
import sys
from pathlib import Path

from order import navigation, title

PAGES = ["README.md", "CONTRIBUTING.md", "SECURITY.md", "CITATION.cff", "LICENSE"]
FOLDERS = ["docs", "scenes", "textures", "src/site/style"]
LINK = re.compile(r"(\]\()([^)\s:#]+)")
FENCE = re.compile(r"^ {0,3}(```|~~~)")
ITEM = re.compile(r"^(?:[-*+]|\d+\.) ")

# Pictures beside each other.
COLUMNS = 3


def main(folder, javadoc):
    shutil.rmtree(folder, ignore_errors=True)
    pages = folder / "pages"
    pages.mkdir(parents=True)
    for page in PAGES:
        shutil.copy(page, pages)
    for name in FOLDERS:
        shutil.copytree(name, pages / name, ignore=shutil.ignore_patterns("*.sh", ".gitignore"))
    write_scenes(pages / "scenes")
    for shelf in ("docs/guide", "docs/notes", "docs/decisions"):
        write_index(pages / shelf)
    for page in sorted(pages.rglob("*.md")):
        copy_what_it_names(page, pages)
        page.write_text(settings_of(page.relative_to(pages)) + as_generator_needs(page), encoding="utf-8")
    settings = Path("src/site/mkdocs.yml").read_text(encoding="utf-8")
    # JSON is YAML.
    order = "nav: " + json.dumps(navigation(pages), ensure_ascii=False) + "\n"
    (folder / "mkdocs.yml").write_text(settings + order, encoding="utf-8")
    shutil.copytree(javadoc, pages / "api", ignore=shutil.ignore_patterns("*.md"))


def write_scenes(scenes):
    """An index of the scene files, which are named but not described elsewhere."""
    seen, unseen = [], []
    for scene in sorted(scenes.glob("*.json")):
        picture = f"../docs/gallery/{scene.stem}.png"
        if (scenes / picture).exists():
            seen.append(f"![{scene.stem}]({picture})<br>[{scene.name}]({scene.name})")
        else:
            unseen.append(f"- [{scene.name}]({scene.name})")
    rows = ["| " + " | ".join(seen[i : i + COLUMNS]) + " |" for i in range(0, len(seen), COLUMNS)]
    text = ["# Scenes", "", "The scene files that come with the program. [Their format](../docs/guide/scene-format.md) has a",
            "[JSON schema](../docs/scene.schema.json), by which editors complete and check them.", "",
            "```sh", "enlightenment render scenes/fire-and-ice.json -o fire-and-ice.png", "```", "",
            "| " * COLUMNS + "|", "|---" * COLUMNS + "|", *rows, "", "Without a picture here:", "", *unseen, ""]
    (scenes / "README.md").write_text("\n".join(text), encoding="utf-8")


def write_index(shelf):
    """An index of a shelf that has none of its own."""
    index = shelf / "README.md"
    if not index.exists():
        links = [f"- [{title(page)}]({page.relative_to(shelf).as_posix()})" for page in sorted(shelf.rglob("*.md"))]
        index.write_text("\n".join(["# " + shelf.name.capitalize(), "", *links, ""]), encoding="utf-8")


def copy_what_it_names(page, pages):
    """Files elsewhere in the repository that a page links to, such as an example of source, and lists of folders without a page."""
    for _, link in LINK.findall(page.read_text(encoding="utf-8")):
        target = (page.parent / link).resolve()
        if target.is_dir() and not (target / "README.md").exists():
            files = sorted(file.name for file in target.iterdir() if file.is_file())
            text = ["# " + target.name.capitalize(), "", *(f"- [{name}]({name})" for name in files), ""]
            (target / "README.md").write_text("\n".join(text), encoding="utf-8")
        elif target.is_relative_to(pages.resolve()) and not target.exists():
            source = target.relative_to(pages.resolve())
            if source.is_file():
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(source, target)


def settings_of(address):
    """Pages that stand alone have no menu beside them, and what is found in the guide comes before what is found elsewhere."""
    name = address.as_posix()
    settings = {"search": {"boost": 2 if name.startswith("docs/guide/") else 0.2 if name == "docs/changes.md" else 1}}
    if name in ("README.md", "docs/gallery/README.md", "scenes/README.md"):
        settings["hide"] = ["navigation", "toc"]
    return "---\n" + json.dumps(settings) + "\n---\n\n"


def as_generator_needs(page):
    """Its Markdown takes lists only after an empty line, and links to pages only, not to folders."""
    lines, fenced, before = [], False, ""
    for line in page.read_text(encoding="utf-8").split("\n"):
        if FENCE.match(line):
            fenced = not fenced
        elif not fenced:
            line = LINK.sub(lambda link: link[1] + page_of(page.parent, link[2]), line)
            if ITEM.match(line) and before.strip() and not ITEM.match(before) and not before.startswith(" "):
                lines.append("")
        lines.append(line)
        before = line
    return "\n".join(lines)


def page_of(folder, target):
    """A folder's index, or what else the link means."""
    return target.rstrip("/") + "/README.md" if (folder / target).is_dir() else target


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
