package starlogo
{
    /**
     * What the engine's packages share among themselves and a client has no use for: caches on an agent, and the
     * like. Not part of the public contract.
     *
     * @private
     */
    public namespace engine = "starlogo.engine";
}
