package enlightenment.importer.mitsuba;

import enlightenment.importer.support.ExtractedFiles;
import enlightenment.importer.support.ImportDraft;
import enlightenment.importer.support.ImportNotes;
import enlightenment.importer.support.InputFolder;
import enlightenment.text.Plain;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** What the readers of a scene share: its draft, its elements by id, and its folder. */
final class SceneIndex {
    private final ImportDraft draft;
    private final InputFolder folder;
    private final DerivedPictures pictures;
    private final Map<String, XmlElement> byId = new HashMap<>();
    private final List<String> prefixes = new ArrayList<>(List.of(""));
    private final boolean isOld;

    /**
     * The index of a scene.
     *
     * @param folder of the scene's own file
     * @param made where pictures go that are made of its own
     */
    SceneIndex(XmlElement root, InputFolder folder, ImportDraft draft, ExtractedFiles made) {
        this.draft = draft;
        pictures = new DerivedPictures(made);
        this.folder = folder;
        isOld = root.attribute("version").startsWith("0.");
        Deque<XmlElement> open = new ArrayDeque<>(List.of(root));
        List<XmlElement> aliases = new ArrayList<>();
        while (!open.isEmpty()) {
            XmlElement e = open.removeLast();
            if (e.tag().equals("alias")) {
                aliases.add(e);
            } else if (e.tag().equals("path")) {
                prefixes.add(e.attribute("value") + "/");
            } else if (!e.tag().equals("ref") && e.has("id") && byId.put(e.attribute("id"), e) != null) {
                throw e.failure("has an id that another element has, too: " + Plain.quoted(e.attribute("id")));
            }
            open.addAll(e.children());
        }
        for (XmlElement alias : aliases) {
            byId.put(alias.attribute("as"), target(alias));
        }
    }

    ImportDraft draft() {
        return draft;
    }

    DerivedPictures pictures() {
        return pictures;
    }

    ImportNotes notes() {
        return draft.notes();
    }

    /** Whether it is a scene of Mitsuba 0.6. */
    boolean isOld() {
        return isOld;
    }

    void note(XmlElement e, String message) {
        notes().add(e.place(), message);
    }

    /** Notes the properties of a plugin that nothing asked for; whatever their names, plugins inside of it are found by their kind. */
    void noteUnused(Properties p) {
        p.unused()
                .filter(value ->
                        !value.tag().equals("ref") || target(value).tag().equals("texture"))
                .map(XmlElement::name)
                .distinct()
                .forEach(name -> note(p.element(), p.element().described() + ": " + name + " is left out"));
    }

    /** The element itself, or what a reference means. */
    XmlElement resolved(XmlElement e) {
        return e.tag().equals("ref") ? target(e) : e;
    }

    private XmlElement target(XmlElement reference) {
        XmlElement e = byId.get(reference.attribute("id"));
        if (e == null) {
            throw reference.failure("refers to an id that nothing has: " + Plain.quoted(reference.attribute("id")));
        }
        return e;
    }

    /** The plugins inside of a plugin that are of a kind, by reference or nested. */
    List<XmlElement> inside(XmlElement parent, String tag) {
        List<XmlElement> found = new ArrayList<>();
        for (XmlElement child : parent.children()) {
            if (child.tag().equals(tag)
                    || child.tag().equals("ref") && target(child).tag().equals(tag)) {
                found.add(resolved(child));
            }
        }
        return found;
    }

    /**
     * A file of the scene's folder.
     *
     * @throws IOException whose message is fit to be shown
     */
    Path file(String name) throws IOException {
        List<String> problems = new ArrayList<>();
        for (String prefix : prefixes) {
            try {
                return folder.file(prefix + name);
            } catch (IOException e) {
                problems.add(e.getMessage());
            }
        }
        throw new IOException(String.join(", and ", problems));
    }
}
