package enlightenment.scene.json;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.networknt.schema.Schema;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import enlightenment.scene.Method;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tools.jackson.core.json.JsonReadFeature;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Holds the schema and the reader together. */
class SceneSchemaTest {
    private static final JsonMapper JSON = JsonMapper.builder()
            .enable(JsonReadFeature.ALLOW_JAVA_COMMENTS)
            .enable(DeserializationFeature.USE_BIG_DECIMAL_FOR_FLOATS)
            .build();
    private static final SchemaRegistry REGISTRY =
            SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12);
    private static final JsonNode TEXT = JSON.readTree(SceneSchema.text());
    private static final Schema SCHEMA = REGISTRY.getSchema(TEXT);

    private static List<String> complaints(String json) {
        return SCHEMA.validate(JSON.readTree(json)).stream()
                .map(Object::toString)
                .toList();
    }

    @Test
    void theDocumentedSchemaIsTheProgramsSchema() throws IOException {
        byte[] documented = Files.readAllBytes(Documents.projectFolder().resolve("docs/scene.schema.json"));
        assertArrayEquals(documented, SceneSchema.text().getBytes(StandardCharsets.UTF_8));
    }

    @Test
    void theSchemaIsASchema() {
        assertEquals(
                "https://json-schema.org/draft/2020-12/schema",
                TEXT.get("$schema").asString());
        Schema meta = REGISTRY.getSchema(
                com.networknt.schema.SchemaLocation.of("https://json-schema.org/draft/2020-12/schema"));
        assertEquals(List.of(), meta.validate(TEXT));
    }

    static List<String> shippedNames() {
        return Documents.shippedNames();
    }

    @ParameterizedTest
    @MethodSource("shippedNames")
    void shippedScenesAreValid(String name) throws IOException {
        assertEquals(
                List.of(),
                complaints(Files.readString(
                        Documents.projectFolder().resolve("scenes").resolve(name))));
    }

    @Test
    void aDocumentWithEverythingIsValid() {
        assertEquals(List.of(), complaints(Documents.EVERYTHING));
    }

    static List<BadDocuments.Edit> edits() {
        return BadDocuments.FOR_THE_SCHEMA_TOO;
    }

    @ParameterizedTest
    @MethodSource("edits")
    void whatTheReaderRefusesTheSchemaRefuses(BadDocuments.Edit edit) {
        assertFalse(complaints(edit.document()).isEmpty());
    }

    @Test
    void aCubeNeedsAMaterialOrFaces() {
        assertFalse(complaints(Documents.withObjects("{\"type\": \"cube\", \"center\": [0, 0, 0], \"radius\": 1}"))
                .isEmpty());
    }

    @Test
    void bothKnowTheSameKeys() {
        Map<String, Set<String>> readers = new TreeMap<>();
        Vocabulary.all().forEach(keys -> readers.put(keys.schemaName(), new TreeSet<>(keys.all())));
        Map<String, Set<String>> schemas = new TreeMap<>();
        parts().forEach((name, part) ->
                schemas.put(name, new TreeSet<>(part.get("properties").propertyNames())));
        assertEquals(readers, schemas);
    }

    @Test
    void bothNeedTheSameKeys() {
        Map<String, Set<String>> readers = new TreeMap<>();
        Vocabulary.all().forEach(keys -> readers.put(keys.schemaName(), new TreeSet<>(keys.required())));
        Map<String, Set<String>> schemas = new TreeMap<>();
        parts().forEach((name, part) -> schemas.put(name, strings(part.get("required"))));
        assertEquals(readers, schemas);
    }

    @Test
    void noPartTakesUnknownKeys() {
        parts().forEach((name, part) ->
                assertFalse(part.get("additionalProperties").asBoolean(true), name));
    }

    @Test
    void bothKnowTheSameTypesAndWords() {
        Map.of(
                        "camera", Vocabulary.CAMERAS,
                        "object", Vocabulary.OBJECTS,
                        "material", Vocabulary.MATERIALS,
                        "light", Vocabulary.LIGHTS,
                        "texture", Vocabulary.TEXTURES)
                .forEach((family, types) -> {
                    Set<String> refs = new TreeSet<>();
                    TEXT.get("$defs")
                            .get(family)
                            .get("oneOf")
                            .forEach(r -> refs.add(r.get("$ref").asString().substring("#/$defs/".length())));
                    assertEquals(
                            types.values().stream()
                                    .map(Vocabulary.Keys::schemaName)
                                    .collect(Collectors.toCollection(TreeSet::new)),
                            refs);
                    types.forEach((type, keys) -> assertEquals(
                            type,
                            property(keys.schemaName(), "type").get("const").asString()));
                });
        assertEquals(words(Method.words()), strings(property("render", "method").get("enum")));
        assertEquals(
                words(Vocabulary.SHADING_MODELS),
                strings(property("shading", "model").get("enum")));
        assertEquals(
                words(Vocabulary.FILTERS),
                strings(property("fileTexture", "filter").get("enum")));
        assertEquals(
                words(Vocabulary.ENCODINGS),
                strings(property("fileTexture", "encoding").get("enum")));
    }

    @Test
    void thereAreNoWordsThatNothingHolds() {
        assertTrue(BadDocuments.FOR_THE_SCHEMA_TOO.size() > 80);
        assertEquals(Vocabulary.all().size(), parts().size());
    }

    private static Set<String> words(List<String> words) {
        return new TreeSet<>(words);
    }

    private static JsonNode property(String part, String key) {
        return TEXT.get("$defs").get(part).get("properties").get(key);
    }

    /** The definitions of objects with certain keys. */
    private static Map<String, JsonNode> parts() {
        Map<String, JsonNode> parts = new TreeMap<>();
        TEXT.get("$defs").properties().forEach(e -> {
            if (e.getValue().has("properties")) {
                parts.put(e.getKey(), e.getValue());
            }
        });
        return parts;
    }

    private static Set<String> strings(JsonNode array) {
        Set<String> strings = new TreeSet<>();
        if (array != null) {
            array.forEach(v -> strings.add(v.asString()));
        }
        return strings;
    }
}
