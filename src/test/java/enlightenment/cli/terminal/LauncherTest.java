package enlightenment.cli.terminal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.File;
import org.junit.jupiter.api.Test;

class LauncherTest {
    @Test
    void theLauncherIsCalledAsTheUserCalledIt() {
        assertEquals("enlightenment", Launcher.command("enlightenment", "/opt/lib/enlightenment.jar"));
        assertEquals("'/my apps/bin/enlightenment'", Launcher.command("/my apps/bin/enlightenment", "x.jar"));
    }

    @Test
    void withoutTheLauncherTheJarIsNamedAsItWasStarted() {
        assertEquals("java -jar target/enlightenment.jar", Launcher.command(null, "target/enlightenment.jar"));
        assertEquals("java -jar 'it'\\''s here/e.jar'", Launcher.command("", "it's here/e.jar"));
    }

    @Test
    void classesThatAreInNoSingleJarAreStartedByTheNameOfTheProgram() {
        assertEquals("enlightenment", Launcher.command(null, "target/classes"));
        assertEquals("enlightenment", Launcher.command(null, "a.jar" + File.pathSeparator + "b.jar"));
    }
}
