package enlightenment.work;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class CancellationTest {
    @AfterEach
    void takeTheInterruptBack() {
        Thread.interrupted();
    }

    @Test
    void anInterruptOnceSeenStaysSeenWhoeverTakesItBack() {
        BooleanSupplier cancelled = Cancellation.of(() -> false);
        assertFalse(cancelled.getAsBoolean());
        Thread.currentThread().interrupt();
        assertTrue(cancelled.getAsBoolean());
        assertTrue(Thread.interrupted());
        assertTrue(cancelled.getAsBoolean());
        assertFalse(Cancellation.of(() -> false).getAsBoolean(), "another render begins anew");
    }

    @Test
    void theCallersWishIsAskedEachTimeUntilItIsSeenAndStaysSeen() {
        AtomicBoolean wish = new AtomicBoolean();
        BooleanSupplier cancelled = Cancellation.of(wish::get);
        assertFalse(cancelled.getAsBoolean());
        wish.set(true);
        assertTrue(cancelled.getAsBoolean());
        wish.set(false);
        assertTrue(cancelled.getAsBoolean());
    }
}
