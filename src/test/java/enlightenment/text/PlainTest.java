package enlightenment.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class PlainTest {
    @Test
    void noCharacterThatMovesHidesOrTurnsPasses() {
        for (int c = 0; c <= Character.MAX_CODE_POINT; c++) {
            String plain = Plain.line("a" + Character.toString(c) + "b", 9);
            int shown = plain.codePointAt(1);
            boolean harmless = !Character.isISOControl(shown)
                    && Character.getType(shown) != Character.FORMAT
                    && Character.getDirectionality(shown) < Character.DIRECTIONALITY_LEFT_TO_RIGHT_EMBEDDING;
            if (!harmless) {
                fail("U+" + Integer.toHexString(c) + " is shown as U+" + Integer.toHexString(shown));
            }
        }
    }

    @Test
    void escapeSequencesAndLineEndsAreShownAsText() {
        assertEquals("?[31mred?[0m?enlightenment: done", Plain.line("\u001b[31mred\u001b[0m\nenlightenment: done", 99));
        assertEquals("?31m, ?? end", Plain.line("\u009b31m, \r\n end", 99));
        assertEquals("gnp.?exe", Plain.line("gnp.\u202eexe", 99));
        assertEquals("one\ntwo?", Plain.lines("one\ntwo\u0007"));
    }

    @Test
    void whatPeopleWriteStays() {
        String text = "Höhle 3 – 光 \"ciel\" Ελλάδα עברית 🌍 é";
        assertEquals(text, Plain.line(text, 99));
        assertEquals("a b", Plain.line("a\u00a0b", 9));
    }

    @Test
    void noLineIsLongerThanAllowedAndNoLetterIsCutInTwo() {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 10_000; i++) {
            String text = random.ints(random.nextInt(40), 0, Character.MAX_CODE_POINT)
                    .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append)
                    .toString();
            int most = 3 + random.nextInt(30);
            String plain = Plain.line(text, most);
            assertTrue(plain.length() <= most, plain);
            assertEquals(plain, Plain.line(plain, most), "plain text is plain");
        }
        assertEquals("aaaa...", Plain.line("a".repeat(1_000), 7));
    }

    @Test
    void accentsDoNotPileUp() {
        assertEquals("a" + "\u0301".repeat(4) + "??b", Plain.line("a" + "\u0301".repeat(6) + "b", 99));
    }
}
