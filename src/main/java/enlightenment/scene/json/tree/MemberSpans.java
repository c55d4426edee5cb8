package enlightenment.scene.json.tree;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;

/**
 * The positions of the members of one object in a JSON text.
 *
 * @param open index of the character behind the object's opening brace
 * @param values spans by key, in the order of the text
 */
public record MemberSpans(int open, Map<String, Span> values) {
    private static final char BYTE_ORDER_MARK = '\ufeff';

    /**
     * The position of a member.
     *
     * @param key index of the first character of the key, its quotation mark
     * @param start index of the first character of the value
     * @param end index of the character behind the value
     */
    public record Span(int key, int start, int end) {}

    /**
     * The members of the object that a list of keys leads to.
     *
     * @throws IllegalArgumentException if the text is no JSON, or has no object there
     */
    public static MemberSpans of(String text, List<String> path) {
        int mark = !text.isEmpty() && text.charAt(0) == BYTE_ORDER_MARK ? 1 : 0;
        try (JsonParser parser = JsonTree.FACTORY.createParser(ObjectReadContext.empty(), text.substring(mark))) {
            parser.nextToken();
            for (String key : path) {
                enter(parser, key);
            }
            requireObject(parser);
            int open = mark + (int) parser.currentLocation().getCharOffset();
            Map<String, Span> values = new LinkedHashMap<>();
            while (parser.nextToken() == JsonToken.PROPERTY_NAME) {
                String key = parser.currentName();
                int keyStart = mark + (int) parser.currentTokenLocation().getCharOffset();
                values.put(key, value(parser, keyStart, mark));
            }
            return new MemberSpans(open, values);
        } catch (JacksonException e) {
            throw new IllegalArgumentException("the text is no JSON: " + e.getOriginalMessage(), e);
        }
    }

    private static void requireObject(JsonParser parser) {
        if (parser.currentToken() != JsonToken.START_OBJECT) {
            throw new IllegalArgumentException("there is no JSON object where one was expected");
        }
    }

    /** Moves on to the value of a key of the object that begins at the current token. */
    private static void enter(JsonParser parser, String key) {
        requireObject(parser);
        while (parser.nextToken() == JsonToken.PROPERTY_NAME) {
            boolean isIt = parser.currentName().equals(key);
            parser.nextToken();
            if (isIt) {
                return;
            }
            parser.skipChildren();
        }
        throw new IllegalArgumentException("the JSON object has no key \"" + key + "\"");
    }

    private static Span value(JsonParser parser, int key, int mark) {
        parser.nextToken();
        int start = mark + (int) parser.currentTokenLocation().getCharOffset();
        parser.skipChildren();
        // The parser reads a string to its end only on demand.
        parser.finishToken();
        return new Span(key, start, mark + (int) parser.currentLocation().getCharOffset());
    }

    public boolean has(String key) {
        return values.containsKey(key);
    }

    /** The text with another value of a key; a new key becomes the last of the object. */
    public String with(String text, String key, String value) {
        Span old = values.get(key);
        if (old != null) {
            return text.substring(0, old.start) + value + text.substring(old.end);
        }
        String member = "\"" + key + "\": " + value;
        if (values.isEmpty()) {
            return text.substring(0, open) + " " + member + " " + text.substring(open);
        }
        Span last = null;
        for (Span span : values.values()) {
            last = span;
        }
        return text.substring(0, last.end) + "," + gap(text, last.key) + member + text.substring(last.end);
    }

    /** The separator in front of a member: line end and indentation, or a space. */
    private String gap(String text, int key) {
        int start = key;
        while (start > open && Character.isWhitespace(text.charAt(start - 1))) {
            start--;
        }
        String space = text.substring(start, key);
        return space.contains("\n") ? space : " ";
    }
}
