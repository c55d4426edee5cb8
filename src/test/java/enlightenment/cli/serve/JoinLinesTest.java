package enlightenment.cli.serve;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

class JoinLinesTest {
    private static final String LAUNCHER = "java -jar app.jar";
    private static final String JOIN = "workers join with: java -jar app.jar worker ";

    @Test
    void theAddressThatWasGivenIsNamed() throws IOException {
        assertEquals(List.of(JOIN + "127.0.0.1:6002"), JoinLines.of(LAUNCHER, "127.0.0.1", 6002, null, ""));
        assertEquals(List.of(JOIN + "[::1]:70"), JoinLines.of(LAUNCHER, "::1", 70, null, ""));
    }

    @Test
    void tokenAndPinComeAlongAndShellsReadThemAsOneWord() throws IOException {
        assertEquals(
                List.of(JOIN + "127.0.0.1:1 --token-file '/it'\\''s here/token' --pin 00ff"),
                JoinLines.of(LAUNCHER, "127.0.0.1", 1, Path.of("/it's here/token"), "00ff"));
    }

    private static boolean isUp(NetworkInterface card) {
        try {
            return card.isUp();
        } catch (SocketException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Test
    void insteadOfEveryAddressOneOfTheMachinesOwnIsNamed() throws IOException {
        List<String> lines = JoinLines.of(LAUNCHER, "0.0.0.0", 6002, null, "");
        String place = lines.get(0).substring(JOIN.length());
        String host = place.substring(0, place.lastIndexOf(':')).replaceAll("[\\[\\]]", "");
        boolean hasNetwork = NetworkInterface.networkInterfaces()
                .filter(JoinLinesTest::isUp)
                .flatMap(NetworkInterface::inetAddresses)
                .anyMatch(a -> !a.isLoopbackAddress() && !a.isLinkLocalAddress());
        if (hasNetwork) {
            InetAddress named = InetAddress.getByName(host);
            assertFalse(named.isAnyLocalAddress() || named.isLoopbackAddress(), place);
            assertTrue(NetworkInterface.getByInetAddress(named) != null, place);
        } else {
            assertEquals("0.0.0.0", host);
        }
    }
}
