package starlogo.search
{
    import flash.errors.IllegalOperationError;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.broadphase.Bins;
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * What makes one collider differ from another: which shape represents an agent's model, and which pairs of rows touch. All the rest is in
     * CollisionSearch.
     *
     * @private
     */
    public class ShapeStrategy
    {
        /** Takes the numbers of tests of the search under way. */
        public var counts:SearchCounts = new SearchCounts();

        /** For subclasses only. */
        public function ShapeStrategy()
        {
        }

        /** Whether it looks at the agents' models, so that there have to be some. */
        public function get needsModels():Boolean
        {
            return true;
        }

        /** Which shape represents an agent's model: a kind of BoundingStructure, Agent.ANY_KIND or ModelShape.HIERARCHY. */
        public function kindOf(agent:Agent):int
        {
            return Agent.ANY_KIND;
        }

        /**
         * Finds the shape that represents a model.
         *
         * @param shape takes it; has the model's name and the kind
         * @param agent has the model, which was added to the GreatLand
         * @throws ArgumentError if what is needed was not loaded
         */
        public function bind(shape:ModelShape, agent:Agent):void
        {
            throw new IllegalOperationError(this + " does not implement bind");
        }

        /** A structure that decides alone as a box, for strategies that test boxes themselves; else null. */
        public function boxOf(structure:BoundingStructure):Box
        {
            return null;
        }

        /**
         * Finds the extents of the shape of an agent, turned and scaled as the agent is, relative to its position.
         *
         * @param out takes x, y, z of the middle, as seen from the agent's position, and half the lengths along x, y, z
         */
        public function findExtents(shape:ModelShape, agent:Agent, out:Vector.<Number>):void
        {
            shape.structure.turnedExtentsInto(agent.worldPlacement(), out);
        }

        /**
         * Moves those candidates of a member that touch it to the beginning: those whose extents overlap its own and of which areTouching says so.
         *
         * @param slot of the member
         * @param others the first of them are the slots of the candidates, whose circles on the ground overlap its own
         * @return how many it touches
         */
        public function keepTouching(table:AgentTable, bins:Bins, slot:int, others:Vector.<int>, count:int):int
        {
            var rowAt:Vector.<int> = bins.rowAt;
            var row:int = rowAt[slot];
            var kept:int = 0;
            count = keepNear(table.extents, bins, slot, others, count);
            for (var i:int = 0; i < count; i++)
            {
                if (areTouching(table, row, rowAt[others[i]]))
                {
                    others[kept] = others[i];
                    kept++;
                }
            }
            return kept;
        }

        /** Moves those candidates of a member whose extents overlap its own, or nearly so, to the beginning; returns how many these are. */
        protected static function keepNear(extents:Extents, bins:Bins, slot:int, others:Vector.<int>, count:int):int
        {
            var xs:Vector.<Number> = extents.x;
            var ys:Vector.<Number> = extents.y;
            var zs:Vector.<Number> = extents.z;
            var halfXs:Vector.<Number> = extents.halfX;
            var halfYs:Vector.<Number> = extents.halfY;
            var halfZs:Vector.<Number> = extents.halfZ;
            var rowAt:Vector.<int> = bins.rowAt;
            var slack:Number = bins.slack;
            var row:int = rowAt[slot];
            var atX:Number = xs[row];
            var atY:Number = ys[row];
            var atZ:Number = zs[row];
            var reachX:Number = halfXs[row] + slack;
            var reachY:Number = halfYs[row] + slack;
            var reachZ:Number = halfZs[row] + slack;
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                var otherRow:int = rowAt[other];
                // the heights first, because the circles on the ground overlap
                var distance:Number = zs[otherRow] - atZ;
                var reach:Number = reachZ + halfZs[otherRow];
                if (distance > reach)
                {
                    continue;
                }
                if (distance < -reach)
                {
                    continue;
                }
                distance = xs[otherRow] - atX;
                reach = reachX + halfXs[otherRow];
                if (distance > reach)
                {
                    continue;
                }
                if (distance < -reach)
                {
                    continue;
                }
                distance = ys[otherRow] - atY;
                reach = reachY + halfYs[otherRow];
                if (distance > reach)
                {
                    continue;
                }
                if (distance < -reach)
                {
                    continue;
                }
                others[kept] = other;
                kept++;
            }
            return kept;
        }

        /** Whether two rows touch. */
        public function areTouching(table:AgentTable, a:int, b:int):Boolean
        {
            throw new IllegalOperationError(this + " does not implement areTouching");
        }

        /**
         * Finds when two rows, not both spheres, touch for the first time as one moves: the first moment at which <code>areTouching()</code> would
         * say so.
         *
         * @param motion of the first, which ends where it is now, relative to the second; takes the time, from 0 to 1, or RelativeMotion.NEVER
         */
        public function findTime(table:AgentTable, a:int, b:int, motion:RelativeMotion):void
        {
            throw new IllegalOperationError(this + " does not implement findTime");
        }

        /**
         * How two rows touch.
         *
         * @param motion as in findTime, with the time when they do first
         * @param out takes it, the normal pointing from b to a, with b where it is now
         */
        public function findContact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            throw new IllegalOperationError(this + " does not implement findContact");
        }

        /**
         * When and how two rows, not both spheres, touch for the first time that do not touch at the beginning.
         *
         * @param motion as in findTime; but what rounding hides at its end may be left out
         * @param out takes how, as in findContact
         */
        public function findImpact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            findTime(table, a, b, motion);
            if (motion.time != RelativeMotion.NEVER)
            {
                findContact(table, a, b, motion, out);
            }
        }

        /**
         * How the structures around two rows overlap, where they are.
         *
         * @param out takes it, the normal pointing from b to a
         */
        public function findOuterContact(table:AgentTable, a:int, b:int, out:ContactPoint):void
        {
            RelativeMotion.NONE.time = 0;
            findContact(table, a, b, RelativeMotion.NONE, out);
        }

        /**
         * Whether the contact of two rows that are not both spheres is exact: moved by its depth they just touch. Otherwise it is that of parts of
         * the two, and others may still overlap.
         */
        public function hasExactContact(table:AgentTable, a:int, b:int):Boolean
        {
            return false;
        }

        /**
         * Whether triangles are left out, and the leaves of hierarchies decide for them: all that triangles find, leaves find too, and in a
         * tenth of the time.
         */
        public function set leavesDecide(value:Boolean):void
        {
        }

        /** How many levels are visited of a row's hierarchy. */
        public function depthOf(table:AgentTable, row:int):int
        {
            throw new IllegalOperationError(this + " has no hierarchies");
        }

        /** Whether triangles decide between two hierarchies. */
        public function get isExact():Boolean
        {
            return false;
        }

        /** Whether two boxes may be found to touch that are apart, because only their faces are tested. */
        public function get touchesAcrossGaps():Boolean
        {
            return false;
        }

        /** Begins to count the tests of a search. */
        public function resetCounts():void
        {
            counts.reset();
        }

        /** Completes the counts of a search. */
        public function finishCounts():void
        {
        }

        /** Whether the extents of two rows overlap, or nearly so; the heights first, because the circles on the ground do. */
        public static function areNear(extents:Extents, bins:Bins, a:int, b:int):Boolean
        {
            var slack:Number = bins.slack;
            var distance:Number = extents.z[a] - extents.z[b];
            var reach:Number = extents.halfZ[a] + extents.halfZ[b] + slack;
            if (distance > reach || distance < -reach)
            {
                return false;
            }
            distance = extents.x[a] - extents.x[b];
            reach = extents.halfX[a] + extents.halfX[b] + slack;
            if (distance > reach || distance < -reach)
            {
                return false;
            }
            distance = extents.y[a] - extents.y[b];
            reach = extents.halfY[a] + extents.halfY[b] + slack;
            return distance <= reach && distance >= -reach;
        }

        /** Whether two rows that are spheres, as wide as their extents, touch. */
        internal static function areSpheresTouching(table:AgentTable, a:int, b:int):Boolean
        {
            var extents:Extents = table.extents;
            var x:Number = extents.x[a] - extents.x[b];
            var y:Number = extents.y[a] - extents.y[b];
            var z:Number = extents.z[a] - extents.z[b];
            var squared:Number = x * x + y * y + z * z;
            var reach:Number = extents.halfX[a] + extents.halfX[b];
            if (squared <= reach * reach)
            {
                return true;
            }
            reach = reach * Tolerances.TOUCHING + Tolerances.PLACES * (Math.abs(table.x[a]) + Math.abs(table.y[a]) + Math.abs(table.z[a])
                    + (Math.abs(table.x[b]) + Math.abs(table.y[b]) + Math.abs(table.z[b])));
            return squared <= reach * reach;
        }
    }
}
