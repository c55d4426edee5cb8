package enlightenment.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import tools.jackson.core.JsonGenerator;
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
        String text = JsonText.of(json -> {
            json.writeStartObject();
            json.writeStringProperty(all.toString(), all.toString());
            json.writeEndObject();
        });
        JsonNode node = new ObjectMapper().readTree(text);
        assertEquals(all.toString(), node.get(all.toString()).asString());
    }

    @Test
    void halfACharacterIsEscaped() {
        assertEquals("\"\\ud83d\"\n", JsonText.of(json -> json.writeString("\ud83d")));
        assertEquals("\"\\\"\u00e9\\ude00\"\n", JsonText.of(json -> json.writeString("\"\u00e9\ude00")));
    }

    @Test
    void objectsAndArraysAreIndentedAndEmptyOnesAreNot() {
        String text = JsonText.of(json -> {
            json.writeStartArray();
            json.writeStartObject();
            json.writeEndObject();
            json.writeStartArray();
            json.writeEndArray();
            json.writeNumber(-1L);
            json.writeBoolean(true);
            json.writeStartObject();
            json.writeNumberProperty("a", 1);
            json.writeArrayPropertyStart("b");
            json.writeNumber(2);
            json.writeEndArray();
            json.writeEndObject();
            json.writeEndArray();
        });
        assertEquals(
                """
                [
                  {},
                  [],
                  -1,
                  true,
                  {
                    "a": 1,
                    "b": [
                      2
                    ]
                  }
                ]
                """,
                text);
    }

    @Test
    void finiteNumbersKeepTheirValueAndDigitsAndOthersBecomeNull() {
        for (double d : new double[] {0.1, -0.0, 1e-310, Double.MAX_VALUE, 2e-3, 1e21, 5}) {
            assertEquals(d + "\n", JsonText.of(json -> json.writeNumber(d)));
        }
        assertEquals("null\n", JsonText.of(json -> json.writeNumber(Double.NaN)));
        assertEquals("null\n", JsonText.of(json -> json.writeNumber(Float.POSITIVE_INFINITY)));
        String property = JsonText.of(json -> {
            json.writeStartObject();
            json.writeNumberProperty("x", Double.NEGATIVE_INFINITY);
            json.writeEndObject();
        });
        assertEquals("{\n  \"x\": null\n}\n", property);
    }

    @Test
    void anObjectThatIsNotEndedIsAMistake() {
        assertThrows(IllegalStateException.class, () -> JsonText.of(JsonGenerator::writeStartObject));
    }
}
