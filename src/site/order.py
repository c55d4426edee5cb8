"""The order of the site's pages."""

import re

LINK = re.compile(r"\]\(([^)\s#]+\.md)\)")
TITLE = re.compile(r"^# +(.+)$", re.MULTILINE)


def navigation(pages):
    """The guide in the order of its index, and the other shelves beside it."""
    return [
        {"Start": "README.md"},
        {"Gallery": "docs/gallery/README.md"},
        {"Guide": guide(pages)},
        {"Scenes": "scenes/README.md"},
        {"Java": "api/index.html"},
        {"Notes": shelf(pages, "docs/notes", lambda page: title(page).lower())},
        {"Decisions": shelf(pages, "docs/decisions", lambda page: page.name)},
        {"Project": project(pages)},
    ]


def guide(pages):
    """The index and its pages as it names them, then those that it leaves out."""
    there = sorted(address(page, pages) for page in (pages / "docs/guide").rglob("*.md"))
    index = "docs/guide/README.md"
    named = [index] + ["docs/guide/" + link for link in LINK.findall((pages / index).read_text(encoding="utf-8"))]
    named = [page for page in dict.fromkeys(named) if page in there]
    return named + [page for page in there if page not in named]


def shelf(pages, folder, key):
    """A folder's index, then its pages by their key."""
    found = sorted((pages / folder).rglob("*.md"), key=lambda page: (page.name != "README.md", key(page)))
    return [address(page, pages) for page in found]


def project(pages):
    """What is about the project: the pages that stand on no shelf."""
    found = sorted([*(pages / "docs").glob("*.md"), *pages.glob("*.md")], key=lambda page: title(page).lower())
    return [address(page, pages) for page in found if page.name != "README.md"]


def address(page, pages):
    return page.relative_to(pages).as_posix()


def title(page):
    found = TITLE.search(page.read_text(encoding="utf-8"))
    return found[1] if found else page.stem
