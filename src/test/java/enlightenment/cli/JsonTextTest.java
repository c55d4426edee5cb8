package enlightenment.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.ObjectMapper;

class JsonTextTest {
    @Test
    void anyStringComesBackAsItWas() {
        StringBuilder all = new StringBuilder();
        for (char c = 0; c < 0x180; c++) {
            all.append(c);
        }
        all.append("\u2028\uffff\ud83d\ude00");
        String json = new JsonText()
                .beginObject()
                .key(all.toString())
                .value(all.toString())
                .endObject()
                .finish();
        JsonNode node = new ObjectMapper().readTree(json);
        assertEquals(all.toString(), node.get(all.toString()).asString());
    }

    @Test
    void halfACharacterIsEscaped() {
        assertEquals("\"\\ud83d\"\n", new JsonText().value("\ud83d").finish());
        assertEquals("\"x\\ude00\"\n", new JsonText().value("x\ude00").finish());
    }

    @Test
    void emptyAndNestedThingsAreSeparatedWhereNeeded() {
        String json = new JsonText()
                .beginArray()
                .beginObject()
                .endObject()
                .beginArray()
                .endArray()
                .value(-1L)
                .value(true)
                .endArray()
                .finish();
        assertEquals("[\n  {},\n  [],\n  -1,\n  true\n]\n", json);
    }

    @Test
    void numbersKeepTheirValueAndWhatIsNoneBecomesNull() {
        for (double d : new double[] {0.1, -0.0, 1e-310, Double.MAX_VALUE, 1e21, 5}) {
            String json = new JsonText().value(d).finish();
            assertEquals(d, new ObjectMapper().readTree(json).asDouble(), json);
        }
        assertEquals("null\n", new JsonText().value(Double.NaN).finish());
        assertEquals("null\n", new JsonText().value(Double.NEGATIVE_INFINITY).finish());
    }

    @Test
    void anOpenObjectIsAMistake() {
        JsonText open = new JsonText().beginObject();
        assertTrue(assertThrows(IllegalStateException.class, open::finish)
                .getMessage()
                .startsWith("1 "));
    }
}
