package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;
    import starlogo.broadphase.Bins;
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.PointPoint;
    import starlogo.intersection.boxBox;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * Answers for two rows of a table by their forms: whether they touch, when, and how. Each collider has one, with its settings.
     *
     * <p>Spheres are as wide as their extents and need no structure in the world.</p>
     *
     * @private
     */
    public final class RowPairs
    {
        /** How many pairs were tested along their motions since <code>resetCounts()</code>. */
        public var sweptPairs:int = 0;

        /** Answers for pairs of structures that are not both spheres; counts the tests of those too. */
        public var structures:StructurePairs = new StructurePairs();

        /** Answers for pairs of which at least one is a tree; null if the choice of shapes has no trees. */
        public var trees:TreePairs = null;

        /** Answers for pairs of which one is the ground. */
        public var ground:GroundPairs;

        private var _sphereA:Sphere = new Sphere(new Vector3D(), 0);
        private var _sphereB:Sphere = new Sphere(new Vector3D(), 0);
        private var _points:PointPoint = new PointPoint();
        private var _displacement:RelativeMotion = new RelativeMotion();

        /**
         * With the settings that colliders begin with.
         *
         * @param choice gives the rows their shapes
         */
        public function RowPairs(choice:ShapeChoice)
        {
            ground = new GroundPairs(this);
            choice.prepare(this);
        }

        /**
         * Moves those candidates of a member that touch it to the beginning. All rows are spheres.
         *
         * @param slot of the member
         * @param others the first of them are the slots of the candidates, whose circles on the ground overlap its own
         * @return how many it touches
         */
        public function keepTouchingSpheres(table:AgentTable, bins:Bins, slot:int, others:Vector.<int>, count:int):int
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
            structures.tests[0] += count;
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

        /**
         * Moves those candidates of a member that touch it to the beginning.
         *
         * @param slot of the member
         * @param others the first of them are the slots of the candidates, whose circles on the ground overlap its own
         * @return how many it touches
         */
        public function keepTouching(table:AgentTable, bins:Bins, slot:int, others:Vector.<int>, count:int):int
        {
            var forms:Vector.<int> = table.forms;
            var rowAt:Vector.<int> = bins.rowAt;
            var row:int = rowAt[slot];
            var form:int = forms[row];
            if (form == ModelShape.TREE)
            {
                return trees.keepTouching(table, bins, slot, others, count);
            }
            var zs:Vector.<Number> = table.extents.z;
            var halfZs:Vector.<Number> = table.extents.halfZ;
            var boxes:Vector.<Box> = table.boxes;
            var placed:Vector.<int> = table.placedRevisions;
            var revisions:Vector.<int> = table.revisions;
            var atZ:Number = zs[row];
            var reachZ:Number = halfZs[row] + bins.slack;
            var box:Box = structures.boxFacesOnly ? null : boxes[row];
            var boxTests:int = 0;
            var sphereTests:int = 0;
            var kept:int = 0;
            if (box != null && placed[row] != revisions[row])
            {
                table.place(row);
            }
            for (var i:int = 0; i < count; i++)
            {
                // boxes are their own extents but for the heights
                var other:int = others[i];
                var otherRow:int = rowAt[other];
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
                var otherBox:Box = boxes[otherRow];
                if (box != null && otherBox != null)
                {
                    boxTests++;
                    if (placed[otherRow] != revisions[otherRow])
                    {
                        table.place(otherRow);
                    }
                    if (!boxBox(box, otherBox))
                    {
                        continue;
                    }
                }
                else if ((form | forms[otherRow]) == BoundingStructure.SPHERE)
                {
                    // their circles on the ground are as wide as they are
                    sphereTests++;
                    var x:Number = bins.x[other] - bins.x[slot];
                    var y:Number = bins.y[other] - bins.y[slot];
                    reach = bins.radius[other] + bins.radius[slot];
                    if (x * x + y * y + distance * distance > reach * reach && !areSpheresTouching(table, row, otherRow))
                    {
                        continue;
                    }
                }
                else if (!areNear(table.extents, bins, row, otherRow) || !areTouching(table, row, otherRow))
                {
                    continue;
                }
                others[kept] = other;
                kept++;
            }
            structures.tests[BoundingStructure.BOX << 2 | BoundingStructure.BOX] += boxTests;
            structures.tests[0] += sphereTests;
            return kept;
        }

        /** Whether two rows touch. */
        public function areTouching(table:AgentTable, a:int, b:int):Boolean
        {
            var forms:int = table.forms[a] | table.forms[b];
            if (forms >= ModelShape.TREE)
            {
                return forms >= ModelShape.GROUND ? ground.areTouching(table, a, b) : trees.areTouching(table, a, b);
            }
            if (forms == BoundingStructure.SPHERE)
            {
                structures.tests[0]++;
                return areSpheresTouching(table, a, b);
            }
            return structures.areTouching(table, a, b);
        }

        /**
         * Finds when two rows touch for the first time as one moves: the first moment at which <code>areTouching()</code> would say so.
         *
         * @param motion of the first, which ends where it is now, relative to the second; takes the time, from 0 to 1, or RelativeMotion.NEVER
         */
        public function findTime(table:AgentTable, a:int, b:int, motion:RelativeMotion):void
        {
            if (isOneGround(table, a, b))
            {
                ground.findTime(table, a, b, motion);
            }
            else if (isOneTree(table, a, b))
            {
                trees.findTime(table, a, b, motion);
            }
            else if (areSpheres(table, a, b))
            {
                findTimeOfSpheres(table, a, b, motion);
            }
            else
            {
                structures.findTime(table, a, b, motion);
            }
        }

        /**
         * How two rows touch.
         *
         * @param motion as in findTime, with the time when they do first
         * @param out takes it, the normal pointing from b to a, with b where it is now
         */
        public function findContact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            if (isOneGround(table, a, b))
            {
                ground.findContact(table, a, b, motion, out);
            }
            else if (isOneTree(table, a, b))
            {
                trees.findContact(table, a, b, motion, out);
            }
            else if (areSpheres(table, a, b))
            {
                readSphere(table.extents, a, _sphereA);
                readSphere(table.extents, b, _sphereB);
                _displacement.stopAt(motion);
                _points.findContact(_sphereA, _sphereB, _displacement, out);
            }
            else
            {
                structures.findContact(table, a, b, motion, out);
            }
        }

        /**
         * When and how two rows touch for the first time that do not touch at the beginning.
         *
         * @param motion as in findTime; but what rounding hides at its end may be left out
         * @param out takes how, as in findContact; null if only the time is wanted
         */
        public function findImpact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            if (isOneGround(table, a, b))
            {
                ground.findImpact(table, a, b, motion, out);
                return;
            }
            if (isOneTree(table, a, b))
            {
                trees.findImpact(table, a, b, motion, out);
                return;
            }
            findTime(table, a, b, motion);
            if (out != null && motion.time != RelativeMotion.NEVER)
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
            if (isOneGround(table, a, b))
            {
                ground.findOuterContact(table, a, b, out);
                return;
            }
            if (isOneTree(table, a, b))
            {
                trees.findOuterContact(table, a, b, out);
                return;
            }
            RelativeMotion.NONE.time = 0;
            findContact(table, a, b, RelativeMotion.NONE, out);
        }

        /**
         * Whether the contact of two rows is exact: moved by its depth they just touch. Otherwise it is that of parts of the two, and others may
         * still overlap.
         */
        public function hasExactContact(table:AgentTable, a:int, b:int):Boolean
        {
            return (table.forms[a] | table.forms[b]) < ModelShape.TREE && (areSpheres(table, a, b) || structures.hasExactContact(table, a, b));
        }

        /** Begins to count the tests of a search. */
        public function resetCounts():void
        {
            sweptPairs = 0;
            structures.resetCounts();
            if (trees != null)
            {
                trees.resetCounts();
            }
        }

        /** Writes how many tests were made since <code>resetCounts()</code>. */
        public function writeCounts(out:SearchCounts):void
        {
            out.sweptPairs = sweptPairs;
            structures.writeCounts(out);
            if (trees != null)
            {
                trees.writeCounts(out);
            }
        }

        /** Whether two rows are spheres. */
        public static function areSpheres(table:AgentTable, a:int, b:int):Boolean
        {
            return (table.forms[a] | table.forms[b]) == BoundingStructure.SPHERE;
        }

        /**
         * Whether the second of two rows is taken for the first: the ground comes last, a tree before a structure, and of two trees or structures that of the agent
         * with the lower number. So rounding is the same in either order.
         */
        public static function isSecondFirst(table:AgentTable, a:int, b:int):Boolean
        {
            if (isOneGround(table, a, b))
            {
                return table.forms[a] == ModelShape.GROUND;
            }
            var isTree:Boolean = table.forms[a] == ModelShape.TREE;
            if (isTree != (table.forms[b] == ModelShape.TREE))
            {
                return !isTree;
            }
            return table.agents[a].number > table.agents[b].number;
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

        /** Whether at least one of two rows is a tree, and none the ground. */
        public static function isOneTree(table:AgentTable, a:int, b:int):Boolean
        {
            return ((table.forms[a] | table.forms[b]) & (ModelShape.TREE | ModelShape.GROUND)) == ModelShape.TREE;
        }

        /** Whether one of two rows is the ground. */
        public static function isOneGround(table:AgentTable, a:int, b:int):Boolean
        {
            return (table.forms[a] | table.forms[b]) >= ModelShape.GROUND;
        }

        private static function areSpheresTouching(table:AgentTable, a:int, b:int):Boolean
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
            reach = reach * Tolerances.TOUCHING + (table.marginOf(a) + table.marginOf(b));
            return squared <= reach * reach;
        }

        private function findTimeOfSpheres(table:AgentTable, a:int, b:int, motion:RelativeMotion):void
        {
            structures.tests[0]++;
            var extents:Extents = table.extents;
            _points.x = extents.x[a] - extents.x[b] + motion.startX;
            _points.y = extents.y[a] - extents.y[b] + motion.startY;
            _points.z = extents.z[a] - extents.z[b] + motion.startZ;
            // the motion's own rounding too
            _points.reach = (extents.halfX[a] + extents.halfX[b]) * Tolerances.TOUCHING + (table.marginOf(a) + table.marginOf(b))
                + Tolerances.ROUNDING * (Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
            _points.findEntry(motion);
            // rounding can miss a touch at the end of the motion
            if (motion.time == RelativeMotion.NEVER && areSpheresTouching(table, a, b))
            {
                motion.time = 1;
            }
        }

        private static function readSphere(extents:Extents, row:int, sphere:Sphere):void
        {
            var center:Vector3D = sphere.center;
            center.x = extents.x[row];
            center.y = extents.y[row];
            center.z = extents.z[row];
            sphere.radius = extents.halfX[row];
        }
    }
}
