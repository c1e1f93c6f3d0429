package starlogo.collision.snapshots
{
    import flash.utils.ByteArray;
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    /**
     * Writes and reads the traits of agents, to the last bit.
     *
     * @private
     */
    internal final class SnapshotTraits
    {
        private static const SWEEPS:int = 1;
        private static const HIERARCHICAL:int = 2;
        private static const ONE_WAY:int = 4;

        /** Writes the traits of all agents. */
        public static function write(bytes:ByteArray, agents:Vector.<Agent>, names:SnapshotNames):void
        {
            for (var i:int = 0; i < agents.length; i++)
            {
                var agent:Agent = agents[i];
                bytes.writeInt(names.ofModel(agent.modelNumber));
                bytes.writeInt(names.ofBreed(agent.breedNumber));
                bytes.writeByte(int(agent.sweeps) * SWEEPS + int(agent.hierarchical) * HIERARCHICAL + int(agent.isOneWay) * ONE_WAY);
                // ANY_KIND is -1
                bytes.writeByte(agent.structureKind + 1);
                bytes.writeInt(agent.traversalDepth);
                bytes.writeDouble(agent.x);
                bytes.writeDouble(agent.y);
                bytes.writeDouble(agent.z);
                bytes.writeDouble(agent.size);
                bytes.writeDouble(agent.color);
                agent.turn.write(bytes);
            }
        }

        /**
         * Gives agents the traits that were written.
         *
         * @throws Error if the bytes are no traits. Some agents may then have changed
         */
        public static function restore(bytes:ByteArray, agents:Vector.<Agent>, names:SnapshotNames):void
        {
            for (var i:int = 0; i < agents.length; i++)
            {
                var agent:Agent = agents[i];
                agent.shape = names.nameAt(bytes.readUnsignedInt());
                agent.breed = names.nameAt(bytes.readUnsignedInt());
                var flags:int = bytes.readUnsignedByte();
                var kind:int = bytes.readUnsignedByte();
                if (flags > (SWEEPS | HIERARCHICAL | ONE_WAY) || kind > Agent.STRUCTURE_NAMES.length)
                {
                    throw new RangeError("a flag of " + agent + " is unknown");
                }
                agent.sweeps = (flags & SWEEPS) != 0;
                agent.hierarchical = (flags & HIERARCHICAL) != 0;
                agent.isOneWay = (flags & ONE_WAY) != 0;
                agent.collideAs = kind == 0 ? Agent.TIGHTEST : Agent.STRUCTURE_NAMES[kind - 1];
                agent.traversalDepth = bytes.readInt();
                agent.moveTo(bytes.readDouble(), bytes.readDouble(), bytes.readDouble());
                agent.size = bytes.readDouble();
                agent.color = bytes.readDouble();
                agent.turn.read(bytes, agent);
            }
        }
    }
}
