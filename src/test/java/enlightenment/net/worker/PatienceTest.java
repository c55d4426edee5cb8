package enlightenment.net.worker;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class PatienceTest {
    private static final long SECOND = 1_000_000_000L;

    private long now = Long.MAX_VALUE - 3 * SECOND;
    private final Patience patience = new Patience(60, now);

    private void session(double seconds, double useful, boolean hasProgress) {
        now += (long) (seconds * SECOND);
        patience.sessionEnded(now, (long) (useful * SECOND), hasProgress);
    }

    @Test
    void greetingsDoNotBeginTheTimeAnew() {
        for (int i = 0; i < 59; i++) {
            session(1, 0, false);
            assertFalse(patience.isOver(now));
        }
        session(1, 0, false);
        assertTrue(patience.isOver(now));
        assertEquals(60, patience.lostSeconds(now), 1e-6);
    }

    @Test
    void aTileThatTheServerTookBeginsTimeAndPausesAnew() {
        session(59, 0, false);
        patience.nextPauseMillis();
        session(30, 0, true);
        assertEquals(0, patience.lostSeconds(now), 1e-6);
        assertEquals(100, patience.nextPauseMillis());
    }

    @Test
    void timeThatAServerWasOfUseIsNotLost() {
        session(3_600, 3_590, false);
        assertEquals(10, patience.lostSeconds(now), 1e-6);
        assertEquals(100, patience.nextPauseMillis());
        session(10, 0, false);
        assertEquals(200, patience.nextPauseMillis(), "no tile was taken");
    }

    @Test
    void pausesDoubleUpToFiveSeconds() {
        assertEquals(
                List.of(100L, 200L, 400L, 800L, 1_600L, 3_200L, 5_000L, 5_000L),
                Stream.generate(patience::nextPauseMillis).limit(8).toList());
    }
}
