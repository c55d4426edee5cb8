package enlightenment.listen;

import java.net.Inet6Address;
import java.net.InetAddress;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The bounded set of unauthenticated connections. A new one is always admitted: if there is no place, the oldest connection of the address with the
 * most connections is evicted, so that neither idle connections nor a single address can block others. Not thread-safe.
 *
 * @param <T> type of the connections
 */
public final class Strangers<T> {
    private final int limit;
    private final int limitOfAddress;

    /** Address of each connection, the oldest connection first. */
    private final Map<T, String> places = new LinkedHashMap<>();

    private final Map<String, Integer> counts = new HashMap<>();

    public Strangers(int limit, int limitOfAddress) {
        this.limit = limit;
        this.limitOfAddress = limitOfAddress;
    }

    /**
     * The number of places: at most a quarter of the file descriptors of the process. The others serve authenticated connections and files.
     *
     * @param wanted the number of places with enough descriptors
     * @param descriptors the limit of file descriptors of the process; 0 if unknown
     */
    public static int places(int wanted, long descriptors) {
        return descriptors <= 0 ? wanted : (int) Math.max(Math.min(wanted, descriptors / 4), 1);
    }

    /** The identity of an address: of IPv6 the /64 prefix, the usual size of a customer's network. */
    public static String addressOf(InetAddress address) {
        return address instanceof Inet6Address
                ? HexFormat.of().formatHex(address.getAddress(), 0, 8)
                : address.getHostAddress();
    }

    /** Adds a connection and returns those evicted for it. */
    public List<T> add(T who, String address) {
        List<T> gone = new ArrayList<>();
        if (counts.getOrDefault(address, 0) >= limitOfAddress) {
            gone.add(oldestOf(address));
        } else if (places.size() >= limit) {
            gone.add(oldest());
        }
        gone.forEach(this::remove);
        places.put(who, address);
        counts.merge(address, 1, Integer::sum);
        return gone;
    }

    /** The next connection to be evicted; null if there is none. */
    public T oldest() {
        String crowded = null;
        int count = 0;
        for (String address : places.values()) {
            if (counts.get(address) > count) {
                crowded = address;
                count = counts.get(address);
            }
        }
        return crowded == null ? null : oldestOf(crowded);
    }

    private T oldestOf(String address) {
        for (Map.Entry<T, String> place : places.entrySet()) {
            if (place.getValue().equals(address)) {
                return place.getKey();
            }
        }
        throw new IllegalStateException("an address with places has an oldest one");
    }

    /** Removes a connection, if it is present. */
    public void remove(T who) {
        String address = places.remove(who);
        if (address != null) {
            counts.computeIfPresent(address, (a, n) -> n == 1 ? null : n - 1);
        }
    }

    public boolean contains(T who) {
        return places.containsKey(who);
    }

    int size() {
        return places.size();
    }

    public List<T> list() {
        return List.copyOf(places.keySet());
    }
}
