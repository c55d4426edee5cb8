package enlightenment.scene.json;

import enlightenment.text.Plain;
import java.io.IOException;
import java.io.Reader;
import java.nio.charset.CharacterCodingException;
import java.util.ArrayList;
import java.util.Arrays;
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
 * Reads JSON text into {@link JsonValue}s.
 *
 * <p>Jackson's own tree would do, but for the places of the values, which it does not keep. Texts that repeat (types,
 * names of materials) and lists of keys are shared, so that a scene of a million objects fits.
 */
final class JsonTree {
    static final int DEEPEST_NESTING = 100;
    static final int LONGEST_NUMBER = 5000;

    static final int LONGEST_TEXT = 1_000_000;
    static final int LONGEST_KEY = 10_000;
    private static final int LONGEST_SHARED_TEXT = 64;
    private static final int MOST_SHARED_TEXTS = 10_000;
    private static final int FEW_KEYS = 16;

    private static final JsonFactory FACTORY = JsonFactory.builder()
            .enable(JsonReadFeature.ALLOW_JAVA_COMMENTS)
            // Let through as tokens, to be refused with their place like any other value that is no finite number.
            .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
            .streamReadConstraints(StreamReadConstraints.builder()
                    .maxNestingDepth(DEEPEST_NESTING)
                    .maxNumberLength(LONGEST_NUMBER)
                    .maxStringLength(LONGEST_TEXT)
                    .maxNameLength(LONGEST_KEY)
                    .build())
            .build();

    /** A text that can be read more than once: the second time to show what was found where it broke. */
    interface Source {
        Reader open() throws IOException;
    }

    /** Takes the objects of a scene one by one while the text is read, so that they are never all in memory as JSON. */
    interface Objects {
        /**
         * An array of objects begins; if there was one before, it no longer counts.
         *
         * @param before the part of the scene that stands before it
         */
        void begin(JsonValue.Obj before);

        /**
         * The next object, or what stands in its place.
         *
         * @return what is to stay in the array: the value, or null, so that it is forgotten
         */
        JsonValue take(int index, JsonValue v);
    }

    private final JsonParser parser;
    private final Problems problems;
    private final Objects objects;
    private final Map<String, String> sharedTexts = new HashMap<>();
    private final String[][] lastKeys = new String[DEEPEST_NESTING + 2][];
    private int depth;

    private JsonTree(JsonParser parser, Problems problems, Objects objects) {
        this.parser = parser;
        this.problems = problems;
        this.objects = objects;
    }

    /**
     * The value that a text holds. Duplicate keys become problems.
     *
     * @return null, after adding a problem, where the text is not JSON or cannot be read
     */
    static JsonValue parse(Source source, Problems problems) {
        return parse(source, problems, null);
    }

    /**
     * The same for a scene whose objects are taken one by one; in the value, null stands for those that were forgotten.
     *
     * @param objects takes the items of the root's array {@code objects}; null to keep them all
     */
    static JsonValue parse(Source source, Problems problems, Objects objects) {
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

    private JsonValue value() {
        TokenStreamLocation at = parser.currentTokenLocation();
        int line = at.getLineNr();
        int column = at.getColumnNr();
        JsonToken token = parser.currentToken();
        switch (token) {
            case START_OBJECT:
                return object(line, column);
            case START_ARRAY:
                return array(line, column);
            case VALUE_STRING:
                return new JsonValue.Str(line, column, shared(parser.getString()));
            case VALUE_TRUE:
            case VALUE_FALSE:
                return new JsonValue.Bool(line, column, token == JsonToken.VALUE_TRUE);
            case VALUE_NULL:
                return new JsonValue.Null(line, column);
            default:
                return new JsonValue.Num(line, column, parser.getString());
        }
    }

    private JsonValue object(int line, int column) {
        depth++;
        List<String> keys = new ArrayList<>(8);
        List<JsonValue> values = new ArrayList<>(8);
        Set<String> seen = null;
        while (parser.nextToken() == JsonToken.PROPERTY_NAME) {
            String key = parser.currentName();
            if (keys.size() == FEW_KEYS) {
                seen = new HashSet<>(keys);
            }
            if (seen == null ? keys.contains(key) : !seen.add(key)) {
                TokenStreamLocation at = parser.currentTokenLocation();
                problems.add(
                        at.getLineNr(),
                        at.getColumnNr(),
                        parser.streamReadContext().pathAsPointer().toString(),
                        "the key " + Plain.quoted(key) + " is written twice in the same object");
            }
            boolean streams = objects != null && depth == 1 && key.equals("objects");
            if (parser.nextToken() == JsonToken.START_ARRAY && streams) {
                objects.begin(object(line, column, keys, values));
                values.add(objects());
            } else {
                values.add(value());
            }
            keys.add(key);
        }
        depth--;
        return object(line, column, keys, values);
    }

    private JsonValue.Obj object(int line, int column, List<String> keys, List<JsonValue> values) {
        return new JsonValue.Obj(line, column, sharedKeys(keys), values.toArray(JsonValue[]::new));
    }

    private JsonValue objects() {
        TokenStreamLocation at = parser.currentTokenLocation();
        depth++;
        List<JsonValue> kept = new ArrayList<>();
        while (parser.nextToken() != JsonToken.END_ARRAY) {
            kept.add(objects.take(kept.size(), value()));
        }
        depth--;
        return new JsonValue.Arr(at.getLineNr(), at.getColumnNr(), kept.toArray(JsonValue[]::new));
    }

    private JsonValue array(int line, int column) {
        depth++;
        List<JsonValue> items = new ArrayList<>(4);
        while (parser.nextToken() != JsonToken.END_ARRAY) {
            items.add(value());
        }
        depth--;
        return new JsonValue.Arr(line, column, items.toArray(JsonValue[]::new));
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

    /** Neighbouring objects mostly have the same keys in the same order: one array serves them all. */
    private String[] sharedKeys(List<String> keys) {
        String[] mine = keys.toArray(String[]::new);
        if (!Arrays.equals(mine, lastKeys[depth])) {
            lastKeys[depth] = mine;
        }
        return lastKeys[depth];
    }
}
