package enlightenment.net.worker;

import enlightenment.file.ContentHash;
import java.io.IOException;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Collections;
import java.util.HexFormat;
import java.util.TreeSet;

/** What tells this machine from others: a name for people, and a secret of its processes. */
public final class MachineIdentity {
    /** That of a host on the network has no more; the number of a process has room behind it. */
    private static final int LONGEST_NAME = 63;

    /** Between the name of a machine, which has none of these, and the number of a process. */
    private static final String PROCESS = "#";

    private MachineIdentity() {}

    /** For people: the machine's name with the number of this process, which tells workers of one machine apart. */
    public static String workerName() {
        return name() + PROCESS + ProcessHandle.current().pid();
    }

    /** The machine's part of a worker's name. */
    public static String machineOf(String workerName) {
        int end = workerName.lastIndexOf(PROCESS);
        return end < 0 ? workerName : workerName.substring(0, end);
    }

    /** For people; asks no network. */
    public static String name() {
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
        return name.length() > LONGEST_NAME ? name.substring(0, LONGEST_NAME) : name;
    }

    /**
     * A number that all processes of a machine share and no other machine has: a hash of facts that are known on the machine alone. It is
     * never sent as it is.
     */
    public static byte[] secret() {
        StringBuilder all = new StringBuilder(name());
        all.append(cards());
        String id = firstOf("/etc/machine-id", "/var/lib/dbus/machine-id");
        // Containers often have no number of their own: then what the system drew when it was started has to do.
        all.append(id.isEmpty() ? firstOf("/proc/sys/kernel/random/boot_id") : id);
        if (id.isEmpty()) {
            for (String property : new String[] {"user.home", "java.home"}) {
                all.append(birth(Path.of(System.getProperty(property, ""))));
            }
        }
        return ContentHash.of(all.toString().getBytes(StandardCharsets.UTF_8)).toBytes();
    }

    private static String firstOf(String... files) {
        for (String file : files) {
            try {
                String text = Files.readString(Path.of(file)).strip();
                if (!text.isEmpty()) {
                    return text;
                }
            } catch (IOException | RuntimeException e) {
                continue;
            }
        }
        return "";
    }

    /** When a folder was made, to the nanosecond; nothing where only its last change is known, which does not stay. */
    private static String birth(Path folder) {
        try {
            BasicFileAttributes of = Files.readAttributes(folder, BasicFileAttributes.class);
            return of.creationTime().equals(of.lastModifiedTime())
                    ? ""
                    : of.creationTime().toInstant().toString();
        } catch (IOException | RuntimeException e) {
            return "";
        }
    }

    private static String cards() {
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
        return cards.toString();
    }
}
