package enlightenment.importer.mitsuba;

import enlightenment.importer.support.ImportFailure;
import enlightenment.scene.SceneException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** An element of a scene's XML, with its place. Attributes have their parameters filled in; names are those of Mitsuba 3. */
final class XmlElement {
    private final String tag;
    private final Map<String, String> attributes;
    private final Path file;
    private final int line;
    private final boolean isIncluded;
    private final List<XmlElement> children = new ArrayList<>();

    /** @param isIncluded whether its file is not the scene's own, so that places need its name */
    XmlElement(String tag, Map<String, String> attributes, Path file, int line, boolean isIncluded) {
        this.tag = tag.toLowerCase(Locale.ROOT);
        this.attributes = attributes;
        this.file = file;
        this.line = line;
        this.isIncluded = isIncluded;
    }

    /** The name of the element in small letters. */
    String tag() {
        return tag;
    }

    /** The plugin, such as {@code "diffuse"}, in small letters; "" if it has none. */
    String type() {
        return attribute("type").toLowerCase(Locale.ROOT);
    }

    /** The name by which the parent knows it, as Mitsuba 3 writes it: {@code to_world} for {@code toWorld}; "" if it has none. */
    String name() {
        return snakeCase(attribute("name"));
    }

    /** An attribute, or "". */
    String attribute(String key) {
        return attributes.getOrDefault(key, "");
    }

    boolean has(String key) {
        return attributes.containsKey(key);
    }

    List<XmlElement> children() {
        return children;
    }

    /** Where it is, for notes. */
    String place() {
        return isIncluded ? file.getFileName() + " line " + line : "line " + line;
    }

    Path file() {
        return file;
    }

    SceneException failure(String message) {
        return ImportFailure.at(file, line, message);
    }

    /** {@code intIOR} becomes {@code int_ior}. */
    static String snakeCase(String name) {
        return name.replaceAll("([a-z0-9])([A-Z])", "$1_$2").toLowerCase(Locale.ROOT);
    }

    /** What it is called in messages. */
    String described() {
        return type().isEmpty() ? tag : tag + " " + type();
    }
}
