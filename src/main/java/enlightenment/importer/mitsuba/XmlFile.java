package enlightenment.importer.mitsuba;

import enlightenment.importer.support.ImportFailure;
import enlightenment.importer.support.InputFolder;
import enlightenment.scene.SceneException;
import enlightenment.text.Plain;
import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/**
 * Reads the XML of a scene into elements. Files are not trusted: there are no document types, no entities and no URLs, and limits to depth and number.
 * {@code default} and {@code include} are resolved here.
 */
final class XmlFile {
    private static final int MOST_DEPTH = 64;
    private static final int MOST_INCLUDES = 16;
    private static final int MOST_ELEMENTS = 4_000_000;

    private final InputFolder folder;
    private final Map<String, String> parameters = new HashMap<>();

    /** The files that are open, the scene's own first. */
    private final Deque<Path> open = new ArrayDeque<>();

    private int elements;

    private XmlFile(InputFolder folder) {
        this.folder = folder;
    }

    /**
     * The root element of a scene.
     *
     * @throws SceneException for what is no XML, or beyond the limits
     */
    static XmlElement read(InputFolder folder) throws IOException {
        return new XmlFile(folder).root(folder.imported());
    }

    private XmlElement root(Path file) throws IOException {
        open.addLast(file.toAbsolutePath().normalize());
        try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
            XMLStreamReader xml = factory().createXMLStreamReader(in);
            return elements(xml, file);
        } catch (XMLStreamException e) {
            int line = e.getLocation() == null ? 0 : Math.max(e.getLocation().getLineNumber(), 0);
            throw ImportFailure.at(file, line, "is no XML: " + Plain.line(reason(e), 200));
        } finally {
            open.removeLast();
        }
    }

    private static XMLInputFactory factory() {
        XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        factory.setProperty(XMLInputFactory.IS_REPLACING_ENTITY_REFERENCES, false);
        factory.setProperty(XMLInputFactory.IS_NAMESPACE_AWARE, false);
        return factory;
    }

    /** The parser's reason without the place, which stands before it. */
    private static String reason(XMLStreamException e) {
        String message = String.valueOf(e.getMessage());
        int at = message.indexOf("Message: ");
        return at < 0 ? message : message.substring(at + "Message: ".length());
    }

    private XmlElement elements(XMLStreamReader xml, Path file) throws XMLStreamException, IOException {
        Deque<XmlElement> stack = new ArrayDeque<>();
        XmlElement root = null;
        while (xml.hasNext()) {
            switch (xml.next()) {
                case XMLStreamConstants.START_ELEMENT -> {
                    XmlElement e = element(xml, file);
                    if (stack.size() >= MOST_DEPTH) {
                        throw e.failure("is nested deeper than " + MOST_DEPTH + " elements");
                    }
                    if (stack.isEmpty()) {
                        root = e;
                    } else {
                        stack.getLast().children().addAll(resolved(e, stack.size()));
                    }
                    stack.addLast(e);
                }
                case XMLStreamConstants.END_ELEMENT -> stack.removeLast();
                case XMLStreamConstants.DTD, XMLStreamConstants.ENTITY_REFERENCE ->
                    throw ImportFailure.at(
                            file,
                            xml.getLocation().getLineNumber(),
                            "has a document type or an entity: scenes have neither");
                default -> {
                    // Text and comments say nothing in a scene.
                }
            }
        }
        return root;
    }

    private XmlElement element(XMLStreamReader xml, Path file) {
        int line = xml.getLocation().getLineNumber();
        if (++elements > MOST_ELEMENTS) {
            throw ImportFailure.at(file, line, "has more than " + MOST_ELEMENTS + " elements");
        }
        Map<String, String> attributes = new HashMap<>();
        for (int i = 0; i < xml.getAttributeCount(); i++) {
            attributes.put(xml.getAttributeLocalName(i), filledIn(xml.getAttributeValue(i), file, line));
        }
        return new XmlElement(xml.getLocalName(), attributes, file, line, open.size() > 1);
    }

    /** A value with its {@code $name} replaced; the longest name that is known counts. */
    private String filledIn(String value, Path file, int line) {
        if (value.indexOf('$') < 0) {
            return value;
        }
        StringBuilder out = new StringBuilder();
        int i = 0;
        while (i < value.length()) {
            int end = i + 1;
            if (value.charAt(i) == '$') {
                while (end < value.length() && isOfName(value.charAt(end))) {
                    end++;
                }
                int from = i + 1;
                int to = end;
                while (to > from && !parameters.containsKey(value.substring(from, to))) {
                    to--;
                }
                if (to == from) {
                    throw ImportFailure.at(
                            file,
                            line,
                            Plain.quoted(value.substring(i, end)) + " has no value: no default gives it one");
                }
                out.append(parameters.get(value.substring(from, to)));
                end = to;
            } else {
                out.append(value.charAt(i));
            }
            i = end;
        }
        return out.toString();
    }

    private static boolean isOfName(char c) {
        return Character.isLetterOrDigit(c) || c == '_';
    }

    /** An element, or what it stands for: nothing for a default, the elements of a file for an include. */
    private List<XmlElement> resolved(XmlElement e, int depth) throws IOException {
        if (e.tag().equals("default")) {
            parameters.putIfAbsent(e.attribute("name"), e.attribute("value"));
            return List.of();
        }
        if (!e.tag().equals("include") || depth != 1) {
            return List.of(e);
        }
        Path included;
        try {
            included = folder.file(e.attribute("filename"));
        } catch (IOException problem) {
            throw e.failure("cannot be included: " + problem.getMessage());
        }
        if (open.contains(included)) {
            List<Path> chain = new ArrayList<>(open);
            chain.add(included);
            throw e.failure("includes itself: "
                    + chain.stream().map(p -> p.getFileName().toString()).collect(Collectors.joining(" -> ")));
        }
        if (open.size() >= MOST_INCLUDES) {
            throw e.failure("includes files deeper than " + MOST_INCLUDES);
        }
        XmlElement root = root(included);
        return root.tag().equals("scene") ? root.children() : List.of(root);
    }
}
