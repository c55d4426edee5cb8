package enlightenment.store;

import java.util.Optional;
import java.util.Properties;

/**
 * The login that opens a store.
 *
 * @param user the user's name; empty for the driver's default
 * @param password the password; empty for none
 */
public record StoreLogin(Optional<String> user, Optional<String> password) {
    /** A login without user and password. */
    public static final StoreLogin NONE = new StoreLogin(Optional.empty(), Optional.empty());

    Properties properties() {
        Properties properties = new Properties();
        user.ifPresent(u -> properties.setProperty("user", u));
        password.ifPresent(p -> properties.setProperty("password", p));
        return properties;
    }

    @Override
    public String toString() {
        return "StoreLogin[" + user.orElse("no user") + "]";
    }
}
