# SPDX-License-Identifier: MIT
"""Messages about servers: their addresses, their protocols."""

from __future__ import annotations

from nctakt.messages.catalogue import error, note
from nctakt.messages.extras import install_command

ENDPOINT_ADDRESS_NOT_USABLE = error(
    901351,
    en="{endpoint} cannot listen on {host}, port {port}: {reason}",
    de="{endpoint} kann nicht an {host}, Port {port} lauschen: {reason}",
    remedy_en="End the program that uses the port, or name another port; port 0 takes a free one.",
    remedy_de="Das Programm am Port beenden oder einen anderen nennen; Port 0 nimmt einen freien.",
    endpoint=("the server", "der Server"),
    host=("the address", "die Adresse"),
)
INVALID_ENDPOINT_ADDRESS = error(
    901352,
    en="{option} needs an address as HOST:PORT, not {text}",
    de="{option} braucht eine Adresse der Form HOST:PORT, nicht {text}",
    remedy_en="Write it with an equals sign, {option}=127.0.0.1:0, and programs before it.",
    remedy_de="Mit Gleichheitszeichen schreiben, {option}=127.0.0.1:0, und Programme davor.",
)
NO_ENDPOINT = error(
    901353,
    en="nctakt serve needs at least one protocol for its clients",
    de="nctakt serve braucht mindestens ein Protokoll für seine Clients",
    remedy_en="Name one, for example --ads.",
    remedy_de="Eines nennen, zum Beispiel --ads.",
)
CONTROLLER_STOPPED = error(
    901354,
    en="the controller has stopped, so the servers end: {reason}",
    de="die Steuerung steht, deshalb enden die Server: {reason}",
    remedy_en="Start the command again; please report it if the reason is not yours.",
    remedy_de="Den Befehl neu starten; bitte melden, wenn der Grund nicht bei Ihnen liegt.",
)
CONTROLLER_SILENT = error(
    901507,
    en="the controller did not answer within {seconds} s at the end, so its process was killed",
    de="die Steuerung antwortete am Ende {seconds} s lang nicht, ihr Prozess wurde abgebrochen",
    remedy_en="Look for an endless loop or a wait in the PLC; the tape ends before it.",
    remedy_de="In der SPS nach einer Endlosschleife oder einem Warten suchen; das Band endet "
    "davor.",
    seconds=("the time", "die Zeit"),
)
INVALID_BROKER = error(
    901450,
    en="--mqtt needs a broker as mqtt://HOST[:PORT][/ROOT], not {text}",
    de="--mqtt braucht einen Broker der Form mqtt://HOST[:PORT][/WURZEL], nicht {text}",
    remedy_en="mqtts:// uses TLS; user and password come from {user} and {password}.",
    remedy_de="mqtts:// verwendet TLS; Benutzer und Passwort stehen in {user} und {password}.",
    text=("the text, without what may be secret", "der Text, ohne Geheimes"),
    user=("the environment variable of the user", "die Umgebungsvariable des Benutzers"),
    password=("that of the password", "die des Passworts"),
)
BROKER_NOT_REACHED = error(
    901451,
    en="the MQTT broker {broker} cannot be reached: {reason}",
    de="der MQTT-Broker {broker} ist nicht erreichbar: {reason}",
    remedy_en="Start the broker, or correct its address, user and password.",
    remedy_de="Den Broker starten oder Adresse, Benutzer und Passwort berichtigen.",
    broker=("the address of the broker", "die Adresse des Brokers"),
    reason=("the reason of the connection", "der Grund der Verbindung"),
)
MQTT_NOT_INSTALLED = error(
    901452,
    en="MQTT needs the package aiomqtt, which is not installed",
    de="MQTT braucht das Paket aiomqtt, das nicht installiert ist",
    remedy_en=f"Install it: {install_command('mqtt')}",
    remedy_de=f"Installieren: {install_command('mqtt')}",
)
INVALID_NETWORK = error(
    902020,
    en="{option}: {text} is neither an address nor a network",
    de="{option}: {text} ist weder eine Adresse noch ein Netz",
    remedy_en="Write an address, 192.168.0.7, or a network with zeros at its end, 192.168.0.0/24.",
    remedy_de="Eine Adresse schreiben, 192.168.0.7, oder ein Netz mit Nullen am Ende, "
    "192.168.0.0/24.",
)
ADS_NEEDS_SOURCES = error(
    902021,
    en="ADS at {host} can be reached from other computers, but nothing says who may connect",
    de="ADS an {host} ist von anderen Rechnern erreichbar, aber nichts legt fest, wer sich "
    "verbinden darf",
    remedy_en="Name addresses or networks: --ads-from 192.168.0.0/24; 0.0.0.0/0 is everybody.",
    remedy_de="Adressen oder Netze nennen: --ads-from 192.168.0.0/24; 0.0.0.0/0 sind alle.",
    cause_en="ADS has no passwords: anyone who connects can command the machine. Clients choose "
    "their NetId.",
    cause_de="ADS hat keine Passwörter: wer sich verbindet, kann der Maschine Befehle geben. Ihre "
    "NetId wählen Clients selbst.",
    host=("the address of the server", "die Adresse des Servers"),
)
WHO_COMMANDS = note(
    902022,
    en="{endpoint}: the machine can be commanded by {who}",
    de="{endpoint}: die Maschine steuern kann: {who}",
    endpoint=("the protocol", "das Protokoll"),
    who=("whoever is admitted", "wer zugelassen ist"),
)
INVALID_NET_ID = error(
    901476,
    en="{text} is not a NetId",
    de="{text} ist keine NetId",
    remedy_en="Write six numbers from 0 to 255 with points between them, such as 5.1.204.160.1.1.",
    remedy_de="Sechs Zahlen von 0 bis 255 mit Punkten dazwischen schreiben, etwa 5.1.204.160.1.1.",
)
PAGE_WITHOUT_PROGRAM = error(
    901477,
    en="--live shows a program, but none is named",
    de="--live zeigt ein Programm, aber keines ist angegeben",
    remedy_en="Name the program that the page shows.",
    remedy_de="Das Programm nennen, das die Seite zeigt.",
)
TOO_FEW_DESCRIPTORS = error(
    902041,
    en="the protocols may need {needed} file descriptors, and the system permits {limit}",
    de="die Protokolle können {needed} Dateideskriptoren brauchen, das System erlaubt {limit}",
    remedy_en="Permit more (ulimit -Hn {needed}), or serve fewer protocols.",
    remedy_de="Mehr erlauben (ulimit -Hn {needed}) oder weniger Protokolle bedienen.",
    needed=(
        "as many as all connections and files may take",
        "so viele wie alle Verbindungen und Dateien brauchen können",
    ),
    limit=("the hard limit of this process", "die harte Grenze dieses Prozesses"),
)
