package enlightenment.scene.json.tree;

import enlightenment.text.Plain;
import java.io.IOException;
import java.io.Reader;
import java.nio.charset.CharacterCodingException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.StreamReadConstraints;
import tools.jackson.core.TokenStreamLocation;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.core.json.JsonReadFeature;

/**
 * Parser of JSON text into {@link JsonValue}s.
 *
 * <p>Jackson's own tree does not keep the places of values. Repeated texts (types, names of materials) and lists of keys are shared, so that a
 * scene of a million objects fits into memory.
 */
public final class JsonTree {
    public static final int DEEPEST_NESTING = 100;
    public static final int LONGEST_NUMBER = 5000;

    public static final int LONGEST_TEXT = 1_000_000;
    public static final int LONGEST_KEY = 10_000;

    /** The message for a text that UTF-8 cannot encode. */
    public static final String NO_TEXT = "is not a text: it holds half a character";

    /** The message for a token that is too long. */
    public static final String TOO_LONG = "is too long: a number may have " + LONGEST_NUMBER + " characters, a text "
            + LONGEST_TEXT + ", a key " + LONGEST_KEY;

    private static final int LONGEST_SHARED_TEXT = 64;
    private static final int MOST_SHARED_TEXTS = 10_000;
    private static final int FEW_KEYS = 16;

    public static final JsonFactory FACTORY = JsonFactory.builder()
            .enable(JsonReadFeature.ALLOW_JAVA_COMMENTS)
            // Accepted as tokens, so that they are refused with their place, as other numbers that are not finite.
            .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
            .streamReadConstraints(StreamReadConstraints.builder()
                    .maxNestingDepth(DEEPEST_NESTING)
                    .maxNumberLength(LONGEST_NUMBER)
                    .maxStringLength(LONGEST_TEXT)
                    .maxNameLength(LONGEST_KEY)
                    .build())
            .build();

    /** A text that can be opened repeatedly: error messages quote it from a second read. */
    public interface Source {
        Reader open() throws IOException;
    }

    /** Consumer of the objects of a scene during parsing, so that they are never all in memory as JSON. */
    public interface ObjectSink {
        /**
         * Begins an array of objects, which replaces an earlier one.
         *
         * @param before the scene as read so far, without the array
         */
        void begin(JsonValue.Obj before);

        /**
         * Takes the next item of the array, an object unless the scene is wrong.
         *
         * @return the value that stays in the array; null to discard it
         */
        JsonValue take(int index, JsonValue v);
    }

    private final JsonParser parser;
    private final Problems problems;
    private final ObjectSink objects;
    private final Map<String, String> sharedTexts = new HashMap<>();
    private final String[][] lastKeys = new String[DEEPEST_NESTING + 2][];

    /** Stack of the values of incomplete arrays and objects, outer ones first; {@link #keys} has their keys. */
    private JsonValue[] values = new JsonValue[64];

    private String[] keys = new String[64];
    private int size;

    /** Number of incomplete arrays and objects. Arrays by depth, from 1, have their start in the stack and in the text. */
    private int depth;

    private final int[] starts = new int[DEEPEST_NESTING + 2];
    private final int[] lines = new int[DEEPEST_NESTING + 2];
    private final int[] columns = new int[DEEPEST_NESTING + 2];

    /** Keys of the incomplete objects with {@link #FEW_KEYS} of them or more, by depth; null for others. */
    private final List<Set<String>> seenKeys = new ArrayList<>(Collections.nCopies(DEEPEST_NESTING + 2, null));

    private JsonTree(JsonParser parser, Problems problems, ObjectSink objects) {
        this.parser = parser;
        this.problems = problems;
        this.objects = objects;
    }

    /**
     * Parses a text. Duplicate keys are reported as problems.
     *
     * @return the root value; null after a problem if the text is not JSON or cannot be read
     */
    public static JsonValue parse(Source source, Problems problems) {
        return parse(source, problems, null);
    }

    /**
     * Parses a scene whose objects are consumed one by one. In the result, null stands for discarded objects.
     *
     * @param objects consumer of the items of the root's array {@code objects}; null to keep them all
     */
    public static JsonValue parse(Source source, Problems problems, ObjectSink objects) {
        try (Reader reader = source.open();
                JsonParser parser = FACTORY.createParser(ObjectReadContext.empty(), reader)) {
            try {
                return new JsonTree(parser, problems, objects).document();
            } catch (JacksonException e) {
                if (e.getCause() instanceof IOException io) {
                    throw io;
                }
                SyntaxError.report(parser, e, source, problems);
                return null;
            }
        } catch (CharacterCodingException e) {
            problems.add(0, 0, "", "is not a text in UTF-8, as a scene file must be");
        } catch (IOException e) {
            problems.add(0, 0, "", "cannot be read: " + e);
        }
        return null;
    }

    private JsonValue document() {
        if (parser.nextToken() == null) {
            problems.add(1, 1, "", "is empty; expected a scene, which is a JSON object { ... }");
            return null;
        }
        JsonValue root = value();
        if (parser.nextToken() != null) {
            TokenStreamLocation at = parser.currentTokenLocation();
            problems.add(at.getLineNr(), at.getColumnNr(), "", "more text after the end of the scene");
            return null;
        }
        return root;
    }

    /**
     * Parses the value that begins at the current token. A loop with an explicit stack: recursive methods were inlined into each other and cost
     * seconds of just-in-time compilation.
     */
    private JsonValue value() {
        int outside = depth;
        while (true) {
            JsonToken token = parser.currentToken();
            JsonValue complete = null;
            if (token == JsonToken.PROPERTY_NAME) {
                addKey();
            } else if (token == JsonToken.START_ARRAY && isArrayOfObjects()) {
                complete = objects();
            } else if (token == JsonToken.START_OBJECT || token == JsonToken.START_ARRAY) {
                open();
            } else if (token == JsonToken.END_OBJECT || token == JsonToken.END_ARRAY) {
                complete = close(token == JsonToken.END_OBJECT);
            } else {
                complete = scalar(token);
            }
            if (complete != null) {
                if (depth == outside) {
                    return complete;
                }
                makeRoom();
                values[size++] = complete;
            }
            parser.nextToken();
        }
    }

    private JsonValue scalar(JsonToken token) {
        TokenStreamLocation at = parser.currentTokenLocation();
        int line = at.getLineNr();
        int column = at.getColumnNr();
        return switch (token) {
            case VALUE_STRING -> new JsonValue.Str(line, column, shared(wellFormed(parser.getString())));
            case VALUE_TRUE, VALUE_FALSE -> new JsonValue.Bool(line, column, token == JsonToken.VALUE_TRUE);
            case VALUE_NULL -> new JsonValue.Null(line, column);
            default -> new JsonValue.Num(line, column, parser.getString());
        };
    }

    private String wellFormed(String text) {
        if (!Plain.isWellFormed(text)) {
            TokenStreamLocation at = parser.currentTokenLocation();
            String pointer = parser.streamReadContext().pathAsPointer().toString();
            problems.add(at.getLineNr(), at.getColumnNr(), pointer, NO_TEXT);
        }
        return text;
    }

    private void open() {
        TokenStreamLocation at = parser.currentTokenLocation();
        makeRoom();
        depth++;
        lines[depth] = at.getLineNr();
        columns[depth] = at.getColumnNr();
        // Its own place, and its key, stay where they are.
        starts[depth] = ++size;
    }

    /** Ensures capacity for one more value and its key. */
    private void makeRoom() {
        if (size == values.length) {
            values = Arrays.copyOf(values, 2 * size);
            keys = Arrays.copyOf(keys, 2 * size);
        }
    }

    private JsonValue close(boolean isObject) {
        int start = starts[depth];
        JsonValue v = isObject
                ? object()
                : new JsonValue.Arr(lines[depth], columns[depth], Arrays.copyOfRange(values, start, size));
        size = start - 1;
        seenKeys.set(depth--, null);
        return v;
    }

    /** The innermost incomplete object, with the members read so far. */
    private JsonValue.Obj object() {
        return new JsonValue.Obj(
                lines[depth], columns[depth], sharedKeys(), Arrays.copyOfRange(values, starts[depth], size));
    }

    private void addKey() {
        String key = wellFormed(parser.currentName());
        makeRoom();
        if (isTwice(key)) {
            TokenStreamLocation at = parser.currentTokenLocation();
            problems.add(
                    at.getLineNr(),
                    at.getColumnNr(),
                    parser.streamReadContext().pathAsPointer().toString(),
                    "the key " + Plain.quoted(key) + " is written twice in the same object");
        }
        keys[size] = key;
    }

    private boolean isTwice(String key) {
        int start = starts[depth];
        if (size - start < FEW_KEYS) {
            for (int i = start; i < size; i++) {
                if (keys[i].equals(key)) {
                    return true;
                }
            }
            return false;
        }
        if (seenKeys.get(depth) == null) {
            seenKeys.set(depth, new HashSet<>(Arrays.asList(keys).subList(start, size)));
        }
        return !seenKeys.get(depth).add(key);
    }

    private boolean isArrayOfObjects() {
        return objects != null && depth == 1 && "objects".equals(parser.currentName());
    }

    private JsonValue objects() {
        objects.begin(object());
        open();
        List<JsonValue> kept = new ArrayList<>();
        while (parser.nextToken() != JsonToken.END_ARRAY) {
            kept.add(objects.take(kept.size(), value()));
        }
        size--;
        depth--;
        return new JsonValue.Arr(lines[depth + 1], columns[depth + 1], kept.toArray(JsonValue[]::new));
    }

    private String shared(String text) {
        if (text.length() > LONGEST_SHARED_TEXT) {
            return text;
        }
        String known = sharedTexts.get(text);
        if (known == null && sharedTexts.size() < MOST_SHARED_TEXTS) {
            sharedTexts.put(text, text);
        }
        return known == null ? text : known;
    }

    /** The keys of the innermost object, in the array of the previous object at this depth if they are equal. */
    private String[] sharedKeys() {
        int start = starts[depth];
        String[] last = lastKeys[depth];
        if (last == null || !Arrays.equals(last, 0, last.length, keys, start, size)) {
            lastKeys[depth] = Arrays.copyOfRange(keys, start, size);
        }
        return lastKeys[depth];
    }
}
