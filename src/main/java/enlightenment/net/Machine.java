package enlightenment.net;

import java.io.IOException;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.HexFormat;
import java.util.TreeSet;

/** What this machine is called. */
final class Machine {
    private Machine() {}

    /** For people; asks no network. */
    static String name() {
        for (String variable : new String[] {"HOSTNAME", "COMPUTERNAME"}) {
            String name = System.getenv(variable);
            if (name != null && !name.isBlank()) {
                return cut(name);
            }
        }
        try {
            return cut(Files.readString(Path.of("/etc/hostname")).strip());
        } catch (IOException | RuntimeException e) {
            return "worker";
        }
    }

    private static String cut(String name) {
        return name.length() > 100 ? name.substring(0, 100) : name;
    }

    /** The same for all processes of a machine, and hardly that of another: its name and its network cards. */
    static String identity() {
        TreeSet<String> cards = new TreeSet<>();
        try {
            for (NetworkInterface card : Collections.list(NetworkInterface.getNetworkInterfaces())) {
                byte[] address = card.getHardwareAddress();
                if (address != null) {
                    cards.add(HexFormat.of().formatHex(address));
                }
            }
        } catch (SocketException e) {
            cards.add("unknown");
        }
        String hash = ContentHash.of(cards.toString().getBytes(java.nio.charset.StandardCharsets.UTF_8))
                .toString();
        return name() + "-" + hash.substring(0, 16);
    }
}
