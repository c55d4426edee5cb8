package enlightenment.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class RestingThreadsTest {
    private static final long MILLI = 1_000_000;

    private boolean isCancelled;
    private boolean isInUse = true;
    private long now = 1;
    private final List<Long> rests = new ArrayList<>();
    private final RestingThreads check = new RestingThreads(() -> isCancelled, () -> isInUse, () -> now, rests::add);

    private void work(long millis) {
        now += millis * MILLI;
        assertFalse(check.getAsBoolean());
    }

    @Test
    void threadsRestThreeTimesAsLongAsTheyWorked() {
        work(50);
        work(2);
        work(7);
        work(1000);
        // Nothing is known of the work before the first check; a long rest would keep a cancellation waiting.
        assertEquals(List.of(6L, 21L, 100L), rests);
    }

    @Test
    void threadsDoNotRestWhileTheViewIsNotInUse() {
        work(1);
        isInUse = false;
        work(5);
        assertEquals(List.of(), rests);
        isInUse = true;
        work(3);
        assertEquals(List.of(9L), rests);
    }

    @Test
    void whatIsCancelledEndsAtOnce() {
        work(1);
        isCancelled = true;
        now += MILLI;
        assertTrue(check.getAsBoolean());
        assertEquals(List.of(), rests);
    }
}
