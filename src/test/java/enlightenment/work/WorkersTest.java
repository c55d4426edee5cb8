package enlightenment.work;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import java.util.function.IntConsumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

@Timeout(600)
class WorkersTest {
    private static final int COUNT = 1000;

    static Stream<Throwable> failures() {
        return Stream.of(
                new IllegalStateException("of a program"),
                new CancellationException("of a program"),
                new StackOverflowError("of a program"),
                new IOException("of a program in Kotlin"));
    }

    @SuppressWarnings("unchecked")
    private static <T extends Throwable> void sneak(Throwable t) throws T {
        throw (T) t;
    }

    private static void run(int threads, BooleanSupplier cancelled, IntConsumer piece) {
        Workers.run(threads, COUNT, cancelled, () -> piece);
    }

    @Test
    void eachPieceIsDoneOnce() {
        for (int threads : new int[] {1, 3, 2 * COUNT}) {
            Set<Integer> done = ConcurrentHashMap.newKeySet();
            run(threads, () -> false, i -> assertTrue(done.add(i)));
            assertEquals(COUNT, done.size());
        }
    }

    /** Piece 5 is taken by any of the threads, the caller's or a helper. */
    @ParameterizedTest
    @MethodSource("failures")
    void whatAPieceThrowsIsThrownOnByWhicheverThreadItIsThrown(Throwable failure) {
        for (int threads = 1; threads <= 3; threads++) {
            int n = threads;
            Throwable thrown = assertThrows(
                    Throwable.class,
                    () -> run(n, () -> false, i -> {
                        if (i == 5) {
                            WorkersTest.<RuntimeException>sneak(failure);
                        }
                    }));
            assertSame(failure, thrown);
        }
    }

    /** Only helpers throw: the caller's thread waits in its first piece until one has. */
    @ParameterizedTest
    @MethodSource("failures")
    void whatAHelperThrowsIsThrownByTheCaller(Throwable failure) {
        Thread caller = Thread.currentThread();
        AtomicBoolean thrown = new AtomicBoolean();
        Throwable e = assertThrows(
                Throwable.class,
                () -> run(2, () -> false, i -> {
                    if (Thread.currentThread() != caller) {
                        thrown.set(true);
                        WorkersTest.<RuntimeException>sneak(failure);
                    }
                    while (!thrown.get()) {
                        Thread.onSpinWait();
                    }
                }));
        assertSame(failure, e);
    }

    @ParameterizedTest
    @MethodSource("failures")
    void whatTheConditionThrowsIsThrownOn(Throwable failure) {
        Throwable thrown = assertThrows(
                Throwable.class,
                () -> run(
                        2,
                        () -> {
                            WorkersTest.<RuntimeException>sneak(failure);
                            return false;
                        },
                        i -> {}));
        assertSame(failure, thrown);
    }

    @Test
    void aPieceThatGivesUpBecauseItIsCancelledEndsTheWorkQuietly() {
        AtomicBoolean cancelled = new AtomicBoolean();
        run(2, cancelled::get, i -> {
            if (i == 5) {
                cancelled.set(true);
                throw new CancellationException();
            }
        });
        assertTrue(cancelled.get());
    }
}
