package enlightenment.scene.json;

import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.StreamReadConstraints;
import tools.jackson.core.TokenStreamLocation;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.core.json.JsonReadFeature;

/** Turns JSON text into a tree of {@link Node}s. Comments are skipped; everything else is as strict as JSON is. */
final class TreeReader {
    private static final int MAX_NESTING = 100;
    private static final int MAX_NUMBER_LENGTH = 5000;

    private final JsonParser parser;
    private final Problems problems;
    private Node container;
    private Node root;
    private int line;
    private int column;

    private TreeReader(JsonParser parser, Problems problems) {
        this.parser = parser;
        this.problems = problems;
    }

    /** The document's value, or null after a problem that left no whole document. */
    static Node read(String json, Problems problems) {
        JsonFactory factory = JsonFactory.builder()
                .enable(JsonReadFeature.ALLOW_JAVA_COMMENTS)
                .streamReadConstraints(StreamReadConstraints.builder()
                        .maxNestingDepth(MAX_NESTING)
                        .maxNumberLength(MAX_NUMBER_LENGTH)
                        .build())
                .build();
        try (JsonParser parser = factory.createParser(ObjectReadContext.empty(), json)) {
            return new TreeReader(parser, problems).document();
        }
    }

    private Node document() {
        try {
            JsonToken token = parser.nextToken();
            if (token == null) {
                problems.add(1, 1, "", "must be a scene, but is empty");
                return null;
            }
            for (; token != null; token = parser.nextToken()) {
                locate();
                if (root != null && container == null) {
                    problems.add(line, column, "", "must end after the scene's last \"}\", but more follows");
                    return null;
                }
                accept(token);
            }
            return root;
        } catch (JacksonException e) {
            // Trouble with the syntax: nothing that follows can be trusted.
            TokenStreamLocation at = e.getLocation();
            boolean known = at != null && at.getLineNr() > 0;
            problems.add(
                    known ? at.getLineNr() : line,
                    known ? at.getColumnNr() : column,
                    pointer(),
                    "must be JSON: " + e.getOriginalMessage());
            return null;
        }
    }

    private void locate() {
        TokenStreamLocation at = parser.currentTokenLocation();
        line = at.getLineNr();
        column = at.getColumnNr();
    }

    private void accept(JsonToken token) {
        switch (token) {
            case PROPERTY_NAME:
                key();
                break;
            case START_OBJECT:
                container = add(new Node.Obj(container, index(), line, column));
                break;
            case START_ARRAY:
                container = add(new Node.Arr(container, index(), line, column));
                break;
            case END_OBJECT:
            case END_ARRAY:
                container = container.parent;
                break;
            case VALUE_STRING:
                add(new Node.Str(container, index(), line, column, parser.getString()));
                break;
            case VALUE_NUMBER_INT:
            case VALUE_NUMBER_FLOAT:
                number();
                break;
            case VALUE_TRUE:
            case VALUE_FALSE:
                add(new Node.Word(container, index(), line, column, token == JsonToken.VALUE_TRUE));
                break;
            default:
                add(new Node.Word(container, index(), line, column, null));
                break;
        }
    }

    private void key() {
        Node.Obj object = (Node.Obj) container;
        String key = parser.currentName();
        int earlier = object.indexOf(key);
        if (earlier >= 0) {
            problems.add(
                    line,
                    column,
                    object.pointer() + "/" + Node.escape(key),
                    "must be given once, but " + Node.quote(key) + " was already given in line "
                            + object.keyLine(earlier));
        }
        object.addKey(key, line, column);
    }

    private void number() {
        Node.Num number = new Node.Num(container, index(), line, column, parser.getString());
        add(number);
        String problem = Numbers.problem(number.text);
        if (problem != null) {
            problems.at(number, problem);
            number.bad = true;
        }
    }

    private int index() {
        if (container instanceof Node.Obj) {
            return ((Node.Obj) container).size();
        }
        return container == null ? 0 : ((Node.Arr) container).values.size();
    }

    private Node add(Node node) {
        if (container instanceof Node.Obj) {
            ((Node.Obj) container).addValue(node);
        } else if (container != null) {
            ((Node.Arr) container).values.add(node);
        } else {
            root = node;
        }
        return node;
    }

    /** The pointer of the value that the parser was about to read. */
    private String pointer() {
        if (container == null) {
            return "";
        }
        if (container instanceof Node.Arr) {
            return container.pointer() + "/" + index();
        }
        int last = ((Node.Obj) container).size();
        String key = ((Node.Obj) container).keyOrNull(last);
        // After a value and before the next key, what was read last is where the reader should look.
        if (key == null && last > 0) {
            key = ((Node.Obj) container).key(last - 1);
        }
        return key == null ? container.pointer() : container.pointer() + "/" + Node.escape(key);
    }
}
