package enlightenment.primitive;

import enlightenment.math.Vec3;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.json.JsonFactory;

/** Reads the rays with exact distances of {@code intersection-vectors.jsonl}. */
final class Vectors {
    private Vectors() {}

    /**
     * One ray against one primitive.
     *
     * @param texts the values of the line that are numbers, strings or booleans, as written
     * @param triples the values of the line that are vectors
     */
    record Case(Map<String, String> texts, Map<String, Vec3> triples) {
        String kind() {
            return texts.get("kind");
        }

        String scenario() {
            return texts.get("scenario");
        }

        Vec3 triple(String key) {
            return triples.get(key);
        }

        double number(String key) {
            return Double.parseDouble(texts.get(key));
        }

        boolean hit() {
            return Boolean.parseBoolean(texts.get("hit"));
        }

        BigDecimal decimal(String key) {
            return new BigDecimal(texts.get(key));
        }

        /** How far the ray is from the border between hit and miss, in roundings of the distance. */
        double margin() {
            return number("marginEpsD");
        }

        Ray ray() {
            return Ray.of(triple("origin"), triple("direction"));
        }

        @Override
        public String toString() {
            return texts + " " + triples;
        }
    }

    /** All cases of one kind: "sphere", "cylinder", "cone" or "torus". */
    static List<Case> of(String kind) {
        return all().stream().filter(c -> c.kind().equals(kind)).toList();
    }

    static List<Case> all() {
        List<Case> cases = new ArrayList<>();
        try (InputStream in = Objects.requireNonNull(Vectors.class.getResourceAsStream("intersection-vectors.jsonl"));
                JsonParser parser = new JsonFactory().createParser(ObjectReadContext.empty(), in)) {
            while (parser.nextToken() == JsonToken.START_OBJECT) {
                cases.add(readCase(parser));
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return cases;
    }

    private static Case readCase(JsonParser parser) {
        Map<String, String> texts = new HashMap<>();
        Map<String, Vec3> triples = new HashMap<>();
        while (parser.nextToken() != JsonToken.END_OBJECT) {
            String key = parser.currentName();
            if (parser.nextToken() == JsonToken.START_ARRAY) {
                triples.put(key, new Vec3(nextNumber(parser), nextNumber(parser), nextNumber(parser)));
                parser.nextToken();
            } else {
                texts.put(key, parser.getString());
            }
        }
        return new Case(texts, triples);
    }

    private static double nextNumber(JsonParser parser) {
        parser.nextToken();
        return Double.parseDouble(parser.getString());
    }
}
