package enlightenment.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.util.List;
import org.junit.jupiter.api.Test;

class SuggestionTest {
    @Test
    void theDistanceCountsInsertionsDeletionsSubstitutionsAndSwaps() {
        assertEquals(0, Suggestion.distance("radius", "radius"));
        assertEquals(1, Suggestion.distance("radus", "radius"));
        assertEquals(1, Suggestion.distance("raddius", "radius"));
        assertEquals(1, Suggestion.distance("rabius", "radius"));
        assertEquals(1, Suggestion.distance("raduis", "radius"));
        assertEquals(3, Suggestion.distance("kitten", "sitting"));
        assertEquals(4, Suggestion.distance("", "cone"));
    }

    @Test
    void theNearestWordIsSuggestedIfItIsNear() {
        List<String> words = List.of("center", "radius", "rotation", "material");
        assertEquals("radius", Suggestion.nearest("raduis", words));
        assertEquals("radius", Suggestion.nearest("Radius", words));
        assertEquals("center", Suggestion.nearest("centre", words));
        assertNull(Suggestion.nearest("colour", words));
        assertNull(Suggestion.nearest("a", List.of("b")));
    }

    @Test
    void whereNothingIsNearAllIsListed() {
        assertEquals("; expected one of \"a\", \"b\"", Suggestion.of("xyz", List.of("a", "b"), "expected one of"));
    }
}
