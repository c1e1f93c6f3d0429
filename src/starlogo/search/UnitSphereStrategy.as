package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.broadphase.Bins;
    import starlogo.engine;

    use namespace engine;

    /**
     * Every agent is a sphere of its size, whatever its model (thesis §2.2).
     *
     * @private
     */
    public final class UnitSphereStrategy extends ShapeStrategy
    {
        /** Without settings. */
        public function UnitSphereStrategy()
        {
        }

        /** @inheritDoc */
        override public function get needsModels():Boolean
        {
            return false;
        }

        /** @inheritDoc */
        override public function bind(shape:ModelShape, agent:Agent):void
        {
            shape.isSphere = true;
        }

        /** @inheritDoc */
        override public function findExtents(shape:ModelShape, agent:Agent, out:Vector.<Number>):void
        {
            out[0] = out[1] = 0;
            out[2] = out[3] = out[4] = out[5] = 0.5 * agent.placement.size;
        }

        /** @inheritDoc */
        override public function keepTouching(table:AgentTable, bins:Bins, slot:int, others:Vector.<int>, count:int):int
        {
            var xs:Vector.<Number> = bins.x;
            var ys:Vector.<Number> = bins.y;
            var zs:Vector.<Number> = bins.z;
            var radii:Vector.<Number> = bins.radius;
            var atX:Number = xs[slot];
            var atY:Number = ys[slot];
            var atZ:Number = zs[slot];
            var radius:Number = radii[slot];
            var slack:Number = bins.slack;
            var kept:int = 0;
            counts.tests[0] += count;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                var x:Number = xs[other] - atX;
                var y:Number = ys[other] - atY;
                var z:Number = zs[other] - atZ;
                var reach:Number = radius + radii[other];
                var squared:Number = x * x + y * y + z * z;
                if (squared > reach * reach)
                {
                    // farther apart than rounding comes to, or to be tested exactly
                    reach += slack;
                    if (squared > reach * reach)
                    {
                        continue;
                    }
                    if (!areSpheresTouching(table, bins.rowAt[slot], bins.rowAt[other]))
                    {
                        continue;
                    }
                }
                others[kept] = other;
                kept++;
            }
            return kept;
        }

        /** @inheritDoc */
        override public function areTouching(table:AgentTable, a:int, b:int):Boolean
        {
            counts.tests[0]++;
            return areSpheresTouching(table, a, b);
        }
    }
}
