package enlightenment.importer.gltf;

import enlightenment.text.Plain;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.StreamReadConstraints;
import tools.jackson.core.TokenStreamLocation;
import tools.jackson.core.json.JsonFactory;

/**
 * Parses the JSON text of a glTF file into maps, lists, strings, doubles and booleans; null stays null, and of a key that is written twice the
 * last value counts. Texts may be as long as the file, since they may hold whole buffers.
 */
final class GltfJson {
    private static final int DEEPEST_NESTING = 100;
    private static final int LONGEST_NUMBER = 1000;
    private static final int LONGEST_KEY = 10_000;
    private static final int LONGEST_REASON = 200;

    private static final JsonFactory FACTORY = JsonFactory.builder()
            .streamReadConstraints(StreamReadConstraints.builder()
                    .maxNestingDepth(DEEPEST_NESTING)
                    .maxNumberLength(LONGEST_NUMBER)
                    .maxStringLength(Integer.MAX_VALUE)
                    .maxNameLength(LONGEST_KEY)
                    .build())
            .build();

    /** Arrays and objects that are not complete, the innermost first. */
    private final Deque<Object> open = new ArrayDeque<>();

    /** The key of each object that is not complete, the innermost first; of arrays, "". */
    private final Deque<String> keys = new ArrayDeque<>();

    private Object root;

    private GltfJson() {}

    /**
     * The root of a text in UTF-8.
     *
     * @throws IOException with the line and the column, if it is no JSON object
     */
    static GltfElement parse(byte[] text) throws IOException {
        try (JsonParser parser = FACTORY.createParser(ObjectReadContext.empty(), text)) {
            try {
                return root(new GltfJson().document(parser));
            } catch (JacksonException e) {
                TokenStreamLocation at = parser.currentLocation();
                String reason = e.getOriginalMessage().lines().findFirst().orElse("it is damaged");
                throw new IOException("line " + at.getLineNr() + ", column " + at.getColumnNr() + ": is no JSON text: "
                        + Plain.line(reason, LONGEST_REASON));
            }
        }
    }

    private static GltfElement root(Object value) throws IOException {
        if (!(value instanceof Map)) {
            throw new IOException("is no glTF file: its JSON text must be an object { ... }");
        }
        return new GltfElement(value, "");
    }

    private Object document(JsonParser parser) {
        for (JsonToken token = parser.nextToken(); token != null; token = parser.nextToken()) {
            switch (token) {
                case PROPERTY_NAME -> keys.push(parser.currentName());
                case START_OBJECT -> open(new LinkedHashMap<String, Object>());
                case START_ARRAY -> open(new ArrayList<>());
                case END_OBJECT, END_ARRAY -> add(open.pop());
                case VALUE_STRING -> add(parser.getString());
                case VALUE_TRUE, VALUE_FALSE -> add(token == JsonToken.VALUE_TRUE);
                case VALUE_NULL -> add(null);
                default -> add(Double.valueOf(parser.getString()));
            }
        }
        return root;
    }

    private void open(Object container) {
        open.push(container);
    }

    @SuppressWarnings("unchecked")
    private void add(Object value) {
        if (open.isEmpty()) {
            root = value;
        } else if (open.peek() instanceof List<?> list) {
            ((List<Object>) list).add(value);
        } else {
            ((Map<String, Object>) open.peek()).put(keys.pop(), value);
        }
    }
}
