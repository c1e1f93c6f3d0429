package evaluation.pairs
{
    import evaluation.literal.LiteralHierarchyNode;
    import evaluation.literal.cheapestWithin;
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.intersection.intersects;
    import starlogo.libraries.BoundingStructuresLibrary;
    import starlogo.models.Model;

    /** Random pairs of models in any orientation, and loops over them. Each method returns the number of pairs that collide. */
    public final class ModelPairs
    {
        /** The number of pairs. */
        public static const COUNT:int = 100;

        private static const SEED:uint = 47;
        private static const SPREAD:Number = 0.7;
        private static const DEPTH:int = 5;

        private var _random:RandomStructures = new RandomStructures(new SeededRandom(SEED));
        private var _models:Array;
        private var _first:Vector.<Model> = new Vector.<Model>();
        private var _second:Vector.<Model> = new Vector.<Model>();
        private var _turns:Vector.<Matrix3D> = new Vector.<Matrix3D>();
        private var _places:Vector.<Vector3D> = new Vector.<Vector3D>();

        /** Draws pairs. @param models the models; each is drawn equally often */
        public function ModelPairs(models:Array)
        {
            _models = models;
            for (var i:int = 0; i < COUNT; i++)
            {
                _first.push(models[i % models.length]);
                _second.push(models[int(i / models.length) % models.length]);
                for (var k:int = 0; k < 2; k++)
                {
                    var axes:Vector.<Vector3D> = _random.frame();
                    _turns.push(new Matrix3D(new <Number>[axes[0].x, axes[0].y, axes[0].z, 0, axes[1].x, axes[1].y, axes[1].z, 0,
                                    axes[2].x, axes[2].y, axes[2].z, 0, 0, 0, 0, 1]));
                    _places.push(_random.position(SPREAD));
                }
            }
        }

        /**
         * A loop over the models' structures: of the least volume, or with cheaper tests within a factor (thesis §7.4).
         *
         * @return <code>function():int</code>
         */
        public function structures(factor:Number):Function
        {
            var library:BoundingStructuresLibrary = new BoundingStructuresLibrary();
            library.keepAll = true;
            var chosen:Object = {};
            for each (var model:Model in _models)
            {
                library.add(model.name, model.vertices);
                chosen[model.name] = cheapestWithin([library.sphere(model.name), library.capsule(model.name), library.box(model.name)], factor);
            }
            var placed:Vector.<BoundingStructure> = new Vector.<BoundingStructure>();
            for (var i:int = 0; i < COUNT; i++)
            {
                placed.push(inWorld(chosen[_first[i].name], 2 * i), inWorld(chosen[_second[i].name], 2 * i + 1));
            }
            return function():int
            {
                var hits:int = 0;
                for (var k:int = 0; k < 2 * COUNT; k += 2)
                {
                    hits += intersects(placed[k], placed[k + 1]) ? 1 : 0;
                }
                return hits;
            };
        }

        /**
         * A loop over the models' trees down to a depth of five, with nodes of one kind (thesis §7.7).
         *
         * @param kind BoundingStructure.BOX, SPHERE or CAPSULE
         * @return <code>function():int</code>
         */
        public function trees(kind:int):Function
        {
            var roots:Object = {};
            for each (var model:Model in _models)
            {
                roots[model.name] = LiteralHierarchyNode.of(model.vertices);
            }
            return function():int
            {
                var hits:int = 0;
                for (var i:int = 0; i < COUNT; i++)
                {
                    hits += areMeeting(roots[_first[i].name], roots[_second[i].name], kind, 2 * i, 1) ? 1 : 0;
                }
                return hits;
            };
        }

        private function areMeeting(a:LiteralHierarchyNode, b:LiteralHierarchyNode, kind:int, at:int, depth:int):Boolean
        {
            if (!intersects(inWorld(a.ofKind(kind), at), inWorld(b.ofKind(kind), at + 1)))
            {
                return false;
            }
            if (depth == DEPTH || a.isLeaf && b.isLeaf)
            {
                return true;
            }
            for each (var partA:LiteralHierarchyNode in a.isLeaf ? [a] : [a.left, a.right])
            {
                for each (var partB:LiteralHierarchyNode in b.isLeaf ? [b] : [b.left, b.right])
                {
                    if (areMeeting(partA, partB, kind, at, depth + 1))
                    {
                        return true;
                    }
                }
            }
            return false;
        }

        private function inWorld(structure:BoundingStructure, at:int):BoundingStructure
        {
            var copy:BoundingStructure = structure.clone();
            copy.rotate(_turns[at]);
            copy.translate(_places[at]);
            return copy;
        }
    }
}
