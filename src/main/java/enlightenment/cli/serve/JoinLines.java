package enlightenment.cli.serve;

import enlightenment.cli.terminal.Shell;
import java.io.IOException;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** Lines that say how workers join, ready to be copied. */
final class JoinLines {
    private JoinLines() {}

    /**
     * A command for workers, and under which other addresses this machine is known. A server that listens at every address is
     * called by the machine's first.
     *
     * @param launcher how this program is called
     * @param token the server's file, or null for none
     * @param pin empty for none
     */
    static List<String> of(String launcher, String host, int port, Path token, String pin) throws IOException {
        List<String> names = new ArrayList<>();
        if (InetAddress.getByName(host).isAnyLocalAddress()) {
            names.addAll(addresses());
        }
        if (names.isEmpty()) {
            names.add(host);
        }
        List<String> lines = new ArrayList<>();
        lines.add("workers join with: " + launcher + " worker " + place(names.get(0), port)
                + (token == null ? "" : " --token-file " + Shell.quoted(token.toString()))
                + (pin.isEmpty() ? "" : " --pin " + pin));
        if (names.size() > 1) {
            lines.add("this machine is also " + String.join(", ", names.subList(1, names.size())));
        }
        return lines;
    }

    private static String place(String host, int port) {
        return (host.indexOf(':') < 0 ? host : "[" + host + "]") + ":" + port;
    }

    /** This machine's addresses, IPv4 first; asks no network. */
    private static List<String> addresses() {
        List<String> four = new ArrayList<>();
        List<String> six = new ArrayList<>();
        try {
            List<NetworkInterface> cards = Collections.list(NetworkInterface.getNetworkInterfaces());
            cards.sort((a, b) -> Integer.compare(a.getIndex(), b.getIndex()));
            for (NetworkInterface card : cards) {
                if (!card.isUp()) {
                    continue;
                }
                for (InetAddress address : Collections.list(card.getInetAddresses())) {
                    if (!address.isLoopbackAddress() && !address.isLinkLocalAddress()) {
                        (address instanceof Inet4Address ? four : six)
                                .add(address.getHostAddress().replaceFirst("%.*", ""));
                    }
                }
            }
        } catch (SocketException e) {
            // Then the address that was given has to do.
            return List.of();
        }
        four.addAll(six);
        return four;
    }
}
