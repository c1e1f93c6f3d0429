package starlogo.collision.snapshots
{
    import flash.utils.ByteArray;
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.isInWorld;

    use namespace engine;

    /**
     * Writes and reads the traits of agents, to the last bit. It calls no getter, setter or method that a game's subclass of Agent may override.
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
                bytes.writeInt(names.numberOf(Agent.MODEL_NAMES.nameOf(agent.modelNumber)));
                bytes.writeInt(names.numberOf(Breeds.NAMES.nameOf(agent.breedNumber)));
                bytes.writeByte(int(agent.isSweeping) * SWEEPS + int(agent.isHierarchical) * HIERARCHICAL + int(agent.isOneWay) * ONE_WAY);
                // ANY_KIND is -1
                bytes.writeByte(agent.structureKind + 1);
                bytes.writeInt(agent.depthLimit);
                bytes.writeDouble(agent.placement.x);
                bytes.writeDouble(agent.placement.y);
                bytes.writeDouble(agent.placement.z);
                bytes.writeDouble(agent.placement.size);
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
                var at:Placement = agent.placement;
                var model:int = Agent.MODEL_NAMES.numberOf(names.nameAt(bytes.readUnsignedInt()));
                var breed:int = Breeds.NAMES.numberOf(names.nameAt(bytes.readUnsignedInt()));
                var flags:int = bytes.readUnsignedByte();
                var isSweeping:Boolean = (flags & SWEEPS) != 0;
                var isHierarchical:Boolean = (flags & HIERARCHICAL) != 0;
                var kind:int = bytes.readUnsignedByte() - 1;
                var depth:int = bytes.readInt();
                var x:Number = bytes.readDouble();
                var y:Number = bytes.readDouble();
                var z:Number = bytes.readDouble();
                var size:Number = bytes.readDouble();
                if (breed <= Breeds.ANY_NUMBER || flags > (SWEEPS | HIERARCHICAL | ONE_WAY) || kind >= Agent.STRUCTURE_NAMES.length || depth < 0
                        || !isInWorld(x, y, z) || !Agent.isSize(size))
                {
                    throw new RangeError("a trait has a value that is not allowed");
                }
                if (x != at.x || y != at.y || z != at.z || size != at.size || model != agent.modelNumber || breed != agent.breedNumber
                        || isSweeping != agent.isSweeping || isHierarchical != agent.isHierarchical || kind != agent.structureKind || depth != agent.depthLimit)
                {
                    agent.countBodyChange();
                }
                if (breed != agent.breedNumber)
                {
                    Breeds.countChange();
                }
                agent.modelNumber = model;
                agent.breedNumber = breed;
                agent.isSweeping = isSweeping;
                agent.isHierarchical = isHierarchical;
                agent.isOneWay = (flags & ONE_WAY) != 0;
                agent.structureKind = kind;
                agent.depthLimit = depth;
                at.x = x;
                at.y = y;
                at.z = z;
                at.size = size;
                agent.color = bytes.readDouble();
                agent.turn.read(bytes, agent);
            }
        }
    }
}
