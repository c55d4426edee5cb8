"""Checks a site: check.py FOLDER. Every link leads to a file and a place in it, and no page loads anything from elsewhere."""

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

# Attributes whose address the browser loads by itself.
LOADED = {("script", "src"), ("img", "src"), ("link", "href"), ("iframe", "src"), ("source", "src"), ("video", "src"), ("object", "data")}
# Links that only describe where else the page or its like is.
DESCRIBING = {"canonical", "next", "prev", "alternate"}


class Page(HTMLParser):
    """The places of a page, where it leads, and what it loads."""

    def __init__(self, text):
        super().__init__()
        self.places, self.links, self.loads = set(), [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.places.update(value for name in ("id", "name") if (value := values.get(name)))
        for name, value in attributes:
            if value is None or name not in ("href", "src", "data"):
                continue
            if tag == "a":
                self.links.append(value)
            elif (tag, name) in LOADED and values.get("rel") not in DESCRIBING:
                self.links.append(value)
                self.loads.append(value)


def main(root):
    pages = {path.resolve(): Page(path.read_text(encoding="utf-8")) for path in sorted(root.rglob("*.html"))}
    faults, links = [], 0
    for path, page in pages.items():
        name = path.relative_to(root.resolve())
        # The page for addresses that lead nowhere names others from the root of a server.
        if str(name) == "404.html":
            continue
        faults += [f"{name}: loads {address}" for address in page.loads if urlsplit(address).netloc]
        # The links within the Javadoc are javadoc's own.
        if name.parts[0] == "api":
            continue
        for address in page.links:
            links += 1
            if not leads_somewhere(path, address, pages):
                faults.append(f"{name}: {address}")
    faults += [f"{path.relative_to(root)}: loads fonts or pictures from elsewhere" for path in root.rglob("*.css")
               if "url(http" in path.read_text(encoding="utf-8").replace('"', "").replace("'", "")]
    for fault in faults:
        print(fault, file=sys.stderr)
    print(f"{len(pages)} pages, {links} links, {len(faults)} broken")
    return 1 if faults or links < 1000 else 0


def leads_somewhere(path, address, pages):
    parts = urlsplit(address)
    if parts.scheme or parts.netloc:
        return True
    target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
    if target.is_dir():
        target = target / "index.html"
    if target in pages and parts.fragment and parts.fragment not in ("main-content",):
        return unquote(parts.fragment) in pages[target].places or parts.fragment in pages[target].places
    return target.exists()


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
