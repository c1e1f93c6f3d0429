package starlogo.data
{
    import org.flexunit.asserts.assertEquals;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.BuiltInModel;
    import support.PointSets;
    import support.assertThrows;
    import support.landOf;

    public class HintOfNameTest
    {
        [Test]
        public function theCallersListKeepsItsOrder():void
        {
            var names:Vector.<String> = new <String>["Tree", "bear"];
            hintOfName("beer", names);
            assertEquals("Tree,bear", names.join());
        }

        [Test]
        public function theNamesAreTold():void
        {
            assertEquals(", which is empty", hintOfName("beer", new Vector.<String>()));
            assertEquals("; it has \"bear\", \"Tree\"", hintOfName("wolf", new <String>["Tree", "bear"]));
            assertEquals("; it has \"bear\", \"Tree\"", hintOfName("wolf", new <String>["Tree", "bear"], "beers"));
            assertEquals("; is new Agent(\"bear\", \"monsters\") meant? The model comes first", hintOfName("monsters", new <String>["bear"], "bear"));
            var names:Vector.<String> = new Vector.<String>();
            for (var i:int = 12; i > 0; i--)
            {
                names.push("m" + (100 + i));
            }
            assertEquals("; it has \"m101\", \"m102\", \"m103\", \"m104\", \"m105\", \"m106\", \"m107\", \"m108\", \"m109\", \"m110\" and 2 more", hintOfName("beer", names));
        }

        [Test]
        public function theNameThatIsProbablyMeantIsTold():void
        {
            assertEquals("; is \"bear\" meant?", hintOfName("beer", new <String>["Tree", "bear"]));
            assertEquals("; is \"kite\" meant?", hintOfName("kyte", new <String>["sphere", "kite"], "birds"));
        }

        [Test]
        public function anUnknownModelIsToldWithThoseThatThereAre():void
        {
            var greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube());
            assertEquals("cube,sphere", greatLand.modelNames.sort(Array.CASEINSENSITIVE).join());
            var collider:TightestFitCollider = new TightestFitCollider(greatLand);
            assertThrows(ArgumentError, /there is no model "beer"; add it to the GreatLand first; it has "cube", "sphere"$/,
                    collider.findCollisions, new <Agent>[new Agent("beer")]);
            greatLand.removeModel("cube");
            greatLand.boundingStructures.add("beer", PointSets.box(1, 1, 1));
            assertThrows(ArgumentError, /there is no model "beer"; add it to the GreatLand first; it has "sphere"$/,
                    collider.findCollisions, new <Agent>[new Agent("beer")]);
            assertEquals("sphere", greatLand.modelNames.join());
        }
    }
}
