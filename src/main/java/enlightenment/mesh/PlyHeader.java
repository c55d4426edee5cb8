package enlightenment.mesh;

import enlightenment.mesh.input.MeshSource;
import enlightenment.text.Plain;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** The header of a PLY file: which elements follow, and in what form. It ends within the first 64 KiB. */
final class PlyHeader {
    private static final int LONGEST = 1 << 16;

    /** How the numbers behind the header are written. */
    enum Form {
        ASCII,
        LITTLE_ENDIAN,
        BIG_ENDIAN
    }

    /**
     * A property of an element.
     *
     * @param type of the number, or of the numbers of a list
     * @param count the type of a list's length; empty for a single number
     */
    record Property(String name, PlyType type, Optional<PlyType> count) {}

    /** An element: a number of records with the same properties. */
    record Element(String name, long count, List<Property> properties) {
        /** The number of a property; -1 if there is none of that name that is a list, or a single number. */
        int find(String property, boolean isList) {
            for (int i = 0; i < properties.size(); i++) {
                Property p = properties.get(i);
                if (p.name().equals(property) && p.count().isPresent() == isList) {
                    return i;
                }
            }
            return -1;
        }
    }

    final List<Element> elements = new ArrayList<>();
    private final MeshSource source;
    private Form form;

    /** Where the bytes behind the header begin, and their first line. */
    private int length;

    private int lines;

    PlyHeader(MeshSource source) throws IOException {
        this.source = source;
        String text = new String(source.start(LONGEST), StandardCharsets.ISO_8859_1);
        boolean isOfReturns = text.startsWith("\r", 3) && !text.startsWith("\r\n", 3);
        char lineEnd = isOfReturns ? '\r' : '\n';
        String line = "";
        while (!line.equals("end_header")) {
            int end = text.indexOf(lineEnd, length);
            if (end < 0) {
                throw source.failure("its header has no end_header within the first 64 KiB");
            }
            line = text.substring(length, end).strip();
            length = end + 1;
            lines++;
            take(line);
        }
        if (form == null) {
            throw source.failure("its header has no format");
        }
    }

    Form form() {
        return form;
    }

    int length() {
        return length;
    }

    int lines() {
        return lines;
    }

    private IOException failure(String what) {
        return source.failure("line " + lines + ": " + what);
    }

    private void take(String line) throws IOException {
        String[] words = line.split("[ \t]+");
        if (lines == 1) {
            check(line.equalsIgnoreCase("ply"), "begins with " + Plain.quoted(line) + " where ply is expected");
            return;
        }
        switch (words[0]) {
            case "format" -> takeFormat(words);
            case "element" -> takeElement(words);
            case "property" -> takeProperty(words);
            case "comment", "obj_info", "end_header", "" -> {}
            // Some programs write comments without their keyword, such as Blender 2.47.
            default ->
                check(elements.isEmpty(), "has " + Plain.quoted(words[0]) + " where element or property is expected");
        }
    }

    private void check(boolean isRight, String what) throws IOException {
        if (!isRight) {
            throw failure(what);
        }
    }

    private void takeFormat(String[] words) throws IOException {
        check(words.length == 3 && words[2].equals("1.0"), "must be a format and its version 1.0");
        check(form == null, "is a second format");
        form = switch (words[1]) {
            case "ascii" -> Form.ASCII;
            case "binary_little_endian" -> Form.LITTLE_ENDIAN;
            case "binary_big_endian" -> Form.BIG_ENDIAN;
            default ->
                throw failure("has the format " + Plain.quoted(words[1])
                        + "; there are ascii, binary_little_endian and binary_big_endian");
        };
    }

    private void takeElement(String[] words) throws IOException {
        check(words.length == 3 && words[2].matches("[0-9]{1,18}"), "must be an element with its name and its count");
        for (Element e : elements) {
            check(!e.name().equals(words[1]), "is a second element " + Plain.quoted(words[1]));
        }
        elements.add(new Element(words[1], Long.parseLong(words[2]), new ArrayList<>()));
    }

    private void takeProperty(String[] words) throws IOException {
        boolean isList = words.length == 5 && words[1].equals("list");
        check(isList || words.length == 3, "must be a property with its type and its name");
        check(!elements.isEmpty(), "is a property before any element");
        PlyType type = type(words[words.length - 2]);
        Optional<PlyType> count = isList ? Optional.of(type(words[2])) : Optional.empty();
        check(count.isEmpty() || count.get().isInteger(), "has a list whose count is no integer");
        List<Property> properties = elements.get(elements.size() - 1).properties();
        properties.add(new Property(words[words.length - 1], type, count));
    }

    private PlyType type(String word) throws IOException {
        Optional<PlyType> type = PlyType.named(word);
        check(type.isPresent(), "has the unknown type " + Plain.quoted(word));
        return type.orElseThrow();
    }

    /** Refuses an element that has two properties of one name. */
    void checkNames(Element element) throws IOException {
        Set<String> names = new HashSet<>();
        for (Property p : element.properties()) {
            if (!names.add(p.name())) {
                throw source.failure(
                        "element " + Plain.quoted(element.name()) + " has two properties " + Plain.quoted(p.name()));
            }
        }
    }
}
