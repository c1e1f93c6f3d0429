import type { GreatLand, Model } from "starlogo-collision";

/** The collision systems: each is one of the engine's colliders. */
export type NovaSystem = "bins" | "tightest" | "hierarchical" | "combination";

/** Traits that the client has no blocks for. Traits that are left out keep their defaults. */
export interface NovaTraits {
    /** For "combination": uses a tree of boxes instead of the tightest structure. */
    hierarchical?: boolean;
    /** The number of levels of its tree that are tested; with 0 the options decide. */
    depth?: number;
    /** Whether it collides along its whole way from one tick to the next. */
    sweeps?: boolean;
    /** The structure that stands for it when no tree is used. */
    structure?: "tightest" | "sphere" | "box" | "capsule" | "hull";
}

/** Options for the engine in the client. */
export interface NovaOptions {
    /**
     * The default is "bins", the client's own rule: two agents collide if they are nearer than half the sum of their sizes. A size of 0 is
     * a point. With the other systems the drawn shapes collide, and touching counts as colliding. An agent of size 0 then takes no part.
     */
    system?: NovaSystem;
    /** For "hierarchical" and "combination": whether triangles decide. */
    exact?: boolean;
    /** For "hierarchical" and "combination": the number of levels of a tree that are tested. The default is 5. */
    depth?: number;
    /**
     * Whether agents sweep, unless their traits say otherwise. With "bins", an agent that has moved also collides if its way ends where it just
     * touches another.
     */
    sweeps?: boolean;
    /** Traits by the name of a breed. */
    breeds?: Record<string, NovaTraits>;
    /**
     * Models to use instead of the client's, by the shape of an agent: a model, an address, null for the sphere, or undefined for the
     * client's own. Read once, at installation: exchange() refuses others.
     */
    shapes?: Record<string, Model | string | null> | ((shape: string) => Model | string | null | undefined);
    /**
     * Whether the client's view shows a wireframe of the colliding shapes: spheres, tightest fits, the boxes of the deepest tested level,
     * or triangles. Agents that the last tick found to collide are red. In three dimensions the wireframe moves as the client draws between
     * two ticks.
     */
    overlay?: boolean;
    /** The address of the list that `starlogo-cook --scaling volume --transforms` has made. Read once, at installation: exchange() refuses another. */
    manifest?: string | null;
}

/** An agent of the client. The engine also reads properties that are not declared here. */
export interface NovaAgent {
    readonly id: number;
}

/** An installation of the engine in a client. */
export interface NovaInstallation {
    /** Whether it is still installed. */
    readonly isInstalled: boolean;
    /** The options in use, including defaults. */
    readonly options: NovaOptions;
    /** The models, by the client's shapes. */
    readonly greatLand: GreatLand;
    /** The number of models that are still loading. Until then, their agents are spheres that stand on their places. */
    readonly pendingCount: number;
    /** The models that could not be loaded, and why. */
    readonly problems: readonly string[];
    /**
     * Changes options from the next tick on. Options that are not named stay. With another system, the ways of what sweeps begin anew.
     *
     * @throws RangeError if an option is not possible; nothing has changed then
     * @throws ArgumentError if there is no such option; nothing has changed then
     * @throws TypeError if an overlay is wanted, and there is no view for it
     */
    exchange(options: NovaOptions): void;
    /** Shows or hides the wireframe, like the option `overlay`. */
    showOverlay(isOn?: boolean): void;
    /**
     * Sets the traits of a breed, by its name, or of an agent. They replace all traits set before. An agent's own traits override its
     * breed's.
     *
     * @param whose a breed's name, or an agent
     * @param traits null for none
     * @throws RangeError if a trait is not possible; nothing has changed then
     */
    setTraits(whose: string | NovaAgent, traits: NovaTraits | null): void;
    /**
     * Sets some of an agent's traits, as its blocks do. Its other traits stay. Agents of its breed that it makes inherit them.
     *
     * @throws RangeError if a trait is not possible; nothing has changed then
     */
    changeTraits(agent: NovaAgent, traits: NovaTraits): void;
    /** Whether two agents touch now, even if their breeds have no blocks. */
    areColliding(a: NovaAgent, b: NovaAgent): boolean;
    /** Gives the client its own collisions back, with all agents in its bins. A second call does nothing. */
    uninstall(): void;
}

/**
 * Replaces the collisions of the StarLogo Nova client in a window with the engine's. An earlier installation is uninstalled first. You may
 * call it at any time, also while a project runs.
 *
 * @param window has the client's Execution and Common
 * @param options see NovaOptions
 * @throws TypeError if no client is in the window
 * @throws RangeError if an option is not possible; the earlier installation stays then
 * @throws ArgumentError if there is no such option; the earlier installation stays then
 * @throws TypeError if an overlay is wanted, and there is no view for it; the earlier installation stays then
 */
export function installInto(window: object, options?: NovaOptions): NovaInstallation;

/**
 * Adds a button to the client's toolbar. Its menu chooses the collision system, and whether the wireframe is shown. Nothing is installed
 * before a choice.
 *
 * @param window has the client, and its page
 * @param options for the later installation, without the system
 * @throws TypeError if no client with a toolbar is in the window
 */
export function addButton(window: object, options?: NovaOptions): {
    /** Removes the button. The installed engine stays. */
    remove(): void;
};

/**
 * Adds blocks for traits to the drawer of the client's editor that has its collision block: hierarchical, depth, sweeping, structure. An
 * agent's program sets its own traits. Without an installation the blocks do nothing. A client without these blocks cannot compile a
 * project that uses them.
 *
 * @throws TypeError if the window has no such editor
 */
export function addBlocks(window: object): {
    /** Removes them from the drawer. Blocks in programs stay. */
    remove(): void;
};

/**
 * For a bookmarklet. The first call installs the engine, if it is not installed, and adds the button and, if there is an editor, the
 * blocks. The next call removes them all.
 *
 * @throws TypeError if no client with a toolbar is in the window
 */
export function toggle(window: object, options?: NovaOptions): void;
