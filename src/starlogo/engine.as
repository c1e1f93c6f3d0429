package starlogo
{
    /**
     * The namespace of members that the engine's packages share, for example caches on an agent. Clients have no use for them, and they may
     * change at any time.
     *
     * @private
     */
    public namespace engine = "starlogo.engine";
}
