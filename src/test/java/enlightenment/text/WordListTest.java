package enlightenment.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

class WordListTest {
    @Test
    void theConjunctionStandsBeforeTheLastWordOnly() {
        assertEquals("PNG", WordList.join(List.of("PNG"), "or"));
        assertEquals(".png or .pfm", WordList.join(List.of(".png", ".pfm"), "or"));
        assertEquals("a, b, c and d", WordList.join(List.of("a", "b", "c", "d"), "and"));
    }
}
