package starlogo.search
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.broadphase.Bins;
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.intersection.boxBox;

    use namespace engine;

    /**
     * Tests two bodies by their forms: whether they touch, when they touch, and how. Each collider has one such object, with its settings.
     *
     * @private
     */
    public final class NarrowPhase
    {
        /** The number of pairs that were tested along their motions since <code>takeCounts()</code>. */
        public var sweptPairs:int = 0;

        /** Tests pairs of structures that are not both spheres. */
        public var structures:StructurePairTests = new StructurePairTests();

        /** Tests pairs of which at least one is a tree; null if the choice of shapes has no trees. */
        public var trees:TreePairTests = null;

        /** Tests pairs of a body and the ground. */
        public var ground:GroundPairTests;

        /** Tests pairs of spheres. */
        public var spheres:SpherePairTests = new SpherePairTests();

        private var _edges:EdgePairTests;

        /** @param choice gives the rows their shapes */
        public function NarrowPhase(choice:ShapeChoice)
        {
            ground = new GroundPairTests(this);
            _edges = new EdgePairTests(this);
            choice.prepare(this);
        }

        /**
         * Keeps the candidates that touch a member, and moves them to the beginning of the list. All rows must be spheres.
         *
         * @param slot the member's slot
         * @param others the slots of the candidates, whose circles on the ground overlap the member's circle
         * @param count the number of candidates
         * @return the number of candidates that it keeps
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
            spheres.tests += count;
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
                    // if the gap is not larger than rounding errors, the exact test decides
                    reach += slack;
                    if (squared > reach * reach)
                    {
                        continue;
                    }
                    if (!spheres.areTouching(table.bodyOf(bins.rowAt[slot]), table.bodyOf(bins.rowAt[other])))
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
         * Keeps the candidates that touch a row, and moves them to the beginning of the list.
         *
         * @param bins knows how far apart the extents of touching rows may be
         * @param rows the candidates are indices in this list of rows
         * @param others the candidates, whose circles on the ground overlap the row's circle
         * @param count the number of candidates
         * @return the number of candidates that it keeps
         */
        public function keepTouching(table:AgentTable, bins:Bins, row:int, rows:Vector.<int>, others:Vector.<int>, count:int):int
        {
            var forms:Vector.<int> = table.forms;
            var form:int = forms[row];
            if (form == ModelShape.TREE)
            {
                return trees.keepTouching(table, bins, row, rows, others, count);
            }
            var slack:Number = bins.slack;
            var xs:Vector.<Number> = table.extents.x;
            var ys:Vector.<Number> = table.extents.y;
            var zs:Vector.<Number> = table.extents.z;
            var halfZs:Vector.<Number> = table.extents.halfZ;
            var boxes:Vector.<Box> = table.boxes;
            var placed:Vector.<int> = table.placedRevisions;
            var revisions:Vector.<int> = table.now.revisions;
            var atX:Number = xs[row];
            var atY:Number = ys[row];
            var atZ:Number = zs[row];
            var reachZ:Number = halfZs[row] + slack;
            var box:Box = boxes[row];
            var body:Body = null;
            var boxTests:int = 0;
            var sphereTests:int = 0;
            var kept:int = 0;
            if (box != null && placed[row] != revisions[row])
            {
                table.placeBox(row);
            }
            for (var i:int = 0; i < count; i++)
            {
                // two boxes need no test of their extents, except for the heights
                var other:int = others[i];
                var otherRow:int = rows[other];
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
                        table.placeBox(otherRow);
                    }
                    if (!boxBox(box, otherBox))
                    {
                        continue;
                    }
                }
                else if ((form | forms[otherRow]) == BoundingStructure.SPHERE)
                {
                    sphereTests++;
                    var x:Number = xs[otherRow] - atX;
                    var y:Number = ys[otherRow] - atY;
                    var squared:Number = x * x + y * y + distance * distance;
                    reach = halfZs[row] + halfZs[otherRow];
                    if (squared > reach * reach)
                    {
                        // as in keepTouchingSpheres
                        reach += slack;
                        if (squared > reach * reach)
                        {
                            continue;
                        }
                        if (!spheres.areTouching(body ||= table.bodyOf(row), table.bodyOf(otherRow)))
                        {
                            continue;
                        }
                    }
                }
                else if (!areNear(table.extents, bins, row, otherRow) || !areTouching(body ||= table.bodyOf(row), table.bodyOf(otherRow)))
                {
                    continue;
                }
                others[kept] = other;
                kept++;
            }
            structures.tests[1 << BoundingStructure.BOX] += boxTests;
            spheres.tests += sphereTests;
            return kept;
        }

        /** Whether two bodies touch. */
        public function areTouching(a:Body, b:Body):Boolean
        {
            var forms:int = a.form | b.form;
            if (forms == BoundingStructure.SPHERE)
            {
                spheres.tests++;
                return spheres.areTouching(a, b);
            }
            if (forms < ModelShape.TREE)
            {
                return structures.areTouching(a, b);
            }
            if (a.form >= ModelShape.GROUND)
            {
                return b.form < ModelShape.GROUND && areTouching(b, a);
            }
            return testsOf(a, b).areTouching(a, b);
        }

        /** Writes the numbers of tests, and sets them to 0. */
        public function takeCounts(out:SearchCounts):void
        {
            out.sweptPairs = sweptPairs;
            structures.takeCounts(out);
            out.sphereSphereTests += spheres.tests;
            sweptPairs = spheres.tests = 0;
            if (trees != null)
            {
                trees.takeCounts(out);
            }
        }

        /**
         * Whether tests take the second of two bodies first, so that rounding errors are the same in either order. A tree comes before a
         * structure. Of two trees or two structures, the body of the agent that is first in the list comes first. The ground and the edges of the world come
         * last.
         */
        public static function isSecondFirst(a:Body, b:Body):Boolean
        {
            if (a.form >= ModelShape.GROUND || b.form >= ModelShape.GROUND)
            {
                return a.form >= ModelShape.GROUND;
            }
            var isTree:Boolean = a.form == ModelShape.TREE;
            if (isTree != (b.form == ModelShape.TREE))
            {
                return !isTree;
            }
            return a.order > b.order;
        }

        /**
         * Whether the extents of two rows overlap, or nearly do. The heights are compared first, because the bins have already compared the
         * circles on the ground.
         */
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

        /** The tests for two bodies, by their forms. The ground or the edges of the world are the second of the two. */
        public function testsOf(a:Body, b:Body):PairTests
        {
            var forms:int = a.form | b.form;
            if (forms >= ModelShape.GROUND)
            {
                return forms >= ModelShape.EDGES ? _edges : ground;
            }
            if (forms >= ModelShape.TREE)
            {
                return trees;
            }
            return forms == BoundingStructure.SPHERE ? spheres : structures;
        }
    }
}
