package enlightenment.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.FileSystemException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FailureTextTest {
    /** Names have a kind before them that failures do not say. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "store s.db | it is full | store s.db: it is full",
                "store s.db | s.db: it is full | store s.db: it is full",
                "store /a b/s.db | /a b/s.db: it is full | store /a b/s.db: it is full",
                "store /a b/s.db | s.db: it is full | store /a b/s.db: s.db: it is full",
                "store jdbc:x://h/n | jdbc:x://h/n: [BUSY] no: wait | store jdbc:x://h/n: [BUSY] no: wait",
                "store s.db | t.db: it is full | store s.db: t.db: it is full",
                "store s.db | db: it is full | store s.db: db: it is full",
                "store s.db | s.db holds no render | store s.db: s.db holds no render",
                "memory | memory: it is full | memory: it is full",
            })
    void whatFailedIsNamedOnce(String name, String says, String told) {
        assertEquals(told, FailureText.of(name, new IOException(says)));
    }

    @Test
    void aFailureOfAFileIsNamedOnceToo() {
        assertEquals(
                "checkpoint c.journal: it is full",
                FailureText.of("checkpoint c.journal", new FileSystemException("c.journal", null, "it is full")));
    }

    @Test
    void whatNobodyExpectsIsToldWithItsClass() {
        String told = "memory: java.lang.IllegalStateException: a driver's fault";
        assertEquals(told, FailureText.of("memory", new IllegalStateException("a driver's fault")));
        assertEquals("memory: java.io.IOException", FailureText.of("memory", new IOException()));
    }
}
